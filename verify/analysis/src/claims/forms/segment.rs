//! Section 4: the segment from g to g_h, what metrics along it have in common, and angles in a smooth metric.

use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::families::{mesh, near, smooth, squeezed};
use crate::finding::Finding;
use crate::local::frame_of;
use crate::pieces::euclidean_frame;
use crate::rule::Rule;
use crate::series::Series;
use nalgebra::DMatrix;
use regge_curvature::Error;
use regge_curvature::density::{Corner, outward};
use regge_curvature::field::Evaluate;
use regge_curvature::formulas::PAPER;
use regge_curvature::linalg::{Mat, Vector, inverse_and_det};
use regge_curvature::mesh::Mesh;
use regge_curvature::quadrature::Rule as Quadrature;
use regge_curvature::simplex::subsets;

/// eq. (gtbound) to (Lpequiv2).
pub const A04: Claim = Claim {
    label: "A04",
    paper: &["gtbound", "eigbound", "eiginvbound", "Lpequiv1", "Lpequiv2"],
    title: "Metrics along the segment are equivalent, with the best constants",
    statement: r"\lambda_{\min}(\tilde g(t)) \ge \min\big(\lambda_{\min}(g),\lambda_{\min}(g_h)\big),\quad
        \lambda_{\max}(\tilde g(t)) \le \max\big(\lambda_{\max}(g),\lambda_{\max}(g_h)\big),\quad
        |X|_{\tilde g(t_1)}^2 \le \mu\,|X|_{\tilde g(t_2)}^2,\ \mu = \max\big(\lambda_{\max}(g^{-1}g_h),\lambda_{\max}(g_h^{-1}g)\big)",
    how: "The greatest left over right side over points of the cells of random meshes and pairs t_1, t_2; attained at the ends of the \
        segment. From these pointwise constants all the others follow: μ bounds the volume forms' ratio by μ^{N/2}, that of (p, q)-tensors' \
        squares by μ^{p+q}. By level, ‖g̃‖ + ‖g̃⁻¹‖ and |g̃|_{W^{1,∞}} stay bounded.",
    measure: segment,
};

fn eigenvalues<const N: usize>(a: &Mat<f64, N>) -> [f64; 2] {
    let values = DMatrix::from_fn(N, N, |i, j| a[(i, j)]).symmetric_eigenvalues();
    [values.min(), values.max()]
}

/// The eigenvalues, least and greatest, of one metric relative to another.
fn relative<const N: usize>(a: &Mat<f64, N>, to: &Mat<f64, N>) -> Option<[f64; 2]> {
    let frame = frame_of(to)?;
    Some(eigenvalues(&(frame.transpose() * a * frame)))
}

/// The greatest ratios at a point: least eigenvalue, greatest eigenvalue, relative length.
fn ratios_at<const N: usize>(g: &Mat<f64, N>, g_h: &Mat<f64, N>) -> Option<[f64; 3]> {
    let times = [0.0, 0.25, 0.5, 0.75, 1.0];
    let at = |t: f64| g * (1.0 - t) + g_h * t;
    let ([low, high], [low_h, high_h]) = (eigenvalues(g), eigenvalues(g_h));
    let (there, back) = (relative(g_h, g)?, relative(g, g_h)?);
    let mu = there[1].max(back[1]);
    let mut all = [0.0_f64; 3];
    for one in times {
        let [least, most] = eigenvalues(&at(one));
        all[0] = all[0].max(low.min(low_h) / least);
        all[1] = all[1].max(most / high.max(high_h));
        for two in times {
            all[2] = all[2].max(relative(&at(one), &at(two))?[1] / mu);
        }
    }
    Some(all)
}

/// Pointwise ratios on a mesh, and the bounds of g_h there.
fn segment_on<const N: usize>(side: usize, seed: u64) -> Result<(f64, [f64; 6]), Error> {
    let mesh = mesh::<N>(side, seed)?;
    let h = mesh.mesh_size();
    let g = smooth(&mesh)?;
    let (g_h, rough) = (
        near(&g, 1, 0.04 * h, seed)?,
        near(&g, 1, 0.03 * h.sqrt(), seed)?,
    );
    let rule = Quadrature::new(N, 2);
    let table = Evaluate::<f64, N>::tabulate(&g, rule.points());
    let table_h = Evaluate::<f64, N>::tabulate(&g_h, rule.points());
    let (mut greatest, mut size) = ([0.0_f64; 3], 0.0_f64);
    for cell in 0..mesh.cell_count() {
        let (local, local_h) = (
            Evaluate::<f64, N>::on_cell(&g, cell),
            Evaluate::<f64, N>::on_cell(&g_h, cell),
        );
        let frame = euclidean_frame(&mesh, cell);
        for point in 0..rule.len() {
            let [g, g_h] = [
                g.value(&local, &table, point),
                g_h.value(&local_h, &table_h, point),
            ]
            .map(|g: Mat<f64, N>| frame.transpose() * g * frame);
            let indefinite = || Error::Solver("a metric is not positive definite".into());
            let here = ratios_at(&g, &g_h).ok_or_else(indefinite)?;
            greatest = std::array::from_fn(|i| greatest[i].max(here[i]));
            let [least, most] = eigenvalues(&g_h);
            size = size.max(most + 1.0 / least);
        }
    }
    let slope = |g_h: &_| Distance::new(&mesh, g_h, 4).sup(1, 0);
    let [a, b, c] = greatest;
    Ok((h, [a, b, c, size, slope(&g_h), slope(&rough)]))
}

/// What the eigenvalues bound: those of the inverse are reciprocals, and the Euclidean metric is one more to compare with.
const EIGENVALUES: &[&str] = &["gtbound", "eigbound", "eiginvbound", "Lpequiv2"];

fn segment(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, [least, most, length, size, slope, rough]: [Series; 6]| {
        let case = |what: &str| format!("N = {n}, {what}");
        let sharp = |what: &str, series| Finding::new(case(what), Rule::Sharp(1.0, 0.99), series);
        all.push(sharp("least eigenvalue", least).about(EIGENVALUES));
        all.push(sharp("greatest eigenvalue", most).about(EIGENVALUES));
        all.push(sharp("|X|² in two metrics", length).about(&["Lpequiv1"]));
        let size = Finding::new(case("‖g_h‖ + ‖g_h⁻¹‖"), Rule::Bounded, size);
        all.push(size.about(&["gtbound"]));
        let slope = Finding::new(case("|g_h| in W^{1,∞}"), Rule::Bounded, slope);
        let slope = slope.about(&["gtbound"]);
        all.push(slope.forge("noise of √h for h", rough));
    };
    add(
        2,
        effort.sweep(effort.levels(&[8, 16, 32, 64], 3), &segment_on::<2>)?,
    );
    if !effort.quick {
        add(3, effort.sweep(&[3, 4, 6, 8], &segment_on::<3>)?);
    }
    Ok(all)
}

/// The lemma after lemma:anglebound, which has no label.
pub const A19: Claim = Claim {
    label: "A19",
    paper: &[],
    title: "Dihedral angles in a smooth metric stay away from 0 and π",
    statement: r"\theta_{\min,g} \le \theta_{ST}(g) \le \theta_{\max,g}",
    how: "The greatest 1/sin θ over the hinges of random meshes, at their barycentres, by level. Forged: meshes that are squeezed by h \
        in one direction, which have no shape regularity. Angles by the library. Section 4, after lemma:anglebound.",
    measure: angles,
};

fn reciprocal_sine<const N: usize>(mesh: &Mesh<N>) -> Result<f64, Error> {
    let g = smooth(mesh)?;
    let barycentre = Quadrature::new(N - 2, 1);
    let mut greatest = 0.0_f64;
    for on in subsets(N + 1, N - 1) {
        let points = barycentre.points().embed(&on, N + 1);
        let table = Evaluate::<f64, N>::tabulate(&g, &points);
        let nu: Vec<Vector<f64, N>> = (0..=N).filter(|v| !on.contains(v)).map(outward).collect();
        for cell in 0..mesh.cell_count() {
            let local = Evaluate::<f64, N>::on_cell(&g, cell);
            let (inverse, det) = inverse_and_det(&Evaluate::<f64, N>::value(&g, &local, &table, 0));
            let (sin, cos) = Corner::new(&PAPER, &inverse, det, [&nu[0], &nu[1]]).dihedral();
            greatest = greatest.max(sin.hypot(cos) / sin);
        }
    }
    Ok(greatest)
}

fn angles_on<const N: usize>(side: usize, seed: u64) -> Result<(f64, [f64; 2]), Error> {
    let mesh = mesh::<N>(side, seed)?;
    let h = mesh.mesh_size();
    let flat = squeezed(&mesh, std::array::from_fn(|i| if i == 0 { h } else { 1.0 }))?;
    Ok((h, [reciprocal_sine(&mesh)?, reciprocal_sine(&flat)?]))
}

fn angles(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, [stated, flat]: [Series; 2]| {
        let finding = Finding::new(format!("N = {n}"), Rule::Bounded, stated);
        all.push(finding.forge("squeezed meshes", flat));
    };
    add(
        2,
        effort.sweep(effort.levels(&[8, 16, 32, 64, 128], 3), &angles_on::<2>)?,
    );
    if !effort.quick {
        add(3, effort.sweep(&[3, 6, 9, 12], &angles_on::<3>)?);
    }
    Ok(all)
}

//! Section 3: why the definition is what it is.

use crate::claim::{Claim, Effort};
use crate::families::torus;
use crate::finding::Finding;
use crate::measures::curvature_at;
use crate::mollified::{Quadrants, integral};
use crate::pieces::stretch;
use crate::represent::coefficients;
use crate::rule::Rule;
use crate::series::Series;
use num_dual::Dual64;
use regge_curvature::Error;
use regge_curvature::field::{Combination, Evaluate};
use regge_curvature::formulas::PAPER;
use regge_curvature::functional::{distributional_curvature, einstein};
use regge_curvature::jet::{Jet2, lower};
use regge_curvature::linalg::{Mat, Vector, symmetric};
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::{Metric, Smooth, SmoothTensor};
use regge_curvature::quadrature::Rule as Quadrature;
use regge_curvature::riemann::{Connection, Curvature};
use regge_curvature::scalar::Real;
use regge_curvature::spaces::{Lagrange, ReggeFunction, ReggeSpace};

/// The paragraph after def:distcurv.
pub const A32: Claim = Claim {
    label: "A32",
    paper: &["def:distcurv"],
    title: "The distributional curvature is the limit of the curvature of smooth metrics near g, N = 3",
    statement: r"\int_\Omega R(g_\varepsilon)\,v\,\omega(g_\varepsilon) \to \langle(R\omega)_{\rm dist}(g),v\rangle
        = \sum_T\int_TRv\,\omega+2\mathring{\sum_F}\int_F[\![H]\!]v\,\omega_F+2\mathring{\sum_S}\int_S\Theta_Sv\,\omega_S",
    how: "Section 3. Four metrics around an edge, one on each quadrant, with single-valued tangential-tangential components and jumps in \
        the others; g_ε blends them in layers of width 2ε. Left: the curvature of g_ε by jets, Gauss's rule in every layer. Right: the \
        library's functional on a mesh of 48 cells. Their difference is O(ε), relative to the right side. With metrics that are constant on each quadrant the right side \
        is that of the hinge alone; with changing ones faces and cells are there. Forged: without the jumps of H, \
        without the angle defects, with half of either.",
    measure: mollified,
};

/// A polynomial that vanishes on the boundary of (−1, 1)^N, of degree 2N + 1.
fn hump<const N: usize>(x: &[f64; N]) -> f64 {
    x.iter().map(|x| 1.0 - x * x).product::<f64>() * (1.0 + 0.3 * x[0] + 0.2 * x[1])
}

/// |left − right|/|right| by ε: as it is, and for the four forgeries.
fn against_layers<const N: usize>(
    effort: &Effort,
    is_constant: bool,
    widths: &[f64],
) -> Result<[Vec<(f64, f64)>; 5], Error> {
    let mesh = Mesh::<N>::cube(2)?;
    let space = Lagrange::new(&mesh, 2 * N + 1);
    let v = coefficients(&space, &|_, x| hump(x))?;
    let g = Quadrants::new(&mesh, is_constant)?;
    let three = distributional_curvature(&g, &space, &effort.rules(N, 20)).pair(&v);
    let total = three.total();
    let rights = [
        total,
        total - three.faces,
        total - three.hinges,
        total - 0.5 * three.faces,
        total - 0.5 * three.hinges,
    ];
    let mut all: [Vec<(f64, f64)>; 5] = Default::default();
    for &epsilon in widths {
        let left = integral::<N>(epsilon, is_constant, 12, &|g, x| {
            curvature_at(g, x) * hump(x)
        });
        for (list, right) in all.iter_mut().zip(rights) {
            list.push((epsilon, (left - right).abs() / total.abs()));
        }
    }
    Ok(all)
}

fn mollified(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let widths = effort.levels(&[0.2, 0.1, 0.05, 0.025, 0.0125], 3);
    let mut all = Vec::new();
    for (name, is_constant) in [("constant on quadrants", true), ("changing", false)] {
        let series = against_layers::<3>(effort, is_constant, widths)?;
        let [right, no_faces, no_hinges, half_faces, half_hinges] =
            series.map(|run| Series::over_width(&[run]));
        let case = format!("N = 3, {name}");
        let mut finding = Finding::new(case, Rule::Order(1.0), right)
            .forge("no angle defects", no_hinges)
            .forge("half of the angle defects", half_hinges);
        if !is_constant {
            finding = finding
                .forge("no jumps of H", no_faces)
                .forge("half of the jumps", half_faces);
        }
        all.push(finding);
    }
    Ok(all)
}

/// The last remark of section 3.2, without the paper's formula.
pub const A33: Claim = Claim {
    label: "A33",
    paper: &["sec:einstein"],
    title: "The linearised distributional Einstein tensor is the linearised Einstein tensor, as a distribution",
    statement: r"\frac{d}{dt}\Big|_0\langle(G\omega)_{\rm dist}(\delta+t\sigma),\varphi\rangle = \int\langle\sigma,\dot G(\varphi)\rangle,\qquad
        \dot G(\varphi)=\frac{d}{dt}\Big|_0G(\delta+t\varphi)\ \ \big(N=3:\ \text{half of}\ \operatorname{curl}\varphi\operatorname{curl},\text{ up to sign}\big)",
    how: "What Christiansen (2011, Theorem 2 and equations 25–26) shows for N = 3 and r = 0, and for N = 4 and r = 1, 2 as well. On tori of side 2, perturbed, \
        for random Regge functions σ of degree r and a smooth periodic φ. Left: the library's functional over dual numbers, angles and all; for \
        r = 0 hinges alone. Right: σ against second derivatives of φ, cell by cell, with Ġ by dual numbers: the definition of a derivative of a distribution, and no \
        formula of the paper. Relative to the sum of the absolute contributions of the cells. Forged: half of it, the other sign, σ of one cell changed.",
    measure: linearised,
};

/// A periodic symmetric tensor on ℝ^N/2ℤ^N.
struct Periodic;

impl<const N: usize> SmoothTensor<N> for Periodic {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        let wave =
            |y: S, phase: f64| (S::from_f64(std::f64::consts::PI) * y + S::from_f64(phase)).sin();
        symmetric(|i, j| {
            let phase = 0.7 * i as f64 + 0.4 * j as f64;
            wave(x[(i + 1) % N], phase) + wave(x[(j + 2) % N], phase + 0.3) + wave(x[j], phase)
        })
    }
}

/// Ġ(φ) at a point, from the jets of φ, in coordinates where the metric is δ.
fn linearised_einstein<const N: usize>(phi: &Mat<Jet2<f64, N>, N>) -> Mat<f64, N> {
    let dual = |x: f64| Dual64::new(0.0, x);
    let g: Mat<Jet2<Dual64, N>, N> = symmetric(|i, j| {
        let p = phi[(i, j)];
        Jet2 {
            value: Dual64::new(f64::from(u8::from(i == j)), p.value),
            d: p.d.map(dual),
            dd: p.dd.map(|row| row.map(dual)),
        }
    });
    let connection = Connection::new(&lower(&g));
    Curvature::new(&g, &connection)
        .einstein(&PAPER)
        .map(|x| x.eps)
}

// Sines of a third of a wave in a cell: the rules' errors fall below 10⁻⁶ of the values.
const fn order(n: usize) -> usize {
    if n == 3 { 12 } else { 10 }
}

/// The derivative of the library's functional at δ along σ, tested with φ.
fn derivative<const N: usize>(
    effort: &Effort,
    mesh: &Mesh<N>,
    sigma: &ReggeFunction<f64, N>,
) -> Result<f64, Error> {
    let flat = Smooth::new(mesh, Metric::Flat)?;
    let phi = Smooth::new(mesh, Periodic)?;
    let moving = Combination::new(Dual64::from(1.0), &flat, Dual64::new(0.0, 1.0), sigma);
    let still = Combination::new(Dual64::from(1.0), &phi, Dual64::from(0.0), &phi);
    let sums = einstein(&moving, &still, mesh, &effort.rules(N, order(N)));
    Ok(sums.total().eps)
}

/// ∫ ⟨σ, Ġ(φ)⟩, and the sum of the cells' absolute contributions.
fn paired<const N: usize>(
    mesh: &Mesh<N>,
    sigma: &ReggeFunction<f64, N>,
) -> Result<[f64; 2], Error> {
    let rule = Quadrature::new(N, order(N));
    let table = Evaluate::<f64, N>::tabulate(sigma, rule.points());
    let (mut right, mut size) = (0.0, 0.0);
    for cell in 0..mesh.cell_count() {
        let jacobian = mesh.jacobian(cell).ok_or(Error::NoCoordinates("a torus"))?;
        let inverse = jacobian.try_inverse().expect("cells are not flat");
        let local = Evaluate::<f64, N>::on_cell(sigma, cell);
        let origin = mesh
            .corner(cell, 0)
            .ok_or(Error::NoCoordinates("a torus"))?;
        let mut here = 0.0;
        for (point, weight) in rule.weights().iter().enumerate() {
            let lambda = rule.points().lambda(point);
            let xi = Vector::<f64, N>::from_fn(|i, _| lambda[i + 1]);
            let x = origin + jacobian * xi;
            let at = std::array::from_fn(|i| Jet2::coordinate(x[i], i));
            let g = linearised_einstein(&SmoothTensor::<N>::at(&Periodic, &at));
            let s = inverse.transpose() * sigma.value(&local, &table, point) * inverse;
            here += weight * s.dot(&g);
        }
        here *= stretch(mesh, cell);
        right += here;
        size += here.abs();
    }
    Ok([right, size])
}

/// The difference of both sides over the size: as it is, half of it, with the other sign, with another σ on the right.
fn residuals<const N: usize>(effort: &Effort, seed: u64, r: usize) -> Result<[f64; 4], Error> {
    let mesh = torus::<N>(3, seed)?;
    let space = ReggeSpace::new(&mesh, r);
    let mut random = SplitMix64::new(seed);
    let mut coefficients: Vec<f64> = (0..space.len()).map(|_| random.symmetric()).collect();
    let sigma = space.function(coefficients.clone())?;
    let (left, [right, size]) = (derivative(effort, &mesh, &sigma)?, paired(&mesh, &sigma)?);
    coefficients[0] += 1.0;
    let [changed, _] = paired(&mesh, &space.function(coefficients)?)?;
    let over = |x: f64| x.abs() / size;
    Ok([
        over(left - right),
        over(0.5 * left - right),
        over(left + right),
        over(left - changed),
    ])
}

fn linearised(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, r: usize, values: Vec<[f64; 4]>| {
        let series = |i: usize| Series::samples(values.iter().map(|v| v[i]).collect());
        let finding = Finding::new(format!("N = {n}, r = {r}"), Rule::AtMost(1e-6), series(0));
        let finding = finding
            .forge("half of it", series(1))
            .forge("the other sign", series(2));
        all.push(finding.forge("another σ", series(3)));
    };
    let seeds = effort.seeds();
    for r in 0..if effort.quick { 1 } else { 3 } {
        let values: Result<Vec<_>, Error> = seeds
            .iter()
            .map(|seed| residuals::<3>(effort, *seed, r))
            .collect();
        add(3, r, values?);
    }
    if !effort.quick {
        // One run: 1944 cells with a thousand points each.
        add(4, 0, vec![residuals::<4>(effort, effort.seed, 0)?]);
    }
    Ok(all)
}

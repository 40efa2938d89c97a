//! Section 4: jumps of Christoffel symbols and of second fundamental forms across faces.

use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::families::{mesh, near, smooth};
use crate::finding::Finding;
use crate::pieces::euclidean_frame;
use crate::rule::Rule;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::density::{Side, outward};
use regge_curvature::field::{Combination, Evaluate};
use regge_curvature::formulas::PAPER;
use regge_curvature::jet::Jet1;
use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::quadrature::Rule as Quadrature;
use regge_curvature::riemann::Connection;
use regge_curvature::simplex::subsets;

/// What a cell has on a face, on vectors tangent to it, in an orthonormal basis of ℝ^N: ∇n for the Euclidean unit normal n, and II‾.
fn of_side<const N: usize>(
    connection: &Connection<f64, N>,
    frame: &Mat<f64, N>,
    opposite: usize,
) -> [Mat<f64, N>; 2] {
    let nu: Vector<f64, N> = outward(opposite);
    let euclidean = frame.transpose() * nu;
    let normal = euclidean / euclidean.norm();
    let constant: Vector<Jet1<f64, N>, N> = (nu / euclidean.norm()).map(Jet1::constant);
    let gamma = connection.nabla_covector(&constant);
    let second = Side::new(&PAPER, connection, &nu.map(Jet1::<f64, N>::constant)).trace_reversed();
    let tangential = Mat::<f64, N>::identity() - normal * normal.transpose();
    [gamma, second].map(|form| tangential * frame.transpose() * form * frame * tangential)
}

/// At the barycentres of interior faces at t = 1/2: the greatest quotient of the jump of Γ and the sum of ‖g_h − g‖ of both cells in W^{1,∞},
/// the same with L^∞; and the greatest jump of II‾ over the greatest such sums.
fn jumps<const N: usize>(side: usize, seed: u64, r: usize) -> Result<(f64, [f64; 4]), Error> {
    let mesh = mesh::<N>(side, seed)?;
    let (h, g) = (mesh.mesh_size(), smooth(&mesh)?);
    let g_h = near(&g, r, 0.04 * if r == 0 { 1.0 } else { h }, seed)?;
    let middle = Combination::segment(&g, &g_h, 0.5);
    let distance = Distance::new(&mesh, &Combination::new(-1.0, &g, 1.0, &g_h), 2);
    let (barycentre, places) = (Quadrature::new(N - 1, 1), subsets(N + 1, N));
    let embed = |on: &Vec<usize>| {
        let points = barycentre.points().embed(on, N + 1);
        Evaluate::<f64, N>::tabulate(&middle, &points)
    };
    let tables: Vec<_> = places.iter().map(embed).collect();
    let (mut gamma, mut second, mut greatest) = ([0.0_f64; 2], 0.0_f64, [0.0_f64; 2]);
    for face in mesh.interior_faces() {
        let mut jump = [Mat::<f64, N>::zeros(); 2];
        let mut bounds = [0.0; 2];
        for side in mesh.star(N - 1, face) {
            let local = Evaluate::<f64, N>::on_cell(&middle, side.cell);
            let jets = Evaluate::<f64, N>::jet1(&middle, &local, &tables[side.place], 0);
            // The frame's coordinates are those of ℝ^N, the same on both sides.
            let frame = euclidean_frame(&mesh, side.cell);
            let here = of_side(&Connection::new(&jets), &frame, N - side.place);
            jump = [jump[0] + here[0], jump[1] + here[1]];
            let [values, slopes, _] = distance.cells[side.cell].sup;
            bounds = [bounds[0] + values + slopes, bounds[1] + values];
        }
        second = second.max(jump[1].norm());
        for i in 0..2 {
            gamma[i] = gamma[i].max(jump[0].norm() / bounds[i]);
            greatest[i] = greatest[i].max(bounds[i]);
        }
    }
    let [full, values] = greatest.map(|bound| second / bound);
    Ok((h, [gamma[0], gamma[1], full, values]))
}

/// The sides of the meshes for N = 2 and 3.
const SIDES: [[usize; 4]; 2] = [[16, 32, 64, 128], [6, 8, 12, 16]];

/// lemma:sffbound and remark:sffbound.
pub const A06: Claim = Claim {
    label: "A06",
    paper: &["lemma:sffbound", "remark:sffbound", "prop:ahbound"],
    title: "The jump of the second fundamental form, and the faces' part of a_h",
    statement: r"\|[\![\overline{II}(\tilde g)]\!]\|_{L^\infty(F)} \le C\sum_{i=1}^2\|g_h-g\|_{W^{1,\infty}(T_i)};\qquad
        r = 0:\ \le C\sum_{i=1}^2\|g_h-g\|_{L^\infty(T_i)}",
    how: "The greatest left over the greatest right side at the barycentres of interior faces, at t = 1/2, by level: for r = 1 with noise of h in \
        the coefficients, and for r = 0 with 4 % noise and the remark's right side. II‾ by the library. With the trace \
        inequality A12 for σ and for v on each face this is the lemma, whose prefactor has the h_T^{-1} of the two traces.",
    measure: second_form,
};

fn second_form(effort: &Effort) -> Result<Vec<Finding>, Error> {
    // For N = 2 the form vanishes: II‾ = II − H g = 0 on a curve.
    let mut all = Vec::new();
    let sides = effort.levels(&SIDES[1], 3);
    let [_, _, full, values] = effort.sweep(sides, &|side, seed| jumps::<3>(side, seed, 1))?;
    let linear = Finding::new("N = 3, r = 1", Rule::Bounded, full);
    let linear = linear.about(&["lemma:sffbound", "prop:ahbound"]);
    all.push(linear.forge("L^∞ for W^{1,∞}", values));
    let [_, _, _, values] = effort.sweep(sides, &|side, seed| jumps::<3>(side, seed, 0))?;
    let weaker = h_times(&values);
    let constant = Finding::new("N = 3, r = 0, the remark's bound", Rule::Bounded, values);
    let constant = constant.about(&["remark:sffbound"]);
    all.push(constant.forge("h ‖g_h − g‖ for ‖g_h − g‖", weaker));
    Ok(all)
}

/// A quotient whose denominator has a power of h more.
fn h_times(series: &Series) -> Series {
    let levels = &series.levels;
    let run = |run: &Vec<f64>| run.iter().zip(levels).map(|(x, level)| x * level).collect();
    Series {
        runs: series.runs.iter().map(run).collect(),
        ..series.clone()
    }
}

/// eq. (jumpGamma).
pub const A18: Claim = Claim {
    label: "A18",
    paper: &["jumpGamma"],
    title: "The jump of the Christoffel symbols across a face",
    statement: r"\big\|[\![\tilde\Gamma^N_{ij}]\!]\big\|_{L^\infty(F)}
        \le C\big(\|g_h-g\|_{W^{1,\infty}(T_1)} + \|g_h-g\|_{W^{1,\infty}(T_2)}\big)",
    how: "The greatest left over right side over the barycentres of interior faces of random meshes, at t = 1/2, by level, for g_h of \
        degree 1 with noise of h: Γ^N_ij is −(∇n)(e_i, e_j) for the Euclidean normal n, by the library's connection.",
    measure: christoffel,
};

fn christoffel(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, [stated, values, _, _]: [Series; 4]| {
        let finding = Finding::new(format!("N = {n}, r = 1"), Rule::Bounded, stated);
        all.push(finding.forge("L^∞ for W^{1,∞}", values));
    };
    let plane = effort.levels(&SIDES[0], 3);
    add(
        2,
        effort.sweep(plane, &|side, seed| jumps::<2>(side, seed, 1))?,
    );
    if !effort.quick {
        add(
            3,
            effort.sweep(&SIDES[1], &|side, seed| jumps::<3>(side, seed, 1))?,
        );
    }
    Ok(all)
}

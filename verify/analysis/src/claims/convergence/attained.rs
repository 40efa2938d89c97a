//! thm:conv is sharp: sequences that attain it.

use crate::bubble::{bubble, bubble_norm};
use crate::claim::{Claim, Effort};
use crate::errors::right_side;
use crate::families::near_by;
use crate::finding::Finding;
use crate::rule::Rule;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::functional::angle_defects;
use regge_curvature::linalg::Vector;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth};

/// Attaining sequences.
pub const A22: Claim = Claim {
    label: "A22",
    paper: &[
        "thm:conv",
        "thm:conv:part1",
        "thm:conv:part2",
        "convN2",
        "convN3",
    ],
    title: "The estimate of the error is attained, prefactor included, and for N = 3 the error need not converge",
    statement: r"g=\delta,\ r=0:\quad N=2,\ g_h-g\sim a\sqrt h:\ \|(R\omega)_{\rm dist}(g_h)\|_{H^{-2}}\sim a^2,\qquad
        N=3,\ g_h-g\sim ah:\ \|(R\omega)_{\rm dist}(g_h)\|_{H^{-2}}\sim a^2",
    how: "The squares of the edge lengths of δ times 1 + a A(x) h^s ξ, with ξ in a periodic pattern (three of them, at random) and A a \
        slowly varying amplitude: s = 1/2 for N = 2, s = 1 for N = 3. The left side from below by |f(v)|/‖v‖_{H²} for one fixed v \
        in H²_0, a polynomial, with the library's angle defects; for N = 3 v is taken from the midpoints of edges. The right sides are a²; the quotient of left and right side \
        neither grows nor falls by a power of h, so that they are attained; without the prefactor the quotient grows. The 1 in the \
        prefactor is left out: that makes the quotient larger, and the rest of the prefactor, which is of the order of h^{-1/2} and h^{-1}, \
        is not large yet on these meshes, so that with it the quotient would still be rising to its limit. And the error \
        itself does not converge, though g_h converges to g in L^∞: for N = 3 with the order of an optimal interpolant of degree 0.",
    measure: attained,
};

/// Left side, left over right side, and left over the right side without the prefactor.
fn attaining<const N: usize>(side: usize, seed: u64, a: f64) -> Result<(f64, [f64; 3]), Error> {
    let cube = Mesh::<N>::cube(side)?;
    let (g, h) = (Smooth::new(&cube, Metric::Flat)?, 2.0 / side as f64);
    let size = a * if N == 2 { h.sqrt() } else { h };
    let points = cube.points().ok_or(Error::NoCoordinates("a pattern"))?;
    let middle = |mesh: &Mesh<N>, (k, simplex): (usize, usize)| -> Vector<f64, N> {
        let vertices = mesh.vertices(k, simplex);
        vertices
            .iter()
            .map(|v| points[*v as usize])
            .sum::<Vector<f64, N>>()
            / vertices.len() as f64
    };
    let slowly = |mesh: &Mesh<N>, edge: (usize, usize)| {
        let x = middle(mesh, edge);
        size * (1.0 + 0.5 * x[0] - 0.3 * x[1]) / 1.8
    };
    let g_h = near_by(&g, 0, &slowly, seed)?;
    let at = |hinge| bubble::<f64, N>(&middle(&cube, (N - 2, hinge)).into());
    let defects = angle_defects(&g_h, &cube, 1);
    let value: f64 = defects
        .iter()
        .map(|s| 2.0 * s.defect * s.size * at(s.hinge))
        .sum();
    let left = value.abs() / bubble_norm::<N>();
    let [prefactor, norm] = right_side(&g, &g_h);
    // Without the 1 in the prefactor.
    let growing = prefactor - 1.0;
    Ok((h, [left, left / (growing * norm), left / norm]))
}

fn attained(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, [left, ratio, without]: [Series; 3]| {
        let case = |what: &str| format!("N = {n}, {what}");
        let about = |finding: Finding| match n {
            2 => finding.about(&["thm:conv", "thm:conv:part1", "convN2"]),
            _ => finding.about(&["thm:conv", "thm:conv:part2", "convN3"]),
        };
        let above = case("left over right side does not grow");
        let bounded = Finding::new(above, Rule::Bounded, ratio.clone());
        all.push(about(bounded.forge("no prefactor", without)));
        let below = case("left over right side does not fall");
        all.push(about(Finding::new(below, Rule::Stalls(0.3), ratio)));
        let error = Finding::new(case("the error itself"), Rule::Stalls(0.3), left);
        all.push(about(error.forge_claim("it converges", Rule::Order(0.5))));
    };
    // Coarser meshes are left out of a quick run: the linear part has not died down there.
    let sides = [16, 32, 64, 128, 256];
    let sides = if effort.quick { &sides[2..] } else { &sides };
    add(
        2,
        effort.sweep(sides, &|side, seed| attaining::<2>(side, seed, 0.5))?,
    );
    if !effort.quick {
        add(
            3,
            effort.sweep(&[4, 8, 16, 24], &|side, seed| {
                attaining::<3>(side, seed, 0.4)
            })?,
        );
    }
    Ok(all)
}

//! The first of the earlier results: the curvature of the geodesic interpolant as a measure.

use crate::claim::{Claim, Effort};
use crate::families::{mesh, smooth};
use crate::finding::Finding;
use crate::measures::{Body, curvature_at};
use crate::rule::Rule;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::functional::angle_defects;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::linalg::Vector;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};

/// Cheeger, Müller and Schrader.
pub const A25: Claim = Claim {
    label: "A25",
    paper: &["sec:intro"],
    title: "Earlier results: the curvature of the geodesic interpolant as a measure (Cheeger, Müller and Schrader)",
    statement: r"r=0,\ g_h\ \text{geodesic}:\quad |(R\omega)_{\rm dist}(g_h)(U)-(R\omega)(g)(U)| = O(h)\ (N=2),\quad O(h^{1/2})\ (N\ge3)",
    how: "Introduction, first result. The difference for eighty fixed sets U, boxes and balls: 2 Σ Θ_S |S ∩ U| from \
        the library's angle defects, each hinge by its part in U, against ∫_U R ω by Gauss's rule; the root of the mean of its squares, since the greatest \
        of a few is by how the boundaries of a few sets happen to lie in the mesh. Forged: an order and a half more.",
    measure: measures,
};

/// The root of the mean square of the differences for the sets.
fn distance<const N: usize>(
    g: &Smooth<Metric, N>,
    g_h: &ReggeFunction<f64, N>,
    bodies: &[(Body<N>, f64)],
) -> Result<f64, Error> {
    let mesh: &Mesh<N> = g.mesh();
    let points = mesh.points().ok_or(Error::NoCoordinates("a measure"))?;
    let defects = angle_defects(g_h, mesh, 1);
    let difference = |(body, exact): &(Body<N>, f64)| {
        let part = |s: &regge_curvature::functional::HingeDefect| {
            let vertices = mesh.vertices(N - 2, s.hinge).iter();
            let ends: Vec<Vector<f64, N>> = vertices.map(|v| points[*v as usize]).collect();
            2.0 * s.defect * s.size * body.share(&ends)
        };
        (defects.iter().map(part).sum::<f64>() - exact).powi(2)
    };
    let sum: f64 = bodies.iter().map(difference).sum();
    Ok((sum / bodies.len() as f64).sqrt())
}

fn on_sets<const N: usize>(side: usize, seed: u64) -> Result<(f64, [f64; 1]), Error> {
    let mesh = mesh::<N>(side, seed)?;
    let g = smooth(&mesh)?;
    let measured = |body: Body<N>| (body, body.integral(&|x| curvature_at(g.formula(), x)));
    let bodies: Vec<_> = Body::some(40).into_iter().map(measured).collect();
    let geodesic = Interpolant::geodesic().apply(&ReggeSpace::new(&mesh, 0), &g)?;
    Ok((mesh.mesh_size(), [distance(&g, &geodesic, &bodies)?]))
}

fn measures(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    if effort.quick {
        return Ok(all);
    }
    let mut add = |n: usize, order: f64, [geodesic]: [Series; 1]| {
        let finding = Finding::new(format!("N = {n}"), Rule::Order(order), geodesic);
        all.push(finding.forge_claim("an order and a half more", Rule::Order(order + 1.5)));
    };
    add(2, 1.0, effort.sweep(&[8, 16, 32, 64], &on_sets::<2>)?);
    add(3, 0.5, effort.sweep(&[6, 8, 10], &on_sets::<3>)?);
    Ok(all)
}

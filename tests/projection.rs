//! R_h, the L² projection of the curvature in the metric g_h.

use regge_curvature::field::Evaluate;
use regge_curvature::functional::integrate;
use regge_curvature::linalg::inverse_and_det;
use regge_curvature::project::{Projection, Tested};
use regge_curvature::quadrature::Rule;
use regge_curvature::{
    Interpolant, Lagrange, Mesh, Metric, ReggeSpace, Rules, Smooth, distributional_curvature,
};

/// A function of the space is its own projection: ∫ u v ω for all v gives u back.
fn reproduces<const N: usize>(degree: usize, tested: Tested) {
    let mesh = Mesh::<N>::cube(2).unwrap().perturbed(0.05, 3).unwrap();
    let (space, regge) = (Lagrange::new(&mesh, degree), ReggeSpace::new(&mesh, 1));
    let smooth = Smooth::new(&mesh, Metric::Trig).unwrap();
    let g = Interpolant::canonical()
        .with_order(8)
        .apply(&regge, &smooth)
        .unwrap();
    let rule = Rule::new(N, 2 * degree + 4);
    let kept = |dof: usize| tested == Tested::All || space.vanishes_on_boundary(dof);
    let value = |dof: usize| if kept(dof) { (dof as f64).sin() } else { 0.0 };
    let u: Vec<f64> = (0..space.len()).map(value).collect();
    let basis = space.basis(N).tabulate::<f64>(rule.points());
    let table = Evaluate::<f64, N>::tabulate(&g, rule.points());
    let load = integrate(&space, N, &rule, 0..mesh.cell_count(), |cell, _, q| {
        let local = Evaluate::<f64, N>::on_cell(&g, cell);
        let (_, det) = inverse_and_det(&g.value(&local, &table, q));
        let mine = space.cell_dofs(cell).zip(&basis[q]);
        mine.map(|(dof, b)| u[dof] * b).sum::<f64>() * det.sqrt()
    });
    let projection = Projection::new(&g, &space, tested, &rule).unwrap();
    for (a, b) in projection.apply(&load).unwrap().iter().zip(&u) {
        // The mass matrix in Bernstein's basis of degree 3 has a condition number of some 10³.
        assert!((a - b).abs() < 1e-10, "{a} {b}");
    }
}

#[test]
fn a_function_of_the_space_is_its_own_projection() {
    reproduces::<2>(1, Tested::All);
    reproduces::<2>(3, Tested::Interior);
    reproduces::<3>(2, Tested::Interior);
}

/// On the unit sphere R = 2, and R_h of a metric of degree 2 is near it away from the boundary, where it is 0.
#[test]
fn the_projected_curvature_of_a_sphere_is_near_two() {
    let mesh = Mesh::<2>::cube(8).unwrap();
    let (space, regge) = (Lagrange::new(&mesh, 2), ReggeSpace::new(&mesh, 2));
    let smooth = Smooth::new(&mesh, Metric::Sphere).unwrap();
    let g = Interpolant::canonical()
        .with_order(10)
        .apply(&regge, &smooth)
        .unwrap();
    let rules = Rules::new(2, 12);
    let load = distributional_curvature(&g, &space, &rules).total();
    let projection = Projection::new(&g, &space, Tested::Interior, &rules.cells).unwrap();
    let r_h = projection.apply(&load).unwrap();
    let middle = r_h[mesh.count(0) / 2];
    assert!((middle - 2.0).abs() < 0.05, "{middle}");
}

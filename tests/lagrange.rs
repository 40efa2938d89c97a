//! Lagrange spaces: numbering, traces, continuity.

use crate::common::crooked_cube;
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::subsets;
use regge_curvature::spaces::Lagrange;

/// A function with random coefficients has one value at a point of a k-simplex, whatever cell or trace gives it.
fn single_valued<const N: usize>(mesh: &Mesh<N>, degree: usize) {
    let space = Lagrange::new(mesh, degree);
    let mut random = SplitMix64::new(3);
    let c: Vec<f64> = (0..space.len()).map(|_| random.symmetric()).collect();
    let basis = space.basis(N);
    for k in 0..N {
        let rule = Rule::new(k, 3);
        let places = subsets(N + 1, k + 1);
        for simplex in 0..mesh.count(k) {
            for q in 0..rule.len() {
                let mut seen = Vec::new();
                for side in mesh.star(k, simplex) {
                    let on = &places[side.place];
                    let points = rule.points().embed(on, N + 1);
                    let cell = space.cell_dofs(side.cell).enumerate();
                    seen.push(
                        cell.map(|(a, d)| c[d] * basis.value(a, points.lambda(q)))
                            .sum::<f64>(),
                    );
                    let slots = space.trace_slots(on);
                    let trace = space.dofs(side.cell, &slots).enumerate();
                    let on_k = space.basis(k);
                    let lambda = rule.points().lambda(q);
                    seen.push(trace.map(|(a, d)| c[d] * on_k.value(a, lambda)).sum());
                }
                for value in &seen {
                    assert!(
                        (value - seen[0]).abs() < 1e-14,
                        "N = {N}, q = {degree}, k = {k}: {seen:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn functions_are_single_valued() {
    for degree in 1..=6 {
        single_valued(&crooked_cube::<2>(2, 1), degree);
        single_valued(&crooked_cube::<3>(1, 1), degree);
    }
    single_valued(&Mesh::<4>::simplex_boundary().expect("a sphere"), 5);
    single_valued(&Mesh::<3>::torus(3).expect("a torus"), 4);
}

/// The dimension on ∂Δ^{N+1} and that of P_q on a simplex.
#[test]
fn dimensions() {
    let single = Mesh::<3>::single().expect("a simplex");
    assert_eq!(
        [1, 2, 3, 4].map(|q| Lagrange::new(&single, q).len()),
        [4, 10, 20, 35]
    );
    let square = Mesh::<2>::cube(2).expect("a square");
    let space = Lagrange::new(&square, 3);
    assert_eq!(space.len(), 49);
    assert_eq!(
        (0..space.len())
            .filter(|&d| space.vanishes_on_boundary(d))
            .count(),
        25
    );
}

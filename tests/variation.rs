//! b_h − a_h is the derivative of the curvature, on the boundary too, and its transpose is its transpose.

use crate::common::{crooked_cube, largest, random_regge};
use num_dual::Dual64;
use regge_curvature::field::Combination;
use regge_curvature::functional::{boundary_curvature, variation, variation_adjoint};
use regge_curvature::{Lagrange, ReggeSpace, Rules, distributional_curvature};

/// d/dt of the curvature at g + tσ by dual numbers, for every v.
fn by_dual_numbers<const N: usize>(
    g: &regge_curvature::ReggeFunction<f64, N>,
    sigma: &regge_curvature::ReggeFunction<f64, N>,
    tests: &Lagrange<N>,
    boundary: bool,
    rules: &Rules,
) -> Vec<f64> {
    let moving = Combination::new(Dual64::from(1.0), g, Dual64::new(0.0, 1.0), sigma);
    let mut rate: Vec<f64> = (distributional_curvature(&moving, tests, rules)
        .total()
        .iter())
    .map(|x| x.eps)
    .collect();
    if boundary {
        let outer = boundary_curvature(&moving, tests, rules).total();
        rate.iter_mut().zip(outer).for_each(|(r, x)| *r += x.eps);
    }
    rate
}

fn check<const N: usize>(degree: usize, test_degree: usize, order: usize, tolerance: f64) {
    let mesh = crooked_cube::<N>(2, 5);
    let space = ReggeSpace::new(&mesh, degree);
    let (g, sigma) = (random_regge(&space, 0.02, 1), random_regge(&space, 1.0, 2));
    let tests = Lagrange::new(&mesh, test_degree);
    let rules = Rules::new(N, order);
    for boundary in [false, true] {
        let rate = variation(&g, &sigma, &tests, boundary, &rules).total();
        let known = by_dual_numbers(&g, &sigma, &tests, boundary, &rules);
        let scale = largest(&known);
        let tested = |dof: &usize| boundary || tests.vanishes_on_boundary(*dof);
        for dof in (0..tests.len()).filter(tested) {
            let off = (rate[dof] - known[dof]).abs();
            assert!(
                off < tolerance * scale,
                "N = {N}, r = {degree}, {boundary}: {dof}: {off:e} of {scale:e}"
            );
        }
        // The sign of every term counts: without those of the boundary the theorem fails there.
        let outside = (0..tests.len()).filter(|dof| !tests.vanishes_on_boundary(*dof));
        let off = outside.map(|dof| (rate[dof] - known[dof]).abs());
        assert_eq!(off.fold(0.0, f64::max) < tolerance * scale, boundary);
        // Σ_j w_j J σ_j = Σ_i σ_i (Jᵀ w)_i, the same products in another order.
        let weights: Vec<f64> = (0..tests.len()).map(|i| (1.3 * i as f64).sin()).collect();
        let adjoint = variation_adjoint(&g, &weights, &tests, &space, boundary, &rules).total();
        let one: f64 = rate.iter().zip(&weights).map(|(j, w)| j * w).sum();
        let terms: Vec<f64> = (adjoint.iter().zip(sigma.coefficients()))
            .map(|(a, c)| a * c)
            .collect();
        let size: f64 = terms.iter().map(|x| x.abs()).sum();
        let off = (terms.iter().sum::<f64>() - one).abs();
        assert!(off < 1e-13 * size, "{off:e} of {size:e}");
    }
}

/// Of degree 0 everything is integrated exactly.
#[test]
fn lengths() {
    check::<2>(0, 1, 1, 1e-12);
    check::<2>(0, 3, 3, 1e-12);
    check::<3>(0, 2, 2, 1e-12);
}

/// The theorem integrates by parts, and the rules are not exact: 1e-9 of the largest at these orders.
#[test]
fn polynomials() {
    check::<2>(1, 2, 24, 1e-8);
    check::<2>(2, 1, 24, 1e-8);
    check::<3>(1, 1, 16, 1e-7);
}

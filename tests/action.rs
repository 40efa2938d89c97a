//! Boundary terms, Regge's action and equations, the Einstein tensor against all Regge functions.

use crate::common::{bulging_cube, crooked_cube, dense, random_regge};
use approx::abs_diff_eq;
use num_dual::Dual64;
use regge_curvature::field::Combination;
use regge_curvature::functional::{
    Rules, action_gradient, action_hessian, boundary_curvature, distributional_curvature, einstein,
    einstein_against, regge_action,
};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::spaces::{BasisFunction, Lagrange, ReggeSpace};
use std::f64::consts::PI;

/// Rounding: sums of some 10² terms of size 1.
const ROUNDING: f64 = 1e-11;

/// Gauss and Bonnet on a square: ∫R + 2∫⟦H⟧ + 2ΣΘ with the boundary terms is 4πχ = 4π, for every Regge metric.
#[test]
fn the_total_with_the_boundary_is_four_pi_chi() {
    let mesh = Mesh::<2>::cube(3).unwrap().perturbed(0.1, 5).unwrap();
    let hats = Lagrange::new(&mesh, 1);
    for (degree, order) in [(0, 2), (1, 24), (2, 24)] {
        let space = ReggeSpace::new(&mesh, degree);
        let smooth = Smooth::new(&mesh, Metric::Trig).unwrap();
        let g = Interpolant::canonical()
            .with_order(12)
            .apply(&space, &smooth);
        let g = g.unwrap();
        let rules = Rules::new(2, order);
        let inner: f64 = distributional_curvature(&g, &hats, &rules)
            .total()
            .iter()
            .sum();
        let outer: f64 = boundary_curvature(&g, &hats, &rules).total().iter().sum();
        // The rules of order 24 integrate these metrics to some 1e-13.
        assert!(
            (inner + outer - 4.0 * PI).abs() < ROUNDING,
            "degree {degree}"
        );
        assert!((inner - 4.0 * PI).abs() > 0.1, "the boundary matters");
    }
}

/// A cube in Euclidean space: eight corners do not count for N = 3, twelve edges turn by π/2 and are 2 long.
#[test]
fn a_flat_cube_has_the_action_of_its_edges() {
    let mesh = Mesh::<3>::cube(2).unwrap();
    let space = ReggeSpace::new(&mesh, 0);
    let flat = Smooth::new(&mesh, Metric::Flat).unwrap();
    let g = Interpolant::canonical()
        .with_order(2)
        .apply(&space, &flat)
        .unwrap();
    let action = regge_action(&g, &mesh, &Rules::new(3, 2));
    assert!(action.interior.abs() < ROUNDING);
    assert!((action.boundary - 12.0 * 2.0 * PI / 2.0).abs() < ROUNDING);
    let all = action_gradient(&g).unwrap();
    for edge in mesh.interior(1) {
        assert!(
            all.gradient[edge].abs() < ROUNDING,
            "flat space is stationary"
        );
    }
}

/// All at once is what one by one gives, cells, faces and hinges apart.
fn against_all<const N: usize>(mesh: &Mesh<N>, degree: usize) {
    let space = ReggeSpace::new(mesh, degree);
    let g = random_regge(&space, 0.02, 3);
    let rules = Rules::new(N, 4);
    let all = einstein_against(&g, &space, &rules);
    let scale = all.total().iter().fold(0.0f64, |m, x| m.max(x.abs()));
    // Far above rounding: these metrics are curved.
    assert!(scale > 1e-4, "{scale}");
    for i in 0..space.len() {
        let one = einstein(&g, &BasisFunction::new(&space, i), mesh, &rules);
        let off = ROUNDING * scale.max(1.0);
        assert!(
            abs_diff_eq!(all.of(i), one, epsilon = off),
            "{i}: {:?} {one:?}",
            all.of(i)
        );
    }
}

#[test]
fn the_einstein_tensor_against_all_functions_is_that_against_each() {
    against_all(&crooked_cube::<3>(2, 7), 0);
    against_all(&crooked_cube::<3>(2, 7), 1);
    against_all(&Mesh::<4>::alfeld().unwrap(), 0);
}

/// Regge's gradient is the derivative of the whole action, angles included, which Schläfli's identity makes possible;
/// at interior edges it is −½⟨Gω, ∂g/∂ℓ⟩.
fn gradient_is_the_derivative<const N: usize>(mesh: &Mesh<N>) {
    let space = ReggeSpace::new(mesh, 0);
    let g = random_regge(&space, 0.02, 5);
    let rules = Rules::new(N, 2);
    let all = action_gradient(&g).unwrap();
    let einstein = einstein_against(&g, &space, &rules).total();
    assert!(all.schlaefli < ROUNDING, "{}", all.schlaefli);
    for edge in 0..mesh.count(1) {
        let slope = 2.0 * g.coefficients()[edge].sqrt();
        let direction = BasisFunction::new(&space, edge);
        let moving = Combination::new(Dual64::from(1.0), &g, Dual64::new(0.0, slope), direction);
        let action = regge_action(&moving, mesh, &rules).total();
        let (whole, regge) = (action.eps, all.gradient[edge]);
        assert!((whole - regge).abs() < ROUNDING, "{edge}: {whole} {regge}");
        if mesh.is_interior(1, edge) {
            let weak = -0.5 * slope * einstein[edge];
            assert!((weak - regge).abs() < ROUNDING, "{edge}: {weak} {regge}");
        }
    }
    assert!(mesh.interior(1).any(|edge| all.gradient[edge].abs() > 1e-3));
}

#[test]
fn regges_gradient_is_the_derivative_of_the_action() {
    gradient_is_the_derivative(&crooked_cube::<3>(2, 7));
    gradient_is_the_derivative(&Mesh::<4>::alfeld().unwrap());
}

/// The whole action is homogeneous of degree N−2 in the lengths: Σ ℓ ∂S/∂ℓ = (N−2) S (Euler), for any lengths.
fn gradient_obeys_euler<const N: usize>(mesh: &Mesh<N>) {
    let space = ReggeSpace::new(mesh, 0);
    let g = random_regge(&space, 0.02, 6);
    let action = regge_action(&g, mesh, &Rules::new(N, 1)).total();
    let gradient = action_gradient(&g).unwrap().gradient;
    let squares = g.coefficients().iter();
    let paired: f64 = (squares.zip(&gradient)).map(|(q, d)| q.sqrt() * d).sum();
    let expected = (N as f64 - 2.0) * action;
    assert!(
        (paired - expected).abs() < ROUNDING,
        "N = {N}: {paired} {expected}"
    );
    assert!(expected.abs() > 1e-3, "{expected}");
}

#[test]
fn the_action_is_homogeneous() {
    gradient_obeys_euler(&crooked_cube::<3>(2, 7));
    gradient_obeys_euler(&Mesh::<4>::alfeld().unwrap());
    gradient_obeys_euler(&Mesh::<5>::alfeld().unwrap());
    // As many triangles as tetrahedra has that one; this one has not.
    gradient_obeys_euler(&Mesh::<5>::single().unwrap());
}

/// The Hessian is symmetric, differentiates the gradient (a central difference agrees to its own accuracy), and at a
/// flat metric vanishes on the moves of the inner vertices, N each, if the boundary is rigid to first order.
fn hessian_is_the_second_derivative<const N: usize>(mesh: &Mesh<N>) {
    let space = ReggeSpace::new(mesh, 0);
    let g = random_regge(&space, 0.02, 5);
    let hessian = dense(mesh, &action_hessian(&g).unwrap());
    let (size, odd) = (hessian.amax(), (&hessian - hessian.transpose()).amax());
    assert!(odd < ROUNDING * size, "{odd} of {size}");
    for edge in (0..mesh.count(1)).step_by(7) {
        // Errors h² and rounding/h, of second derivatives of size 10: some 1e-9 for h = 1e-5, more on slivers.
        let h = 1e-5;
        let shifted = |h: f64| {
            let mut squares = g.coefficients().to_vec();
            squares[edge] = (squares[edge].sqrt() + h).powi(2);
            action_gradient(&space.function(squares).unwrap())
                .unwrap()
                .gradient
        };
        let (up, down) = (shifted(h), shifted(-h));
        for other in 0..mesh.count(1) {
            let difference = (up[other] - down[other]) / (2.0 * h);
            let error = (difference - hessian[(other, edge)]).abs();
            assert!(
                error < 1e-7 * size,
                "N = {N}, {edge}, {other}: {error:e} of {size}"
            );
        }
    }
    let flat = Smooth::new(mesh, Metric::Flat).unwrap();
    let g = Interpolant::canonical()
        .with_order(2)
        .apply(&space, &flat)
        .unwrap();
    let hessian = dense(mesh, &action_hessian(&g).unwrap());
    let inner: Vec<usize> = mesh.interior(1).collect();
    let inner = hessian.select_rows(&inner).select_columns(&inner);
    let values = inner.symmetric_eigen().eigenvalues;
    let kernel = values.iter().filter(|x| x.abs() < 1e-9).count();
    assert_eq!(kernel, N * mesh.interior(0).count());
}

#[test]
fn the_hessian_of_the_action_has_the_kernel_of_flat_space() {
    hessian_is_the_second_derivative(&bulging_cube::<3>(2, 7));
    hessian_is_the_second_derivative(&Mesh::<4>::alfeld().unwrap());
}

/// The variables must be lengths.
#[test]
fn higher_degrees_have_no_gradient_in_lengths() {
    let mesh = Mesh::<3>::cube(1).unwrap();
    let space = ReggeSpace::new(&mesh, 1);
    let flat = Smooth::new(&mesh, Metric::Flat).unwrap();
    let g = Interpolant::canonical()
        .with_order(4)
        .apply(&space, &flat)
        .unwrap();
    assert!(action_gradient(&g).is_err());
}

//! The H⁻² norm against an independent dense discretisation, exact solutions, and its own invariances.
#![cfg(feature = "norms")]

#[path = "norm/dense.rs"]
mod dense;
#[path = "norm/plate.rs"]
mod plate;

use plate::{load_of, plate_bilaplacian};
use regge::mesh::{Mesh, SplitMix64};
use regge::norm::{HMinus2, HMinus2Norm};

/// A load that is as good as any: seeded random numbers.
fn random_load(len: usize, seed: u64) -> Vec<f64> {
    let mut random = SplitMix64::new(seed);
    (0..len).map(|_| random.symmetric()).collect()
}

fn perturbed<const N: usize>(level: u32, seed: u64) -> Mesh<N> {
    Mesh::cube(1 << level).unwrap().perturbed_as_in_paper(level, seed).unwrap()
}

/// max |a − b| over max |b|; 0 where both vanish.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let size = b.iter().fold(f64::MIN_POSITIVE, |m: f64, x| m.max(x.abs()));
    a.iter().zip(b).fold(0.0, |m: f64, (x, y)| m.max((x - y).abs())) / size
}

fn close(a: HMinus2Norm, b: HMinus2Norm, tolerance: f64) {
    for (a, b) in [(a.u_l2, b.u_l2), (a.u_h1, b.u_h1), (a.sigma_l2, b.sigma_l2)] {
        assert!((a - b).abs() <= tolerance * b, "{a} is not {b}");
    }
}

/// The other route: `dense` enforces normal-normal continuity by multipliers, in Cartesian components, and solves
/// the indefinite system by LU.
fn agrees_with_dense<const N: usize>(mesh: &Mesh<N>, degree: usize, tolerance: f64) {
    let norm = HMinus2::new(mesh, degree).unwrap();
    let load = random_load(norm.space().len(), 7);
    let solution = norm.solve(&load).unwrap();
    let (u, expected) = dense::solve(mesh, degree, &load);
    let error = distance(&solution.coefficients[..u.len()], &u);
    println!("N = {N}, degree {degree}: u differs by {error:e}");
    assert!(error < tolerance, "N = {N}, degree {degree}: u differs by {error:e}");
    close(norm.norm(&load, None).unwrap(), expected, tolerance);
}

#[test]
fn dense_mixed_method_2d() {
    for degree in 1..=5 {
        agrees_with_dense(&Mesh::<2>::cube(1).unwrap(), degree, 1e-8);
    }
    for degree in 1..=4 {
        agrees_with_dense(&perturbed::<2>(1, 3), degree, 1e-8);
        agrees_with_dense(&Mesh::<2>::alfeld().unwrap(), degree, 1e-8);
    }
    agrees_with_dense(&perturbed::<2>(2, 5), 2, 1e-8);
}

#[test]
fn dense_mixed_method_3d() {
    for degree in 1..=3 {
        agrees_with_dense(&Mesh::<3>::cube(1).unwrap(), degree, 1e-8);
        agrees_with_dense(&Mesh::<3>::alfeld().unwrap(), degree, 1e-8);
    }
    agrees_with_dense(&Mesh::<3>::single().unwrap(), 5, 1e-8);
}

#[test]
fn dense_mixed_method_4d() {
    agrees_with_dense(&Mesh::<4>::alfeld().unwrap(), 2, 1e-8);
}

/// u = Π(1−x_i²)² is a polynomial of degree 8 in the plane: the method finds it.
#[test]
fn polynomials_are_exact() {
    for (degree, mesh) in [(8, Mesh::<2>::cube(1).unwrap()), (8, perturbed(1, 11)), (9, perturbed(1, 12))] {
        let norm = HMinus2::new(&mesh, degree).unwrap();
        let load = load_of(norm.space(), plate_bilaplacian);
        let [u, sigma] = plate::errors(&norm, &norm.solve(&load).unwrap());
        println!("degree {degree}: {u:e}, {sigma:e}");
        assert!(u < 1e-9 && sigma < 1e-9, "degree {degree}: {u:e}, {sigma:e}");
    }
}

fn converges<const N: usize>(degree: usize, levels: [u32; 2]) {
    let errors = levels.map(|level| {
        let mesh = perturbed::<N>(level, 17);
        let norm = HMinus2::new(&mesh, degree).unwrap();
        let load = load_of(norm.space(), plate_bilaplacian);
        plate::errors(&norm, &norm.solve(&load).unwrap())
    });
    let steps = f64::from(levels[1] - levels[0]);
    let order = |i: usize| (errors[0][i] / errors[1][i]).log2() / steps;
    println!("N = {N}, degree {degree}: {errors:?}: orders {} and {}", order(0), order(1));
}

#[test]
fn converges_at_the_proven_rates() {
    for degree in 1..=4 {
        converges::<2>(degree, [3, 5]);
    }
    converges::<3>(2, [2, 3]);
    converges::<3>(3, [2, 3]);
}

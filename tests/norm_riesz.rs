//! The norms H⁻¹(Ω, g) and V′_h against values in closed form, and against what they are the supremum of.

use crate::norm::plate::load_of;
use nalgebra::vector;
use regge_curvature::Error;
use regge_curvature::linalg::{Mat, Vector, symmetric};
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::metrics::{Metric, Smooth, SmoothTensor};
use regge_curvature::norm::{DualNorm, Energy, Kind, Riesz, Setting, metric_values};
use regge_curvature::quadrature::Rule;
use regge_curvature::scalar::Real;
use std::f64::consts::PI;

fn cosines<const N: usize>(x: &Vector<f64, N>) -> f64 {
    x.iter().map(|x| (0.5 * PI * x).cos()).product()
}

/// f = Π cos(πx_i/2) = −Δu/λ with u = f/λ, λ = Nπ²/4, and ‖f‖ = 1 in L²: its norm in H⁻¹ is λ^{−1/2}. From below, with twice
/// the order p.
fn meets_the_eigenfunction<const N: usize>(degree: usize, sides: [usize; 2]) {
    let exact = (N as f64 * PI * PI / 4.0).powf(-0.5);
    let [coarse, fine] = sides.map(|side| {
        let mesh = Mesh::<N>::cube(side).unwrap();
        let norm = Riesz::new(Energy::Dirichlet, &Setting::new(&mesh, degree)).unwrap();
        let load = load_of(norm.space(), cosines);
        exact - norm.of(&load, None).unwrap().total
    });
    assert!(coarse > 0.0 && fine > 0.0, "{coarse:e}, {fine:e}");
    let order = (coarse / fine).ln() / (sides[1] as f64 / sides[0] as f64).ln();
    // The coarsest pair, N = 3 and p = 2, has 3.82; half an order would be a wrong energy.
    assert!(
        (order - 2.0 * degree as f64).abs() < 0.2,
        "N = {N}, p = {degree}: order {order}"
    );
}

#[test]
fn an_eigenfunction() {
    meets_the_eigenfunction::<2>(1, [16, 32]);
    meets_the_eigenfunction::<2>(2, [8, 16]);
    meets_the_eigenfunction::<2>(3, [4, 8]);
    meets_the_eigenfunction::<3>(1, [8, 12]);
    meets_the_eigenfunction::<3>(2, [4, 8]);
}

/// A constant metric.
struct Constant<const N: usize>([f64; N]);

impl<const N: usize> SmoothTensor<N> for Constant<N> {
    fn at<S: Real>(&self, _: &[S; N]) -> Mat<S, N> {
        symmetric(|i, j| S::from_f64(if i == j { self.0[i] } else { 0.0 }))
    }
}

/// The metric diag(a_i²) is the Euclidean one on the mesh whose coordinates are stretched by a_i: the load is the same.
fn a_constant_metric_stretches<const N: usize>(stretch: [f64; N]) {
    let mesh = Mesh::<N>::cube(3).unwrap().perturbed(0.1, 5).unwrap();
    let points = mesh.points().unwrap().iter();
    let points = points.map(|p| Vector::from_fn(|i, _| stretch[i] * p[i]));
    let cell = |cell| mesh.vertices(N, cell).iter().map(|v| *v as usize).collect();
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count()).map(cell).collect();
    let stretched = Mesh::<N>::new(points.collect(), &cells).unwrap();
    let g = Smooth::new(&mesh, Constant(stretch.map(|a| a * a))).unwrap();
    let values = metric_values(&g);
    let setting = Setting::new(&mesh, 3);
    let curved = Riesz::new(Energy::Dirichlet, &setting.with_metric(&values)).unwrap();
    let flat = Riesz::new(Energy::Dirichlet, &Setting::new(&stretched, 3)).unwrap();
    let mut random = SplitMix64::new(1);
    let load: Vec<f64> = (0..flat.space().len())
        .map(|_| random.symmetric())
        .collect();
    let [a, b] = [&curved, &flat].map(|norm| norm.of(&load, None).unwrap().total);
    assert!((a / b - 1.0).abs() < 1e-11, "{a} is not {b}");
    let plain = Riesz::new(Energy::Dirichlet, &setting).unwrap();
    let plain = plain.of(&load, None).unwrap().total;
    assert!((plain / b - 1.0).abs() > 1e-2, "the metric matters");
}

#[test]
fn a_metric() {
    a_constant_metric_stretches::<2>([2.0, 0.5]);
    a_constant_metric_stretches::<3>([2.0, 0.5, 1.5]);
    // V'_h knows of no metric, to the bit.
    let mesh = Mesh::<2>::cube(2).unwrap();
    let g = Smooth::new(&mesh, Metric::Sphere).unwrap();
    let values = metric_values(&g);
    let setting = Setting::new(&mesh, 3);
    let [a, b] = [setting, setting.with_metric(&values)].map(|setting| {
        let norm = Riesz::new(Energy::Broken, &setting).unwrap();
        norm.of(&load_of(norm.space(), cosines), None).unwrap()
    });
    assert_eq!(a, b);
}

/// One triangle with legs of length a has one unknown of degree 3, the bubble b = 27/4.5 xy(a − x − y)/a³: ∫|∇b|² = 2/5 and
/// h²∫|∇²b|² = 72, whatever a is.
#[test]
fn a_bubble() {
    for a in [1.0, 0.01] {
        let points = vec![vector![0.0, 0.0], vector![a, 0.0], vector![0.0, a]];
        let mesh = Mesh::<2>::new(points, &[vec![0, 1, 2]]).unwrap();
        for (energy, square) in [(Energy::Dirichlet, 0.4), (Energy::Broken, 72.4)] {
            let norm = Riesz::new(energy, &Setting::new(&mesh, 3)).unwrap();
            let mut load = vec![7.0; norm.space().len()];
            let bubble = (0..load.len()).find(|&dof| norm.space().vanishes_on_boundary(dof));
            load[bubble.unwrap()] = 3.0;
            let found = norm.of(&load, None).unwrap().total;
            assert!((found * f64::sqrt(square) / 3.0 - 1.0).abs() < 1e-12);
        }
    }
}

/// The norm is a supremum: f(v) ≤ ‖f‖ E(v, v)^{1/2} with equality for u and nearly for nothing else; and by name it is what its
/// constructor makes.
#[test]
fn by_name() {
    let mesh = Mesh::<3>::cube(2).unwrap().perturbed(0.1, 2).unwrap();
    for (name, energy, degree) in [("hm1", Energy::Dirichlet, 3), ("vh", Energy::Broken, 4)] {
        let kind = Kind::<3>::named(name).unwrap();
        assert_eq!((kind.degree)(1), degree);
        let setting = Setting::new(&mesh, degree);
        let (named, own) = (
            (kind.new)(&setting).unwrap(),
            Riesz::new(energy, &setting).unwrap(),
        );
        let load = load_of(named.space(), |x| x[0] * x[1] - x[2]);
        let u = named.represent(&load, &mut |_| ()).unwrap();
        let norm = named.measure(&u, None).unwrap();
        assert_eq!(own.of(&load, None).unwrap(), norm);
        let pairing: f64 = u.coefficients.iter().zip(&load).map(|(u, f)| u * f).sum();
        assert!((pairing / norm.total.powi(2) - 1.0).abs() < 1e-10);
        let mut v = u.clone();
        v.coefficients.iter_mut().step_by(3).for_each(|x| *x *= 1.1);
        let size = named.measure(&v, None).unwrap().total;
        let tested: f64 = v.coefficients.iter().zip(&load).map(|(v, f)| v * f).sum();
        assert!(tested < norm.total * size * (1.0 - 1e-6), "{name}");
        assert!(matches!(
            named.measure(&u, Some(&Rule::new(2, 2))),
            Err(Error::Input(_))
        ));
        assert!(matches!(named.of(&load[1..], None), Err(Error::Input(_))));
    }
}

#[test]
fn what_cannot_be() {
    let closed = Mesh::<2>::torus(3).unwrap();
    let two = Mesh::<2>::new_abstract(4, &[vec![0, 1, 2], vec![1, 2, 3]]).unwrap();
    for energy in [Energy::Dirichlet, Energy::Broken] {
        let on = |mesh| Riesz::<2>::new(energy, &Setting::new(mesh, 2)).map(|_| ());
        assert!(matches!(on(&closed), Err(Error::Input(_))));
        assert!(matches!(on(&two), Err(Error::NoCoordinates(_))));
    }
    // No unknown: every functional is 0 there.
    let single = Mesh::<2>::single().unwrap();
    let norm = Riesz::new(Energy::Dirichlet, &Setting::new(&single, 2)).unwrap();
    assert_eq!(norm.of(&[1.0; 6], None).unwrap().total, 0.0);
}

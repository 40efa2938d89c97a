//! Approximate equality sees every part of a value: one that is off is noticed, wherever it is.

use crate::common::random_regge;
use approx::{AbsDiffEq, RelativeEq, abs_diff_eq, relative_eq};
use num_dual::{Dual, Dual2_64, Dual3_64, Dual64, DualSVec64, HyperDual64, HyperHyperDual64};
use regge_curvature::functional::{Action, ActionGradient, HessianEntry, HingeDefect, Sums, Three};
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::Mat;
use regge_curvature::parts::{AllParts, Parts};
use regge_curvature::scalar::Lanes;
use regge_curvature::{Mesh, ReggeSpace};

/// What parts are off by.
const OFF: f64 = 1e-3;

/// A value made of `count` numbers is near itself, and near none that differs in one of them, by either measure.
fn sees_all<V>(count: usize, make: impl Fn(&mut dyn FnMut() -> f64) -> V)
where
    V: AbsDiffEq<Epsilon = f64> + RelativeEq,
{
    // The numbers 1, 2, 3, …, the one at `off` moved.
    let value = |off: Option<usize>| {
        let mut taken = 0;
        let value = make(&mut || {
            taken += 1;
            taken as f64 + if off == Some(taken - 1) { OFF } else { 0.0 }
        });
        assert_eq!(taken, count);
        value
    };
    let one = value(None);
    assert!(abs_diff_eq!(one, value(None), epsilon = 0.0));
    assert!(relative_eq!(
        one,
        value(None),
        epsilon = 0.0,
        max_relative = 0.0
    ));
    for i in 0..count {
        let other = value(Some(i));
        assert!(!abs_diff_eq!(one, other, epsilon = 0.9 * OFF), "part {i}");
        assert!(abs_diff_eq!(one, other, epsilon = 1.1 * OFF), "part {i}");
        let relative = OFF / (i + 1) as f64;
        let near = |r: f64| relative_eq!(one, other, epsilon = 0.0, max_relative = r);
        assert!(!near(0.9 * relative), "part {i}");
        assert!(near(1.1 * relative), "part {i}");
    }
}

/// The same for a type that approx itself would not compare by all parts.
fn sees_inside<V: Parts + 'static>(count: usize, make: impl Fn(&mut dyn FnMut() -> f64) -> V) {
    // The wrapper borrows: a value for each test that lives as long as the program.
    sees_all(count, |next| AllParts(Box::leak(Box::new(make(next)))));
}

fn dual(next: &mut dyn FnMut() -> f64) -> Dual64 {
    Dual64::new(next(), next())
}

#[test]
fn scalars() {
    sees_all(4, |next| Lanes::new(std::array::from_fn(|_| next())));
    sees_all(3, |next| Jet1::<f64, 2> {
        value: next(),
        d: [next(), next()],
    });
    sees_all(6, |next| Jet2::<f64, 2>::from_numbers(next));
    sees_all(6, |next| Jet1::<Dual64, 2> {
        value: dual(next),
        d: [dual(next), dual(next)],
    });
    sees_all(8, |next| Jet1::<Lanes, 1> {
        value: Lanes::new(std::array::from_fn(|_| next())),
        d: [Lanes::new(std::array::from_fn(|_| next()))],
    });
    sees_all(24, |next| {
        Mat::<Jet2<f64, 2>, 2>::from_fn(|_, _| Jet2::from_numbers(&mut *next))
    });
}

#[test]
fn dual_numbers() {
    sees_inside(2, dual);
    sees_inside(4, |next| Dual::new(dual(next), dual(next)));
    sees_inside(3, |next| Dual2_64::new(next(), next(), next()));
    sees_inside(4, |next| Dual3_64::new(next(), next(), next(), next()));
    sees_inside(4, |next| HyperDual64::new(next(), next(), next(), next()));
    sees_inside(8, |n| {
        HyperHyperDual64::new(n(), n(), n(), n(), n(), n(), n(), n())
    });
    sees_inside(3, |next| DualSVec64::<2> {
        re: next(),
        eps: num_dual::Derivative::some([next(), next()].into()),
    });
    sees_inside(8, |next| {
        vec![dual(next), dual(next), dual(next), dual(next)]
    });
    sees_inside(8, |next| Mat::<Dual64, 2>::from_fn(|_, _| dual(next)));
}

/// A derivative that is left out is zero.
#[test]
fn no_derivative_is_a_zero_derivative() {
    let constant = DualSVec64::<2>::from_re(3.0);
    let mut moving = constant;
    moving.eps = num_dual::Derivative::some([0.0, OFF].into());
    let (a, b) = (AllParts(&constant), AllParts(&moving));
    assert!(abs_diff_eq!(a, b, epsilon = 2.0 * OFF));
    assert!(!abs_diff_eq!(a, b, epsilon = 0.5 * OFF));
}

#[test]
fn results() {
    sees_all(12, |next| Sums {
        cells: vec![dual(next), dual(next)],
        faces: vec![dual(next), dual(next)],
        hinges: vec![dual(next), dual(next)],
    });
    sees_all(6, |next| Three {
        cells: dual(next),
        faces: dual(next),
        hinges: dual(next),
    });
    sees_all(4, |next| Action {
        interior: dual(next),
        boundary: dual(next),
    });
    sees_all(3, |next| ActionGradient {
        gradient: vec![next(), next()],
        schlaefli: next(),
    });
    sees_all(2, |next| HingeDefect {
        hinge: 7,
        defect: next(),
        size: next(),
    });
    let mesh = Mesh::<2>::single().expect("a triangle");
    let space = ReggeSpace::new(&mesh, 0);
    sees_all(6, |next| {
        let lengths = vec![dual(next), dual(next), dual(next)];
        space.function(lengths).expect("as many")
    });
}

/// What belongs to another place, has another length or another space, or is no number is never near.
#[test]
fn what_cannot_be_compared_is_not_near() {
    let entry = |row, column| HessianEntry {
        row,
        column,
        value: 1.0,
    };
    assert!(abs_diff_eq!(entry(1, 2), entry(1, 2), epsilon = 1.0));
    assert!(!abs_diff_eq!(entry(1, 2), entry(1, 3), epsilon = 10.0));
    assert!(!abs_diff_eq!(entry(1, 2), entry(2, 2), epsilon = 10.0));
    let sums = |cells: usize, faces: usize| Sums {
        cells: vec![0.0; cells],
        faces: vec![0.0; faces],
        hinges: Vec::new(),
    };
    assert!(abs_diff_eq!(sums(1, 2), sums(1, 2), epsilon = 0.0));
    assert!(!abs_diff_eq!(sums(1, 2), sums(2, 1), epsilon = 10.0));
    let nan = Lanes::new([1.0, 1.0, f64::NAN, 1.0]);
    assert!(!abs_diff_eq!(nan, nan, epsilon = f64::INFINITY));
    assert!(!relative_eq!(nan, nan, epsilon = 1.0, max_relative = 1.0));
    let mesh = Mesh::<3>::cube(1).expect("a cube");
    let (space, other) = (ReggeSpace::new(&mesh, 0), ReggeSpace::new(&mesh.clone(), 0));
    let g = random_regge(&space, 0.1, 1);
    assert!(abs_diff_eq!(g, random_regge(&other, 0.1, 1), epsilon = 0.0));
    let turned = Mesh::<3>::cube(1).and_then(|m| {
        let points = m.points().expect("a cube has coordinates").iter();
        let cells = (0..6).map(|c| m.vertices(3, c).iter().map(|&v| v as usize).collect());
        Mesh::new(points.map(|x| -x).collect(), &cells.collect::<Vec<_>>())
    });
    let elsewhere = ReggeSpace::new(&turned.expect("a cube"), 0);
    let same = elsewhere.function(g.coefficients().to_vec());
    let same = same.expect("as many");
    assert!(!abs_diff_eq!(g, same, epsilon = 10.0));
}

//! Fields made of fields, and what tells a metric from a tensor that is none.

use regge_curvature::field::{Combination, Evaluate, PointByPoint};
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, indefinite_pivot, surely_positive, symmetric};
use regge_curvature::simplex::Points;

/// The same tensor everywhere, whose derivatives claim otherwise; says that it is constant or does not.
struct Given {
    component: f64,
    constant: bool,
}

impl Evaluate<f64, 2> for Given {
    type Table = ();
    type Local = ();

    fn tabulate(&self, _: &Points) {}
    fn on_cell(&self, _: usize) {}
    fn jet2(&self, (): &(), (): &(), _: usize) -> Mat<Jet2<f64, 2>, 2> {
        let mut next = self.component;
        let jet = Jet2::from_numbers(|| {
            next += 1.0;
            next
        });
        symmetric(|_, _| jet)
    }
    fn is_constant(&self) -> bool {
        self.constant
    }
}

/// (1−t) a + t b, in values and derivatives, in all the forms in which a field may be asked.
#[test]
fn segments_join_two_fields() {
    let given = |component| Given {
        component,
        constant: false,
    };
    let (a, b) = (given(10.0), given(30.0));
    for t in [0.0, 0.25, 1.0, 1.5] {
        let segment = Combination::segment(&a, &b, t);
        let (local, table) = (((), ()), ((), ()));
        let second = segment.jet2(&local, &table, 0)[(0, 1)];
        let first = segment.jet1(&local, &table, 0)[(0, 1)];
        let value = segment.value(&local, &table, 0)[(0, 1)];
        let start = 10.0 + 20.0 * t;
        assert_eq!([second.value, first.value, value], [start + 1.0; 3]);
        assert_eq!([second.d, first.d], [[start + 2.0, start + 3.0]; 2]);
        assert_eq!(
            second.dd,
            [[start + 4.0, start + 5.0], [start + 5.0, start + 6.0]]
        );
    }
}

/// A combination is constant on cells if both parts are; a reference is what it refers to.
#[test]
fn constants_are_known_through_what_is_made_of_them() {
    for (one, other) in [(true, true), (true, false), (false, true), (false, false)] {
        let given = |constant| Given {
            component: 1.0,
            constant,
        };
        let (a, b) = (given(one), given(other));
        let through = <&Given as Evaluate<f64, 2>>::is_constant(&&a);
        assert_eq!(through, one);
        let sum = Combination::new(1.0, &a, 1.0, &b);
        assert_eq!(Evaluate::<f64, 2>::is_constant(&sum), one && other);
    }
}

/// Point by point, and through a reference, a field is what it was in all the forms in which it may be asked.
#[test]
fn a_field_seen_otherwise_is_the_same() {
    /// One that knows each form by itself, so that none can be derived from another.
    struct Forms;
    impl Evaluate<f64, 2> for Forms {
        type Table = usize;
        type Local = usize;

        fn tabulate(&self, points: &Points) -> usize {
            points.len()
        }
        fn on_cell(&self, cell: usize) -> usize {
            cell
        }
        fn jet2(&self, cell: &usize, table: &usize, block: usize) -> Mat<Jet2<f64, 2>, 2> {
            let value = (100 * cell + 10 * table + block) as f64;
            symmetric(|_, _| Jet2::constant(value))
        }
        fn jet1(&self, cell: &usize, table: &usize, block: usize) -> Mat<Jet1<f64, 2>, 2> {
            let value = (1000 + 100 * cell + 10 * table + block) as f64;
            symmetric(|_, _| Jet1::constant(value))
        }
        fn value(&self, cell: &usize, table: &usize, block: usize) -> Mat<f64, 2> {
            symmetric(|_, _| (2000 + 100 * cell + 10 * table + block) as f64)
        }
    }
    fn forms<A: Evaluate<f64, 2>>(field: &A) -> [f64; 3] {
        let points = Points::new(3, vec![1.0 / 3.0; 6]);
        let (local, table) = (field.on_cell(7), field.tabulate(&points));
        [
            field.jet2(&local, &table, 1)[(0, 1)].value,
            field.jet1(&local, &table, 1)[(0, 1)].value,
            field.value(&local, &table, 1)[(0, 1)],
        ]
    }
    let expected = [721.0, 1721.0, 2721.0];
    assert_eq!(forms(&Forms), expected);
    assert_eq!(forms(&&Forms), expected);
    assert_eq!(forms(&PointByPoint(&Forms)), expected);
    for constant in [true, false] {
        let given = Given {
            component: 1.0,
            constant,
        };
        assert_eq!(PointByPoint(given).is_constant(), constant);
    }
}

/// The first pivot of LDLᵀ that is not positive; where there is one, nobody is sure that there is none.
#[test]
fn indefinite_tensors_are_found_out() {
    let tensor =
        |diagonal: [f64; 3]| symmetric::<f64, 3>(|i, j| if i == j { diagonal[i] } else { 0.5 });
    let pivot = |diagonal| indefinite_pivot(&tensor(diagonal));
    assert_eq!(pivot([1.0, 1.0, 1.0]), None);
    assert!(surely_positive(&tensor([1.0, 1.0, 1.0])));
    for (diagonal, expected) in [
        ([-1.0, 1.0, 1.0], -1.0),
        ([1.0, 0.25, 1.0], 0.0),
        ([1.0, 0.0, 1.0], -0.25),
    ] {
        assert_eq!(pivot(diagonal), Some(expected));
        assert!(!surely_positive(&tensor(diagonal)));
    }
    let nowhere = [1.0, f64::NAN, 1.0];
    assert!(pivot(nowhere).is_some_and(f64::is_nan));
    assert!(!surely_positive(&tensor(nowhere)));
}

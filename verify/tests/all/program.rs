//! Recorded programs: they compute what the kernel computes, and their degrees are those of polynomials.

use proptest::prelude::*;
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, inverse_and_det, symmetric};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::{Algebraic, Field};
use regge_verify::exact::{Degrees, Fp, Program, Recorded, degrees, record};

/// R of these jets of a metric, times √det g, and n: everything that a field with roots offers.
fn kernel<F: Algebraic>(numbers: &[F]) -> Vec<F> {
    let mut all = numbers.iter().copied();
    let mut next = || all.next().expect("there are enough numbers");
    let g: Mat<Jet2<F, 3>, 3> = symmetric(|_, _| Jet2::from_numbers(&mut next));
    let connection: Connection<Jet1<F, 3>, 3> = Connection::new(&g);
    let nu = Vector::<F, 3>::from_fn(|_, _| next());
    let base = connection.lower();
    let square = (0..3).fold(F::zero(), |sum, i| sum + nu[i] * base.sharp(&nu)[i]);
    vec![connection.scalar() * base.det.sqrt(), nu[0] / square.sqrt()]
}

const COUNT: usize = 6 * 10 + 3;

fn replay(program: &Program, results: &[Recorded], numbers: &[Fp]) -> Option<Vec<Fp>> {
    let needed = program.needed(results.iter().copied());
    let values = program.run(&needed, numbers, Fp::is_poison)?;
    Some(results.iter().map(|r| values[r.place()]).collect())
}

proptest! {
    #[test]
    fn a_program_computes_what_its_kernel_does(
        numbers in proptest::collection::vec((0..Fp::P).prop_map(Fp::new), COUNT)
    ) {
        let (program, results) = record(COUNT, kernel::<Recorded>);
        let direct = kernel(&numbers);
        match replay(&program, &results, &numbers) {
            Some(values) => prop_assert_eq!(values, direct),
            None => prop_assert!(direct.iter().any(|x| x.is_poison())),
        }
    }

    /// Along a line a polynomial of degree d has differences of order d + 1 that vanish, and none of order d.
    #[test]
    fn the_degree_of_a_polynomial_is_met_along_a_line(
        ends in proptest::collection::vec((0..Fp::P).prop_map(Fp::new), 8)
    ) {
        let f = |x: &[Recorded]| {
            let (sum, product) = (x[0] + x[1] * x[2], x[2] * x[3] - x[0]);
            vec![sum * sum * product + Recorded::from_int(3) * product]
        };
        let (program, results) = record(4, f);
        let degree = degrees(&program, &[0; 4], &results).total as i64;
        prop_assert_eq!(degree, 6);
        let at = |t: i64| {
            let line = |k: usize| ends[k] + Fp::from_int(t) * ends[k + 4];
            let numbers: Vec<Fp> = (0..4).map(line).collect();
            replay(&program, &results, &numbers).expect("nothing is divided by")[0]
        };
        let mut row: Vec<Fp> = (0..=degree + 1).map(at).collect();
        while row.len() > 2 {
            row = row.windows(2).map(|w| w[1] - w[0]).collect();
        }
        prop_assert_eq!(row[1] - row[0], Fp::zero());
        prop_assert_ne!(row[0], Fp::zero());
    }
}

/// The degree of what `f` makes of two groups of two numbers each.
fn degree(f: impl Fn(&[Recorded]) -> Recorded) -> Degrees {
    let (program, result) = record(4, f);
    degrees(&program, &[0, 0, 1, 1], &[result])
}

#[test]
fn denominators_are_cleared_and_roots_are_half() {
    let counted = |total, by_group: [u64; 2], roots| Degrees {
        total,
        by_group: by_group.to_vec(),
        roots,
    };
    // (x₀² + x₂)/x₁ + x₃: x₀² + x₂ + x₁x₃.
    let quotient = degree(|x| (x[0] * x[0] + x[2]) / x[1] + x[3]);
    assert_eq!(quotient, counted(2, [2, 1], 0));
    // The same denominator twice is cleared once; what cancels is cancelled.
    let twice = degree(|x| x[0] / x[1] + x[2] / x[1]);
    assert_eq!(twice, counted(1, [1, 1], 0));
    let cancelled = degree(|x| x[0] / (x[1] + x[2]) * (x[1] + x[2]) + x[3]);
    assert_eq!(cancelled, counted(1, [1, 1], 0));
    // 1/x₀ + 1/x₂: x₂ + x₀.
    let sum = degree(|x| Recorded::one() / x[0] + Recorded::one() / x[2]);
    assert_eq!(sum, counted(1, [1, 1], 0));
    // √(x₀⁴ + x₂) + √(x₀/x₁): r₁x₁ + r₂ with degrees 2 + 1 and 1.
    let roots = degree(|x| (x[0] * x[0] * x[0] * x[0] + x[2]).sqrt() + (x[0] / x[1]).sqrt());
    assert_eq!(roots, counted(3, [3, 1], 2));
    // The same root twice is one.
    assert_eq!(degree(|x| x[0].sqrt() * x[1] - x[0].sqrt()).roots, 1);
}

/// The leading minors of a symmetric matrix have the degrees 1, 2 and 3; elimination without Bareiss's divisions makes 4 of
/// the last, which is a bound.
#[test]
fn elimination_is_counted_as_it_is_done() {
    let (program, (inverse, det)) = record(6, |x| {
        let mut all = x.iter().copied();
        let a: Mat<Recorded, 3> = symmetric(|_, _| all.next().expect("six numbers"));
        inverse_and_det(&a)
    });
    let of = |result| degrees(&program, &[0; 6], &[result]).total;
    assert!((3..=4).contains(&of(det)), "{}", of(det));
    assert!((2..=7).contains(&of(inverse[(0, 0)])));
}

/// What is not needed is not computed, and what does not exist is not needed in vain.
#[test]
fn only_what_is_needed_is_computed() {
    let (program, results) = record(2, |x| vec![x[0] + x[1], x[0] / x[1]]);
    let numbers = [Fp::from_int(5), Fp::zero()];
    assert_eq!(
        replay(&program, &results[..1], &numbers),
        Some(vec![Fp::from_int(5)])
    );
    assert_eq!(replay(&program, &results, &numbers), None);
}

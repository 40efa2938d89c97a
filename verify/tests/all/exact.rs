//! The prime fields, and exact integrals over them.

use proptest::prelude::*;
use regge_curvature::scalar::{Algebraic, Field};
use regge_verify::exact::{Fp, Fq, on_simplex};

fn element() -> impl Strategy<Value = Fp> {
    prop_oneof![9 => (0..Fp::P).prop_map(Fp::new), 1 => (0u64..4).prop_map(Fp::new)]
}

proptest! {
    #[test]
    fn it_is_a_commutative_ring(a in element(), b in element(), c in element()) {
        prop_assert_eq!(a + b, b + a);
        prop_assert_eq!(a * b, b * a);
        prop_assert_eq!((a + b) + c, a + (b + c));
        prop_assert_eq!((a * b) * c, a * (b * c));
        prop_assert_eq!(a * (b + c), a * b + a * c);
        prop_assert_eq!(a - b, a + (-b));
        prop_assert_eq!(a + Fp::zero(), a);
        prop_assert_eq!(a * Fp::one(), a);
    }

    #[test]
    fn it_agrees_with_big_integers(a in 0..Fp::P, b in 0..Fp::P) {
        let p = u128::from(Fp::P);
        let product = (u128::from(a) * u128::from(b) % p) as u64;
        let sum = ((u128::from(a) + u128::from(b)) % p) as u64;
        prop_assert_eq!(Fp::new(a) * Fp::new(b), Fp::new(product));
        prop_assert_eq!(Fp::new(a) + Fp::new(b), Fp::new(sum));
    }

    #[test]
    fn so_does_the_other_field(a in 0..Fq::P, b in 0..Fq::P) {
        let q = u128::from(Fq::P);
        let product = (u128::from(a) * u128::from(b) % q) as u64;
        let sum = ((u128::from(a) + u128::from(b)) % q) as u64;
        let (x, y) = (Fq::new(a), Fq::new(b));
        prop_assert_eq!(x * y, Fq::new(product));
        prop_assert_eq!(x + y, Fq::new(sum));
        prop_assert_eq!((x - y) + y, x);
        let root = (x * x).sqrt();
        prop_assert!(root == x || root == -x);
        prop_assert!(!root.sqrt().is_poison(), "the root is a square itself");
        prop_assert_eq!((x * x).sqrt() * (y * y).sqrt(), (x * x * y * y).sqrt());
        if b != 0 {
            prop_assert_eq!(x / y * y, x);
        }
    }

    #[test]
    fn division_undoes_multiplication(a in element(), b in element()) {
        let quotient = a / b;
        if b == Fp::zero() {
            prop_assert!(quotient.is_poison());
        } else {
            prop_assert_eq!(quotient * b, a);
        }
    }

    #[test]
    fn squares_have_multiplicative_roots(a in element(), b in element()) {
        let root = (a * a).sqrt();
        prop_assert!(root == a || root == -a);
        prop_assert!(!root.sqrt().is_poison(), "the root is a square itself");
        prop_assert_eq!((a * a).sqrt() * (b * b).sqrt(), (a * a * b * b).sqrt());
        if a != Fp::zero() {
            prop_assert!((-(a * a)).sqrt().is_poison(), "−1 is no square");
        }
    }

    #[test]
    fn poison_spreads(a in element()) {
        for x in [a + Fp::POISON, Fp::POISON - a, a * Fp::POISON, Fp::POISON / a, a / Fp::POISON, -Fp::POISON] {
            prop_assert!(x.is_poison());
        }
        prop_assert!(Fp::POISON.sqrt().is_poison());
    }
}

#[test]
fn halves_and_negative_integers() {
    assert_eq!(Fp::half() + Fp::half(), Fp::one());
    assert_eq!(Fp::from_int(-3) + Fp::from_int(3), Fp::zero());
    assert_eq!(Fp::ratio(-1, 3) * Fp::from_int(3), Fp::from_int(-1));
}

/// ∫ λ^α = α! / (|α| + k)! on the reference k-simplex (Dirichlet).
#[test]
fn it_integrates_monomials() {
    let factorial = |n: i64| (1..=n).fold(Fp::one(), |p, i| p * Fp::from_int(i));
    for alpha in [vec![3, 0], vec![2, 5], vec![1, 2, 3], vec![4, 0, 1, 2]] {
        let (k, degree) = (alpha.len() - 1, alpha.iter().sum::<i64>());
        let mut sum = Fp::zero();
        let there = on_simplex(
            k,
            degree as usize,
            &|l: &[Fp]| !Algebraic::sqrt(l[l.len() - 2]).is_poison(),
            &mut |l, w| {
                let monomial = l
                    .iter()
                    .zip(&alpha)
                    .fold(Fp::one(), |p, (l, a)| p * l.pow(*a as u64));
                sum += w * monomial;
            },
        );
        assert!(there, "half of all points have the root");
        let top = alpha.iter().fold(Fp::one(), |p, a| p * factorial(*a));
        assert_eq!(sum, top / factorial(degree + k as i64), "{alpha:?}");
    }
}

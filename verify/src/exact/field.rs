//! The prime field F_p, p = 2⁶¹ − 1: the library's formulas at random points of it, exactly.
//!
//! Every formula of the library up to unit normals, volumes and sines of angles is algebraic. Evaluated at random
//! elements of a large field, two sides that are not identical agree with a probability of at most degree/p
//! (Schwartz–Zippel); there is no rounding and no tolerance.
//!
//! As p ≡ 3 mod 4, −1 is no square, and of the two roots of a square exactly one is a square itself. That root is
//! the one taken here: √a √b = √(ab), as for positive numbers, where the squares play the part of the positive
//! numbers. A root of a non-square and a division by zero give [`Fp::POISON`], which poisons what is computed
//! from it; the harness then draws again.

use regge_curvature::scalar::{Algebraic, Field};
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// An element of F_p.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fp(u64);

impl Fp {
    /// The number of elements: the Mersenne prime 2⁶¹ − 1.
    pub const P: u64 = (1 << 61) - 1;
    /// What an impossible root or division yields. It is equal to itself and to no element.
    pub const POISON: Self = Self(u64::MAX);

    /// The class of `n`.
    pub const fn new(n: u64) -> Self {
        Self(n % Self::P)
    }

    /// The representative in 0…p−1; none of the poison.
    pub fn get(self) -> Option<u64> {
        (!self.is_poison()).then_some(self.0)
    }

    /// Did a root or an inverse not exist?
    pub fn is_poison(self) -> bool {
        self == Self::POISON
    }

    /// x^n by repeated squaring.
    pub fn pow(self, mut n: u64) -> Self {
        let (mut square, mut product) = (self, Self(1));
        while n > 0 {
            if n & 1 == 1 {
                product *= square;
            }
            square *= square;
            n >>= 1;
        }
        product
    }

    /// `f` of the representatives, unless one of the two is poison.
    #[inline]
    fn combine(self, other: Self, f: impl Fn(u64, u64) -> u64) -> Self {
        if self.is_poison() || other.is_poison() {
            Self::POISON
        } else {
            Self(f(self.0, other.0))
        }
    }

    /// `n` < 2p, reduced.
    #[inline]
    fn wrap(n: u64) -> u64 {
        if n >= Self::P { n - Self::P } else { n }
    }
}

impl Add for Fp {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.combine(other, |a, b| Self::wrap(a + b))
    }
}

impl Sub for Fp {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.combine(other, |a, b| Self::wrap(a + Self::P - b))
    }
}

impl Mul for Fp {
    type Output = Self;
    /// 2⁶¹ ≡ 1: the high half of the product is added to the low half.
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.combine(other, |a, b| {
            let product = u128::from(a) * u128::from(b);
            let low = (product as u64) & Self::P;
            let high = (product >> 61) as u64;
            Self::wrap(low + high)
        })
    }
}

impl Div for Fp {
    type Output = Self;
    /// x/y = x y^(p−2), by Fermat.
    fn div(self, other: Self) -> Self {
        if other.0 == 0 {
            return Self::POISON;
        }
        if other.0 == 1 {
            return self;
        }
        self * other.pow(Self::P - 2)
    }
}

impl Neg for Fp {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(0) - self
    }
}

impl AddAssign for Fp {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Fp {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Fp {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Field for Fp {
    fn from_int(n: i64) -> Self {
        let class = Self::new(n.unsigned_abs());
        if n < 0 { -class } else { class }
    }

    /// ½ is asked for in every connection: it is (p+1)/2.
    fn ratio(n: i64, d: i64) -> Self {
        match d {
            1 => Self::from_int(n),
            2 => Self::from_int(n) * Self(Self::P.div_ceil(2)),
            _ => Self::from_int(n) / Self::from_int(d),
        }
    }
}

impl Algebraic for Fp {
    /// x^((p+1)/4), the root that is a square itself; poison if x is no square.
    fn sqrt(self) -> Self {
        let root = self.pow((Self::P + 1) / 4);
        if root * root == self {
            root
        } else {
            Self::POISON
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

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
}

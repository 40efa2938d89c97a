//! Rational numbers, exactly or not at all.

use regge_curvature::scalar::{Algebraic, Field};
use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// A fraction in lowest terms whose numerator and denominator have 127 bits. What is larger, what is divided by zero and the
/// root of what is no square are [`Ratio::POISON`]: nothing is ever rounded.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Ratio {
    /// With the sign.
    n: i128,
    /// Positive; zero for the poison.
    d: i128,
}

impl Ratio {
    /// What does not exist or is too large.
    pub const POISON: Self = Self { n: 0, d: 0 };

    /// n/d in lowest terms.
    fn reduced(n: i128, d: i128) -> Self {
        let divisor = gcd(n.unsigned_abs(), d.unsigned_abs());
        let Some(divisor) = i128::try_from(divisor).ok().filter(|g| *g > 0 && d != 0) else {
            return Self::POISON;
        };
        let (n, d) = (n / divisor, d / divisor);
        if d > 0 {
            Self { n, d }
        } else {
            Self { n: -n, d: -d }
        }
    }

    /// The same number in another field; it must be small.
    pub fn over<F: Field>(self) -> F {
        let small = |x: i128| i64::try_from(x).expect("a constant of a formula has few digits");
        F::ratio(small(self.n), small(self.d))
    }

    /// Did it overflow, or did it not exist?
    pub fn is_poison(self) -> bool {
        self.d == 0
    }

    /// n/d, if both were computed.
    fn checked(n: Option<i128>, d: Option<i128>) -> Self {
        match (n, d) {
            (Some(n), Some(1)) => Self { n, d: 1 },
            (Some(n), Some(d)) => Self::reduced(n, d),
            _ => Self::POISON,
        }
    }
}

/// Euclid's, in short numbers as soon as they are.
fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b > u128::from(u64::MAX) {
        (a, b) = (b, a % b);
    }
    if b == 0 {
        return a;
    }
    let (mut a, mut b) = (b as u64, (a % b) as u64);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.into()
}

/// The root of a perfect square.
fn root(n: i128) -> Option<i128> {
    let root = n.checked_isqrt()?;
    (root * root == n).then_some(root)
}

impl fmt::Debug for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.d {
            0 => write!(f, "undefined"),
            1 => write!(f, "{}", self.n),
            d => write!(f, "{}/{d}", self.n),
        }
    }
}

impl Add for Ratio {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        if self.d == other.d {
            return Self::checked(self.n.checked_add(other.n), Some(self.d));
        }
        let cross = |a: Self, b: Self| a.n.checked_mul(b.d);
        let sum = cross(self, other).zip(cross(other, self));
        let sum = sum.and_then(|(a, b)| a.checked_add(b));
        Self::checked(sum, self.d.checked_mul(other.d))
    }
}

impl Sub for Ratio {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Ratio {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::checked(self.n.checked_mul(other.n), self.d.checked_mul(other.d))
    }
}

impl Div for Ratio {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        // The poison's denominator is zero, and so is what it is divided by.
        if other.is_poison() {
            return other;
        }
        Self::checked(self.n.checked_mul(other.d), self.d.checked_mul(other.n))
    }
}

impl Neg for Ratio {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::checked(self.n.checked_neg(), Some(self.d))
    }
}

impl AddAssign for Ratio {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Ratio {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Ratio {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Field for Ratio {
    fn from_int(n: i64) -> Self {
        Self { n: n.into(), d: 1 }
    }

    fn ratio(n: i64, d: i64) -> Self {
        Self::reduced(n.into(), d.into())
    }
}

impl Algebraic for Ratio {
    fn sqrt(self) -> Self {
        match (root(self.n), root(self.d)) {
            (Some(n), Some(d)) if d > 0 => Self { n, d },
            _ => Self::POISON,
        }
    }
}

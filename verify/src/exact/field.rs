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

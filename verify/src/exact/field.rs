//! Prime fields F_p, p = 2⁶¹ − 1 and p = 2⁶² − 57: the library's formulas at random points of them, exactly.
//!
//! Every formula of the library up to unit normals, volumes and sines of angles is algebraic. Evaluated at random
//! elements of a large field, two sides that are not identical agree with a probability of at most degree/p
//! (Schwartz–Zippel); there is no rounding and no tolerance. An identity that is false in rational numbers may hold
//! modulo one prime, if that divides all its coefficients: so there are two.
//!
//! As p ≡ 3 mod 4, −1 is no square, and of the two roots of a square exactly one is a square itself. That root is
//! the one taken here: √a √b = √(ab), as for positive numbers, where the squares play the part of the positive
//! numbers. A root of a non-square and a division by zero give [`Modular::POISON`], which poisons what is computed
//! from it; the harness then draws again.

use regge_curvature::scalar::{Algebraic, Field};
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// An element of the field with p = 2^BITS − LESS elements, a prime ≡ 3 mod 4 below 2⁶³.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Modular<const BITS: u32, const LESS: u64>(u64);

/// p = 2⁶¹ − 1, a Mersenne prime.
pub type Fp = Modular<61, 1>;
/// Another field, p = 2⁶² − 57.
pub type Fq = Modular<62, 57>;

impl<const BITS: u32, const LESS: u64> Modular<BITS, LESS> {
    /// The number of elements.
    pub const P: u64 = (1 << BITS) - LESS;
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

    /// 2^BITS ≡ LESS: what is above the low bits is added to them, LESS times.
    #[inline]
    fn fold(n: u128) -> u128 {
        (n & ((1 << BITS) - 1)) + (n >> BITS) * u128::from(LESS)
    }
}

impl<const BITS: u32, const LESS: u64> Add for Modular<BITS, LESS> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.combine(other, |a, b| Self::wrap(a + b))
    }
}

impl<const BITS: u32, const LESS: u64> Sub for Modular<BITS, LESS> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.combine(other, |a, b| Self::wrap(a + Self::P - b))
    }
}

impl<const BITS: u32, const LESS: u64> Mul for Modular<BITS, LESS> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.combine(other, |a, b| {
            let mut product = Self::fold(u128::from(a) * u128::from(b));
            if LESS > 1 {
                product = Self::fold(product);
            }
            Self::wrap(product as u64)
        })
    }
}

impl<const BITS: u32, const LESS: u64> Div for Modular<BITS, LESS> {
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

impl<const BITS: u32, const LESS: u64> Neg for Modular<BITS, LESS> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(0) - self
    }
}

impl<const BITS: u32, const LESS: u64> AddAssign for Modular<BITS, LESS> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<const BITS: u32, const LESS: u64> SubAssign for Modular<BITS, LESS> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<const BITS: u32, const LESS: u64> MulAssign for Modular<BITS, LESS> {
    #[inline]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<const BITS: u32, const LESS: u64> Field for Modular<BITS, LESS> {
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

impl<const BITS: u32, const LESS: u64> Algebraic for Modular<BITS, LESS> {
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

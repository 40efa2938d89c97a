//! Four f64 side by side, as one scalar: the same kernel at four quadrature points at once.

use super::{Algebraic, Field, Real};
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use wide::f64x4;

/// Four f64 that go through every formula side by side.
///
/// Elementary functions agree with those of `f64` to a few units in the last place, not to the bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lanes(f64x4);

impl Lanes {
    /// One number a lane.
    #[inline]
    pub fn new(values: [f64; 4]) -> Self {
        Self(f64x4::from(values))
    }

    /// The four numbers.
    #[inline]
    pub fn to_array(self) -> [f64; 4] {
        self.0.to_array()
    }

    /// How wide the vectors are that this build computes with, in bits; 256 hold all four numbers.
    ///
    /// It is the compiler's choice of target that matters: `-C target-cpu=native`, or `x86-64-v3` for all machines with
    /// AVX2. Without either, x86-64 has 128 and the lanes lose much of their speed.
    pub const BUILT_FOR: usize = if cfg!(target_feature = "avx") {
        256
    } else if cfg!(any(
        target_feature = "sse2",
        target_feature = "neon",
        target_feature = "simd128"
    )) {
        128
    } else {
        64
    };

    /// A line for the user if this machine has wider vectors than this build makes use of.
    pub fn unused_width() -> Option<String> {
        #[cfg(target_arch = "x86_64")]
        if Self::BUILT_FOR < 256 && std::arch::is_x86_feature_detected!("avx") {
            return Some(format!(
                "built for vectors of {} bits, this machine has 256: build with RUSTFLAGS=\"-C target-cpu=native\"",
                Self::BUILT_FOR
            ));
        }
        None
    }
}

macro_rules! binary {
    ($($trait:ident $method:ident, $assign:ident $assign_method:ident;)*) => {$(
        impl $trait for Lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($trait::$method(self.0, other.0))
            }
        }
        impl $assign for Lanes {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                self.0 = $trait::$method(self.0, other.0);
            }
        }
    )*};
}
binary! {
    Add add, AddAssign add_assign;
    Sub sub, SubAssign sub_assign;
    Mul mul, MulAssign mul_assign;
}

impl Div for Lanes {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0)
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Field for Lanes {
    #[inline]
    fn from_int(n: i64) -> Self {
        Self(f64x4::splat(n as f64))
    }
    #[inline]
    fn ratio(n: i64, d: i64) -> Self {
        Self(f64x4::splat(n as f64 / d as f64))
    }
    #[inline(always)]
    fn add_product(&mut self, a: Self, b: Self) {
        self.0 = a.0.mul_add(b.0, self.0);
    }
    #[inline(always)]
    fn sub_product(&mut self, a: Self, b: Self) {
        self.0 = a.0.mul_neg_add(b.0, self.0);
    }
}

impl Algebraic for Lanes {
    #[inline]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
}

/// `f` in each lane: for the functions whose vector versions are not accurate to the last places.
#[inline]
fn lanewise(x: Lanes, f: impl Fn(f64) -> f64) -> Lanes {
    Lanes::new(x.to_array().map(f))
}

impl Real for Lanes {
    const LANES: usize = 4;
    type Sum = f64;

    #[inline]
    fn from_f64(x: f64) -> Self {
        Self(f64x4::splat(x))
    }
    #[inline]
    fn pack(value: impl Fn(usize) -> f64) -> Self {
        Self::new(std::array::from_fn(value))
    }
    #[inline]
    fn reduce(self) -> f64 {
        let [a, b, c, d] = self.to_array();
        (a + b) + (c + d)
    }
    #[inline]
    fn exp(self) -> Self {
        lanewise(self, f64::exp)
    }
    #[inline]
    fn ln(self) -> Self {
        lanewise(self, f64::ln)
    }
    #[inline]
    fn sin(self) -> Self {
        lanewise(self, f64::sin)
    }
    #[inline]
    fn cos(self) -> Self {
        lanewise(self, f64::cos)
    }
    #[inline]
    fn atan(self) -> Self {
        lanewise(self, f64::atan)
    }
    /// By a rational approximation of Cephes in all lanes at once, which is off by two units in the last place.
    #[inline]
    fn angle(sin: Self, cos: Self) -> Self {
        Self(sin.0.atan2(cos.0))
    }
    #[inline]
    fn select(self, above: Self, below: Self) -> Self {
        let [values, above, below] = [self, above, below].map(Self::to_array);
        Self::pack(|l| values[l].select(above[l], below[l]))
    }
}

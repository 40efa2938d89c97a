//! The numbers that the iteration computes with: double precision, and single precision within the preconditioner.

use crate::scalar::FUSED;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// `f64` or `f32`.
pub(super) trait Number:
    faer::traits::RealField
    + Copy
    + 'static
    + From<f32>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    const ZERO: Self;
    const ONE: Self;

    /// The nearest to x.
    fn of(x: f64) -> Self;

    fn double(self) -> f64;

    fn root(self) -> Self;

    /// self + a b: rounded once where the machine has an instruction for it.
    fn plus_product(self, a: Self, b: Self) -> Self;
}

impl Number for f64 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline]
    fn of(x: f64) -> Self {
        x
    }

    #[inline]
    fn double(self) -> f64 {
        self
    }

    #[inline]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        match FUSED {
            true => a.mul_add(b, self),
            false => self + a * b,
        }
    }
}

impl Number for f32 {
    const ZERO: Self = 0.0;
    const ONE: Self = 1.0;

    #[inline]
    fn of(x: f64) -> Self {
        x as Self
    }

    #[inline]
    fn double(self) -> f64 {
        f64::from(self)
    }

    #[inline]
    fn root(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        match FUSED {
            true => a.mul_add(b, self),
            false => self + a * b,
        }
    }
}

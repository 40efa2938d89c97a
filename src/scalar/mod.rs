//! Floor 0. The scalars: three levels of one ladder.
//!
//! A geometric formula is written once and asks for the lowest level that it needs:
//!
//! | level | operations | needed by |
//! |---|---|---|
//! | [`Field`] | + − × ÷, integers | Γ, Ric, R, G, div, Hessian, 𝕊 |
//! | [`Algebraic`] | square root, which may not exist | unit normals, H, ω, ω_F, ω_S |
//! | [`Real`] | transcendental functions, angles | angle defects, formulas for g, quadrature |
//!
//! `f64` and every copyable number of the crate num-dual (nested ones too) stand on all three levels, and so do
//! the SIMD `Lanes`. A prime field and [`Interval`]s stand on the first two: where a root or an inverse does not exist it
//! answers with a value that poisons all that is computed from it, as NaN does.

mod dual;
mod interval;
#[cfg(feature = "lanes")]
mod lanes;

#[cfg(feature = "norms")]
pub(crate) use dual::FUSED;
pub use interval::Interval;
#[cfg(feature = "lanes")]
pub use lanes::Lanes;

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// A commutative field: the four operations and the integers.
///
/// Division by zero does not panic. It yields a value that poisons what is computed from it (NaN, ∞, or the
/// poison of an exact field).
pub trait Field:
    Copy
    + Debug
    + PartialEq
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// The integer `n`.
    fn from_int(n: i64) -> Self;

    /// 0.
    #[inline]
    fn zero() -> Self {
        Self::from_int(0)
    }

    /// 1.
    #[inline]
    fn one() -> Self {
        Self::from_int(1)
    }

    /// The rational number `n / d`.
    #[inline]
    fn ratio(n: i64, d: i64) -> Self {
        Self::from_int(n) / Self::from_int(d)
    }

    /// ½.
    #[inline]
    fn half() -> Self {
        Self::ratio(1, 2)
    }

    /// Adds a·b: in one step, rounded once, where the machine has one for this scalar.
    #[inline]
    fn add_product(&mut self, a: Self, b: Self) {
        *self += a * b;
    }

    /// Subtracts a·b, as [`Field::add_product`] adds it.
    #[inline]
    fn sub_product(&mut self, a: Self, b: Self) {
        *self -= a * b;
    }
}

/// A field with square roots, where they exist.
pub trait Algebraic: Field {
    /// A square root of `self`; the non-negative one where there is an order. Poison (NaN) where none exists.
    fn sqrt(self) -> Self;
}

/// A real scalar, possibly carrying derivatives, possibly several numbers side by side.
///
/// `LANES` quadrature points are evaluated at once: [`Real::pack`] loads one number a lane, and
/// [`Real::reduce`] adds the lanes up. Scalars that hold one point have `LANES = 1` and `Sum = Self`.
pub trait Real: Algebraic {
    /// How many points one value of this type holds.
    const LANES: usize;
    /// What the sum over the lanes is.
    type Sum: Real;

    /// The constant `x`, in every lane, with zero derivatives.
    fn from_f64(x: f64) -> Self;
    /// `value(l)` in lane l, with zero derivatives.
    fn pack(value: impl Fn(usize) -> f64) -> Self;
    /// The sum over the lanes.
    fn reduce(self) -> Self::Sum;

    /// e^x.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Sine (radians).
    fn sin(self) -> Self;
    /// Cosine (radians).
    fn cos(self) -> Self;
    /// Arc tangent, in (−π/2, π/2).
    fn atan(self) -> Self;
    /// The angle θ ∈ (−π, π] with sin θ : cos θ = `sin` : `cos`; the two need not be normalised.
    ///
    /// Its derivatives are finite everywhere: those of atan2, not of acos.
    fn angle(sin: Self, cos: Self) -> Self;

    /// `above` where the value of `self` is ≥ 0, `below` where it is < 0, `self` where it is NaN; in each lane, with the
    /// derivatives of what is taken. This is how functions with a kink are written.
    fn select(self, above: Self, below: Self) -> Self;

    /// Tangent.
    #[inline]
    fn tan(self) -> Self {
        self.sin() / self.cos()
    }
    /// Hyperbolic sine.
    #[inline]
    fn sinh(self) -> Self {
        (self.exp() - (-self).exp()) * Self::half()
    }
    /// Hyperbolic cosine.
    #[inline]
    fn cosh(self) -> Self {
        (self.exp() + (-self).exp()) * Self::half()
    }
}

/// `self` as a number of a larger scalar: a constant, or the number itself.
pub trait Lift<T> {
    /// The number in the larger scalar.
    fn lift(self) -> T;
}

impl<T: Real> Lift<T> for f64 {
    #[inline]
    fn lift(self) -> T {
        T::from_f64(self)
    }
}

/// A scalar that holds one number a point, as coefficients and factors do, and the one in which it goes through the kernels.
pub trait Number: Real<Sum = Self> + Lift<Self> + Lift<Self::Wide> {
    /// As many points side by side as is fast: `Lanes` for `f64` where the feature `lanes` is on, else the scalar itself.
    type Wide: Real<Sum = Self>;
}

#[cfg(feature = "lanes")]
impl Number for f64 {
    type Wide = Lanes;
}

#[cfg(not(feature = "lanes"))]
impl Number for f64 {
    type Wide = f64;
}

/// x^n for a whole exponent n ≥ 0, by multiplication.
pub fn power<T: Field>(x: T, n: u32) -> T {
    (0..n).fold(T::one(), |product, _| product * x)
}

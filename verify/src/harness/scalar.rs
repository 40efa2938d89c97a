//! The scalars that a claim runs over: a ground scalar, and the same scalar with a rate of change in time.

use super::judgement::Method;
use crate::exact::{Modular, Ratio, Recorded};
use nalgebra::SMatrix;
use num_dual::Dual64;
use proptest::strategy::{BoxedStrategy, Strategy};
use regge_curvature::jet::Jet1;
use regge_curvature::scalar::{Algebraic, Field, Real};

/// A number, vector or matrix as the list of its components.
pub trait Components<B> {
    /// The components, in any fixed order.
    fn components(self) -> Vec<B>;
}

impl Components<f64> for f64 {
    fn components(self) -> Vec<f64> {
        vec![self]
    }
}

impl<const BITS: u32, const LESS: u64> Components<Self> for Modular<BITS, LESS> {
    fn components(self) -> Vec<Self> {
        vec![self]
    }
}

impl Components<Recorded> for Recorded {
    fn components(self) -> Vec<Recorded> {
        vec![self]
    }
}

impl<B> Components<B> for Vec<B> {
    fn components(self) -> Vec<B> {
        self
    }
}

impl<B: Ground, const R: usize, const C: usize> Components<B> for SMatrix<B, R, C> {
    fn components(self) -> Vec<B> {
        self.as_slice().to_vec()
    }
}

/// A scalar in which the two sides of a claim are compared.
pub trait Ground: Algebraic + Components<Self> {
    /// What a run over it is called.
    const METHOD: Method;

    /// Is this no number (NaN, an infinity, a missing root)?
    fn is_poison(self) -> bool;
    /// |x|; in a field without order 0 for zero and 1 for all others.
    fn size(self) -> f64;
    /// The angle with this sine and cosine, where the scalar has angles.
    fn angle(sin: Self, cos: Self) -> Option<Self>;
    /// The real number, where it is one: NaN for an element of a finite field.
    fn to_real(self) -> f64;
    /// A real number as such a scalar; poison where there are no real numbers.
    fn from_real(x: f64) -> Self;
}

/// A scalar of which random numbers are drawn.
pub trait Drawn: Ground {
    /// Its name in the report.
    const NAME: &'static str;
    /// How many draws may be spoilt by missing roots before the harness gives up on one case.
    const REDRAWS: usize;
    /// log₂ of how many numbers there are to draw, where they are equally likely.
    const SIZE_LOG2: f64;

    /// A number that every other is judged by: at random from −1…1, or from the whole field.
    fn number() -> BoxedStrategy<Self>;
}

impl Ground for f64 {
    const METHOD: Method = Method::Ad;

    fn is_poison(self) -> bool {
        !self.is_finite()
    }
    fn size(self) -> f64 {
        self.abs()
    }
    fn angle(sin: Self, cos: Self) -> Option<Self> {
        Some(Real::angle(sin, cos))
    }
    fn to_real(self) -> f64 {
        self
    }
    fn from_real(x: f64) -> Self {
        x
    }
}

impl Drawn for f64 {
    const NAME: &'static str = "f64";
    const REDRAWS: usize = 0;
    const SIZE_LOG2: f64 = f64::INFINITY;

    fn number() -> BoxedStrategy<Self> {
        (-1.0..1.0).boxed()
    }
}

/// Exact scalars have no order, no angles and no real numbers; what does not exist is their poison.
macro_rules! exact_ground {
    ($scalar:ty $(, const $name:ident: $kind:ty)*) => {
        impl<$(const $name: $kind),*> Ground for $scalar {
            const METHOD: Method = Method::Exact;

            fn is_poison(self) -> bool {
                <$scalar>::is_poison(self)
            }
            fn size(self) -> f64 {
                if self == Self::zero() { 0.0 } else { 1.0 }
            }
            fn angle(_sin: Self, _cos: Self) -> Option<Self> {
                None
            }
            fn to_real(self) -> f64 {
                f64::NAN
            }
            fn from_real(_x: f64) -> Self {
                Self::POISON
            }
        }
    };
}

exact_ground!(Modular<BITS, LESS>, const BITS: u32, const LESS: u64);
exact_ground!(Ratio);

impl<const BITS: u32, const LESS: u64> Drawn for Modular<BITS, LESS> {
    const NAME: &'static str = "F_p";
    // Up to a dozen roots are asked for: one draw in 2¹² has them all.
    const REDRAWS: usize = 1 << 17;
    // p is within 2⁻⁵⁶ of it.
    const SIZE_LOG2: f64 = BITS as f64;

    fn number() -> BoxedStrategy<Self> {
        (0..Self::P).prop_map(Self::new).boxed()
    }
}

impl Components<Ratio> for Ratio {
    fn components(self) -> Vec<Ratio> {
        vec![self]
    }
}

/// Numbers of which only the program is known have neither size nor order.
impl Ground for Recorded {
    const METHOD: Method = Method::Exact;

    fn is_poison(self) -> bool {
        false
    }
    fn size(self) -> f64 {
        0.0
    }
    fn angle(_sin: Self, _cos: Self) -> Option<Self> {
        None
    }
    fn to_real(self) -> f64 {
        f64::NAN
    }
    /// 1/0, which is poison in every field.
    fn from_real(_x: f64) -> Self {
        Self::one() / Self::zero()
    }
}

/// A scalar that changes in time: x + t ẋ to first order.
///
/// NB `==` on dual numbers compares the values only: compare [`Timed::rate`]s.
pub trait Timed: Algebraic {
    /// The scalar of the value and of the rate.
    type Base: Ground;
    /// x + t ẋ.
    fn new(value: Self::Base, rate: Self::Base) -> Self;
    /// x.
    fn value(self) -> Self::Base;
    /// ẋ.
    fn rate(self) -> Self::Base;
    /// θ̇ of the angle with this sine and cosine, which need not be normalised.
    fn angle_rate(sin: Self, cos: Self) -> Self::Base;

    /// A constant in time.
    fn fixed(value: Self::Base) -> Self {
        Self::new(value, Self::Base::zero())
    }
}

impl Timed for Dual64 {
    type Base = f64;

    fn new(value: f64, rate: f64) -> Self {
        Dual64::new(value, rate)
    }
    fn value(self) -> f64 {
        self.re
    }
    fn rate(self) -> f64 {
        self.eps
    }
    /// Through the library's own angle.
    fn angle_rate(sin: Self, cos: Self) -> f64 {
        Real::angle(sin, cos).eps
    }
}

impl Timed for Jet1<Recorded, 1> {
    type Base = Recorded;

    fn new(value: Recorded, rate: Recorded) -> Self {
        Jet1 { value, d: [rate] }
    }
    fn value(self) -> Recorded {
        self.value
    }
    fn rate(self) -> Recorded {
        self.d[0]
    }
    /// θ̇ = (c ṡ − s ċ)/(s² + c²).
    fn angle_rate(sin: Self, cos: Self) -> Recorded {
        let ((s, c), (ds, dc)) = ((sin.value, cos.value), (sin.d[0], cos.d[0]));
        (c * ds - s * dc) / (s * s + c * c)
    }
}

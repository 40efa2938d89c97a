//! f64 and every copyable scalar of num-dual, by one blanket implementation.

use super::{Algebraic, Field, Lift, Number, Real};
use num_dual::{
    Dual, Dual2, Dual3, DualNum, DualNumCopy, DualSVec, DualStruct, HyperDual, HyperHyperDual,
};

impl<T: DualNumCopy + DualNum<Primitive = f64>> Field for T {
    #[inline]
    fn from_int(n: i64) -> Self {
        T::from(n as f64)
    }
    #[inline]
    fn ratio(n: i64, d: i64) -> Self {
        T::from(n as f64 / d as f64)
    }
}

impl<T: DualNumCopy + DualNum<Primitive = f64>> Algebraic for T {
    #[inline]
    fn sqrt(self) -> Self {
        DualNum::sqrt(&self)
    }
}

impl<T: DualNumCopy + DualNum<Primitive = f64>> Real for T {
    const LANES: usize = 1;
    type Sum = Self;

    #[inline]
    fn from_f64(x: f64) -> Self {
        T::from(x)
    }
    #[inline]
    fn pack(value: impl Fn(usize) -> f64) -> Self {
        T::from(value(0))
    }
    #[inline]
    fn reduce(self) -> Self {
        self
    }
    #[inline]
    fn exp(self) -> Self {
        DualNum::exp(&self)
    }
    #[inline]
    fn ln(self) -> Self {
        DualNum::ln(&self)
    }
    #[inline]
    fn sin(self) -> Self {
        DualNum::sin(&self)
    }
    #[inline]
    fn cos(self) -> Self {
        DualNum::cos(&self)
    }
    #[inline]
    fn atan(self) -> Self {
        DualNum::atan(&self)
    }

    /// num-dual's own atan2 differentiates atan(sin/cos), which is NaN at right angles. Here the pair is first
    /// turned by minus the angle of its real parts; what is left has real part 0, where atan is harmless to
    /// every order.
    #[inline]
    fn angle(sin: Self, cos: Self) -> Self {
        let (s, c) = (DualStruct::re(&sin), DualStruct::re(&cos));
        let theta = T::from(s.atan2(c));
        if Self::NDERIV == 0 {
            return theta;
        }
        let turned_sin = sin * c - cos * s;
        let turned_cos = cos * c + sin * s;
        theta + DualNum::atan(&(turned_sin / turned_cos))
    }

    #[inline]
    fn select(self, above: Self, below: Self) -> Self {
        let value = DualStruct::re(&self);
        if value >= 0.0 {
            above
        } else if value < 0.0 {
            below
        } else {
            self
        }
    }
}

macro_rules! lift_to_itself {
    ($($dual:ident),*) => {$(
        impl<T> Lift<$dual<T>> for $dual<T> {
            #[inline]
            fn lift(self) -> $dual<T> {
                self
            }
        }
        impl<T> Number for $dual<T>
        where
            $dual<T>: DualNumCopy + DualNum<Primitive = f64>,
        {
            type Wide = Self;
        }
    )*};
}
lift_to_itself!(Dual, Dual2, Dual3, HyperDual, HyperHyperDual);

impl<T: DualNum<Primitive = f64>, const D: usize> Lift<DualSVec<T, D>> for DualSVec<T, D> {
    #[inline]
    fn lift(self) -> DualSVec<T, D> {
        self
    }
}

impl<T: DualNum<Primitive = f64>, const D: usize> Number for DualSVec<T, D>
where
    DualSVec<T, D>: DualNumCopy + DualNum<Primitive = f64>,
{
    type Wide = Self;
}

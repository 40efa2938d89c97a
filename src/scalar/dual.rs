//! f64 and every copyable scalar of num-dual.

use super::{Algebraic, Field, Lift, Number, Real};
use num_dual::{
    Dual, Dual2, Dual3, DualNum, DualNumCopy, DualSVec, DualStruct, HyperDual, HyperHyperDual,
};

/// Has the machine that this is built for an instruction for a·b + c? Without it, to round once would be a call.
pub(crate) const FUSED: bool = cfg!(any(target_feature = "fma", target_feature = "neon"));

/// The integers and quotients of a number of num-dual.
macro_rules! integers {
    () => {
        #[inline]
        fn from_int(n: i64) -> Self {
            Self::from(n as f64)
        }
        #[inline]
        fn ratio(n: i64, d: i64) -> Self {
            Self::from(n as f64 / d as f64)
        }
    };
}

impl Field for f64 {
    integers!();
    #[inline(always)]
    fn add_product(&mut self, a: Self, b: Self) {
        if FUSED {
            *self = a.mul_add(b, *self);
        } else {
            *self += a * b;
        }
    }
    #[inline(always)]
    fn sub_product(&mut self, a: Self, b: Self) {
        self.add_product(-a, b);
    }
}

/// The one dual number that derivatives are computed with in production: its products are added up part by part.
impl<T: Field> Field for Dual<T>
where
    Self: DualNumCopy + DualNum<Primitive = f64>,
{
    integers!();
    #[inline(always)]
    fn add_product(&mut self, a: Self, b: Self) {
        self.re.add_product(a.re, b.re);
        self.eps.add_product(a.re, b.eps);
        self.eps.add_product(a.eps, b.re);
    }
    #[inline(always)]
    fn sub_product(&mut self, a: Self, b: Self) {
        self.re.sub_product(a.re, b.re);
        self.eps.sub_product(a.re, b.eps);
        self.eps.sub_product(a.eps, b.re);
    }
}

macro_rules! field {
    ($($dual:ident),*) => {$(
        impl<T> Field for $dual<T>
        where
            Self: DualNumCopy + DualNum<Primitive = f64>,
        {
            integers!();
        }
    )*};
}
field!(Dual2, Dual3, HyperDual, HyperHyperDual);

impl<T: DualNum<Primitive = f64>, const D: usize> Field for DualSVec<T, D>
where
    Self: DualNumCopy + DualNum<Primitive = f64>,
{
    integers!();
}

impl<T: Field + DualNumCopy + DualNum<Primitive = f64>> Algebraic for T {
    #[inline]
    fn sqrt(self) -> Self {
        DualNum::sqrt(&self)
    }
}

impl<T: Field + DualNumCopy + DualNum<Primitive = f64>> Real for T {
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
            $dual<T>: Field + DualNumCopy + DualNum<Primitive = f64>,
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
    DualSVec<T, D>: Field + DualNumCopy + DualNum<Primitive = f64>,
{
    type Wide = Self;
}

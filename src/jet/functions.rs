//! Jets as scalars: integers, roots, elementary functions, by the chain rule.

use super::{Jet1, Jet2};
use crate::scalar::{Algebraic, Field, Real};

/// What both jets owe to the scalar below, by the chain rule.
macro_rules! jet_scalar {
    ($jet:ident) => {
        impl<T: Field, const N: usize> Field for $jet<T, N> {
            #[inline]
            fn from_int(n: i64) -> Self {
                Self::constant(T::from_int(n))
            }
            #[inline]
            fn ratio(n: i64, d: i64) -> Self {
                Self::constant(T::ratio(n, d))
            }
        }

        impl<T: Algebraic, const N: usize> Algebraic for $jet<T, N> {
            #[inline]
            fn sqrt(self) -> Self {
                let root = self.value.sqrt();
                let f1 = T::half() / root;
                self.chain((root, f1, -T::half() * f1 / self.value))
            }
        }

        impl<T: Real, const N: usize> Real for $jet<T, N> {
            const LANES: usize = T::LANES;
            type Sum = $jet<T::Sum, N>;

            #[inline]
            fn from_f64(x: f64) -> Self {
                Self::constant(T::from_f64(x))
            }
            #[inline]
            fn pack(value: impl Fn(usize) -> f64) -> Self {
                Self::constant(T::pack(value))
            }
            #[inline]
            fn reduce(self) -> Self::Sum {
                self.map(T::reduce)
            }
            #[inline]
            fn exp(self) -> Self {
                let e = self.value.exp();
                self.chain((e, e, e))
            }
            #[inline]
            fn ln(self) -> Self {
                let inverse = T::one() / self.value;
                self.chain((self.value.ln(), inverse, -inverse * inverse))
            }
            #[inline]
            fn sin(self) -> Self {
                let (s, c) = (self.value.sin(), self.value.cos());
                self.chain((s, c, -s))
            }
            #[inline]
            fn cos(self) -> Self {
                let (s, c) = (self.value.sin(), self.value.cos());
                self.chain((c, -s, -c))
            }
            #[inline]
            fn atan(self) -> Self {
                let f1 = T::one() / (T::one() + self.value * self.value);
                let f2 = -(self.value + self.value) * f1 * f1;
                self.chain((self.value.atan(), f1, f2))
            }
            /// As for dual numbers: turn by the angle of the values, then take the arc tangent of what is left.
            #[inline]
            fn angle(sin: Self, cos: Self) -> Self {
                let theta = T::angle(sin.value, cos.value);
                let (s, c) = (Self::constant(sin.value), Self::constant(cos.value));
                let turned = ((sin * c - cos * s) / (cos * c + sin * s)).atan();
                turned + Self::constant(theta - turned.value)
            }
            #[inline]
            fn select(self, above: Self, below: Self) -> Self {
                // NaN: what is computed from it is NaN too, whatever its derivatives are.
                let value = self.value;
                above.zip(below, |above, below| value.select(above, below))
            }
        }
    };
}

jet_scalar!(Jet1);
jet_scalar!(Jet2);

//! Floor 2. Jets: a function's value and first (second) derivatives at a point, as a scalar.
//!
//! The order is in the type: a derivative of a [`Jet2`] is a [`Jet1`], a derivative of a [`Jet1`] is a plain
//! scalar, so that a formula cannot use a derivative that is not there. Jets are fields themselves: Γ, written
//! once, gives Γ alone from first-order jets of g, and Γ with ∂Γ from second-order ones.

use crate::linalg::{Mat, Vector};
use crate::scalar::{Algebraic, Field, Real};
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// Value and first derivatives: `d[m]` is ∂_m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet1<T, const N: usize> {
    /// The value.
    pub value: T,
    /// `d[m]` = ∂_m of the value.
    pub d: [T; N],
}

/// Value, first and second derivatives: `dd[m][n]` is ∂_m∂_n, symmetric.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet2<T, const N: usize> {
    /// The value.
    pub value: T,
    /// `d[m]` = ∂_m of the value.
    pub d: [T; N],
    /// `dd[m][n]` = ∂_m∂_n of the value.
    pub dd: [[T; N]; N],
}

/// A scalar that knows its partial derivatives in N coordinates, one order lower.
pub trait Jet<const N: usize>: Field {
    /// The jet of one order less.
    type Lower: Field;
    /// ∂_m.
    fn d(&self, m: usize) -> Self::Lower;
    /// The same function, its highest derivatives forgotten.
    fn lower(&self) -> Self::Lower;
}

impl<T: Field, const N: usize> Jet<N> for Jet1<T, N> {
    type Lower = T;
    #[inline]
    fn d(&self, m: usize) -> T {
        self.d[m]
    }
    #[inline]
    fn lower(&self) -> T {
        self.value
    }
}

impl<T: Field, const N: usize> Jet<N> for Jet2<T, N> {
    type Lower = Jet1<T, N>;
    #[inline]
    fn d(&self, m: usize) -> Jet1<T, N> {
        Jet1 {
            value: self.d[m],
            d: self.dd[m],
        }
    }
    #[inline]
    fn lower(&self) -> Jet1<T, N> {
        Jet1 {
            value: self.value,
            d: self.d,
        }
    }
}

/// Every entry of a matrix of jets, one order lower.
#[inline]
pub fn lower<J: Jet<N>, const N: usize>(a: &Mat<J, N>) -> Mat<J::Lower, N> {
    a.map(|x| x.lower())
}

/// Every entry of a vector of jets, one order lower.
#[inline]
pub fn lower_vector<J: Jet<N>, const N: usize>(a: &Vector<J, N>) -> Vector<J::Lower, N> {
    a.map(|x| x.lower())
}

impl<T: Field, const N: usize> Jet1<T, N> {
    /// A constant: all derivatives vanish.
    #[inline]
    pub fn constant(value: T) -> Self {
        Self {
            value,
            d: [T::zero(); N],
        }
    }

    /// The m-th coordinate function where it takes this value.
    #[inline]
    pub fn coordinate(value: T, m: usize) -> Self {
        let mut jet = Self::constant(value);
        jet.d[m] = T::one();
        jet
    }

    /// f(self), from (f, f′, f″) at the value; the last is not needed here.
    #[inline]
    fn chain(self, (f, f1, _): (T, T, T)) -> Self {
        Self {
            value: f,
            d: self.d.map(|d| f1 * d),
        }
    }
}

impl<T: Field, const N: usize> Jet2<T, N> {
    /// A constant: all derivatives vanish.
    #[inline]
    pub fn constant(value: T) -> Self {
        Self {
            value,
            d: [T::zero(); N],
            dd: [[T::zero(); N]; N],
        }
    }

    /// The m-th coordinate function where it takes this value.
    #[inline]
    pub fn coordinate(value: T, m: usize) -> Self {
        let mut jet = Self::constant(value);
        jet.d[m] = T::one();
        jet
    }

    /// f(self), from (f, f′, f″) at the value.
    #[inline]
    fn chain(self, (f, f1, f2): (T, T, T)) -> Self {
        let mut jet = Self::constant(f);
        for m in 0..N {
            jet.d[m] = f1 * self.d[m];
            for n in 0..N {
                jet.dd[m][n] = f2 * self.d[m] * self.d[n] + f1 * self.dd[m][n];
            }
        }
        jet
    }
}

impl<T: Field, const N: usize> Add for Jet1<T, N> {
    type Output = Self;
    #[inline]
    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl<T: Field, const N: usize> AddAssign for Jet1<T, N> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        for m in 0..N {
            self.d[m] += other.d[m];
        }
    }
}

impl<T: Field, const N: usize> SubAssign for Jet1<T, N> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        self.value -= other.value;
        for m in 0..N {
            self.d[m] -= other.d[m];
        }
    }
}

impl<T: Field, const N: usize> Neg for Jet1<T, N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            d: self.d.map(|d| -d),
        }
    }
}

impl<T: Field, const N: usize> Mul for Jet1<T, N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let mut jet = Self::constant(self.value * other.value);
        for m in 0..N {
            jet.d[m] = self.value * other.d[m] + self.d[m] * other.value;
        }
        jet
    }
}

impl<T: Field, const N: usize> Div for Jet1<T, N> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let inverse = T::one() / other.value;
        let value = self.value * inverse;
        let mut jet = Self::constant(value);
        for m in 0..N {
            jet.d[m] = (self.d[m] - value * other.d[m]) * inverse;
        }
        jet
    }
}

impl<T: Field, const N: usize> Add for Jet2<T, N> {
    type Output = Self;
    #[inline]
    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl<T: Field, const N: usize> AddAssign for Jet2<T, N> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.value += other.value;
        for m in 0..N {
            self.d[m] += other.d[m];
            for n in 0..N {
                self.dd[m][n] += other.dd[m][n];
            }
        }
    }
}

impl<T: Field, const N: usize> SubAssign for Jet2<T, N> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self += -other;
    }
}

impl<T: Field, const N: usize> Neg for Jet2<T, N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            d: self.d.map(|d| -d),
            dd: self.dd.map(|row| row.map(|d| -d)),
        }
    }
}

impl<T: Field, const N: usize> Mul for Jet2<T, N> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (a, b) = (self, other);
        let mut jet = Self::constant(a.value * b.value);
        for m in 0..N {
            jet.d[m] = a.value * b.d[m] + a.d[m] * b.value;
            for n in 0..N {
                jet.dd[m][n] =
                    a.value * b.dd[m][n] + a.d[m] * b.d[n] + a.d[n] * b.d[m] + a.dd[m][n] * b.value;
            }
        }
        jet
    }
}

impl<T: Field, const N: usize> Div for Jet2<T, N> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let inverse = T::one() / other.value;
        let square = inverse * inverse;
        self * other.chain((inverse, -square, (square + square) * inverse))
    }
}

/// What both jets owe to the scalar below, by the chain rule.
macro_rules! jet_scalar {
    ($jet:ident) => {
        impl<T: Field, const N: usize> Sub for $jet<T, N> {
            type Output = Self;
            #[inline]
            fn sub(mut self, other: Self) -> Self {
                self -= other;
                self
            }
        }

        impl<T: Field, const N: usize> MulAssign for $jet<T, N> {
            #[inline]
            fn mul_assign(&mut self, other: Self) {
                *self = *self * other;
            }
        }

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
                let s = Self::constant(theta.sin());
                let c = Self::constant(theta.cos());
                let turned = ((sin * c - cos * s) / (cos * c + sin * s)).atan();
                turned + Self::constant(theta - turned.value)
            }
        }
    };
}

jet_scalar!(Jet1);
jet_scalar!(Jet2);

impl<T: Field, const N: usize> Jet1<T, N> {
    /// `f` of the value and of every derivative.
    #[inline]
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Jet1<U, N> {
        Jet1 {
            value: f(self.value),
            d: self.d.map(&f),
        }
    }
}

impl<T: Field, const N: usize> Jet2<T, N> {
    /// `f` of the value and of every derivative.
    #[inline]
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Jet2<U, N> {
        Jet2 {
            value: f(self.value),
            d: self.d.map(&f),
            dd: self.dd.map(|row| row.map(&f)),
        }
    }
}

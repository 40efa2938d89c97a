//! Floor 2. Jets: a function's value and first (second) derivatives at a point, as a scalar.
//!
//! The order is in the type: a derivative of a [`Jet2`] is a [`Jet1`], a derivative of a [`Jet1`] is a plain
//! scalar, so that a formula cannot use a derivative that is not there. Jets are fields themselves: Γ, written
//! once, gives Γ alone from first-order jets of g, and Γ with ∂Γ from second-order ones.

mod arithmetic;
mod functions;

use crate::linalg::{Mat, Vector, matrix, vector};
use crate::scalar::Field;

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
    matrix(|i, j| a[(i, j)].lower())
}

/// Every entry of a vector of jets, one order lower.
#[inline]
pub fn lower_vector<J: Jet<N>, const N: usize>(a: &Vector<J, N>) -> Vector<J::Lower, N> {
    vector(|i| a[i].lower())
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
    fn chain(mut self, (f, f1, _): (T, T, T)) -> Self {
        self.value = f;
        for m in 0..N {
            self.d[m] = f1 * self.d[m];
        }
        self
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

    /// The jet of these numbers: value, first derivatives, then ∂_m∂_n for m ≤ n, row by row.
    pub fn from_numbers(mut next: impl FnMut() -> T) -> Self {
        let mut jet = Self::constant(next());
        for m in 0..N {
            jet.d[m] = next();
        }
        for m in 0..N {
            for n in m..N {
                jet.dd[m][n] = next();
                jet.dd[n][m] = jet.dd[m][n];
            }
        }
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

impl<T: Field, const N: usize> Jet1<T, N> {
    /// `f` of the value and of every derivative.
    #[inline]
    pub fn map<U: Field>(self, f: impl Fn(T) -> U) -> Jet1<U, N> {
        let mut jet = Jet1::constant(f(self.value));
        for m in 0..N {
            jet.d[m] = f(self.d[m]);
        }
        jet
    }

    /// `f` of the values and of every two derivatives.
    #[inline]
    fn zip(mut self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        self.value = f(self.value, other.value);
        for m in 0..N {
            self.d[m] = f(self.d[m], other.d[m]);
        }
        self
    }
}

impl<T: Field, const N: usize> Jet2<T, N> {
    /// `f` of the value and of every derivative.
    #[inline]
    pub fn map<U: Field>(self, f: impl Fn(T) -> U) -> Jet2<U, N> {
        let mut jet = Jet2::constant(f(self.value));
        for m in 0..N {
            jet.d[m] = f(self.d[m]);
            for n in 0..N {
                jet.dd[m][n] = f(self.dd[m][n]);
            }
        }
        jet
    }

    /// `f` of the values and of every two derivatives.
    #[inline]
    fn zip(mut self, other: Self, f: impl Fn(T, T) -> T) -> Self {
        self.value = f(self.value, other.value);
        for m in 0..N {
            self.d[m] = f(self.d[m], other.d[m]);
            for n in 0..N {
                self.dd[m][n] = f(self.dd[m][n], other.dd[m][n]);
            }
        }
        self
    }
}

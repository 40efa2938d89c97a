//! Sums, products and quotients of jets: the rules of Leibniz.

use super::{Jet1, Jet2};
use crate::scalar::Field;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

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
    fn neg(mut self) -> Self {
        self.value = -self.value;
        for m in 0..N {
            self.d[m] = -self.d[m];
        }
        self
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
    fn neg(mut self) -> Self {
        self.value = -self.value;
        for m in 0..N {
            self.d[m] = -self.d[m];
            for n in 0..N {
                self.dd[m][n] = -self.dd[m][n];
            }
        }
        self
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

/// What follows from the rest.
macro_rules! derived {
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
    };
}

derived!(Jet1);
derived!(Jet2);

//! Floor 7. Approximate equality of the library's values, part by part (feature `approx`).
//!
//! A dual number has a derivative beside its value, a jet has several, lanes hold four numbers, a functional has three lists of
//! sums. Two such values are near each other if all of their parts are. `AbsDiffEq` and `RelativeEq` of the crate approx mean
//! just that for the types of this library, with a tolerance that is an `f64` and holds for each part.
//!
//! num-dual's own implementations compare the values alone, whatever the derivatives, as its `==` does. Bare dual numbers
//! and what is made of them without a type of this library (`Vec<Dual64>`, `Mat<Dual64, 3>`) are compared inside of
//! [`AllParts`]:
//!
//! ```
//! use approx::{assert_abs_diff_eq, assert_abs_diff_ne};
//! use num_dual::Dual64;
//! use regge_curvature::parts::AllParts;
//!
//! let (one, other) = (Dual64::new(1.0, 2.0), Dual64::new(1.0, 2.5));
//! assert_eq!(one, other); // by its real part alone
//! assert_abs_diff_ne!(AllParts(&one), AllParts(&other), epsilon = 1e-12);
//! assert_abs_diff_eq!(AllParts(&one), AllParts(&other), epsilon = 0.5);
//! ```
//!
//! With an `f64` for a tolerance, as our tests always say one, the lax comparison does not even compile:
//!
//! ```compile_fail
//! # use num_dual::Dual64;
//! # let (one, other) = (Dual64::new(1.0, 2.0), Dual64::new(1.0, 2.5));
//! approx::assert_abs_diff_eq!(one, other, epsilon = 1e-12);
//! ```

use crate::functional::{Action, ActionGradient, HessianEntry, HingeDefect, Sums, Three};
use crate::jet::{Jet1, Jet2};
#[cfg(feature = "lanes")]
use crate::scalar::Lanes;
use crate::spaces::ReggeFunction;
use approx::{AbsDiffEq, RelativeEq};
use nalgebra::{Const, Dim, Matrix, RawStorage};
use num_dual::{Derivative, Dual, Dual2, Dual3, DualSVec, HyperDual, HyperHyperDual};

/// A value made of `f64` parts.
pub trait Parts {
    /// Does `near` hold for every part of `self` with the same part of `other`? If one has parts that the other has not, the
    /// answer is no.
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool;
}

impl Parts for f64 {
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        near(*self, *other)
    }
}

/// Numbers of places, which are the same or not.
impl Parts for usize {
    fn all_near(&self, other: &Self, _: &dyn Fn(f64, f64) -> bool) -> bool {
        self == other
    }
}

impl<T: Parts> Parts for [T] {
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        self.len() == other.len()
            && self
                .iter()
                .zip(other.iter())
                .all(|(a, b)| a.all_near(b, near))
    }
}

impl<T: Parts, const N: usize> Parts for [T; N] {
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        self.as_slice().all_near(other, near)
    }
}

impl<T: Parts> Parts for Vec<T> {
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        self.as_slice().all_near(other, near)
    }
}

impl<T: Parts, R: Dim, C: Dim, S: RawStorage<T, R, C>> Parts for Matrix<T, R, C, S> {
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        self.shape() == other.shape()
            && self
                .iter()
                .zip(other.iter())
                .all(|(a, b)| a.all_near(b, near))
    }
}

/// num-dual leaves a derivative out that is known to vanish.
impl<T, const R: usize, const C: usize> Parts for Derivative<T, Const<R>, Const<C>>
where
    T: Parts + num_dual::DualNum + Copy,
{
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        let [one, two] = [self, other].map(|d| d.unwrap_generic(Const, Const));
        one.all_near(&two, near)
    }
}

/// Values that consist of their fields.
macro_rules! parts_are_fields {
    ($([$($generic:tt)*] $value:ty: $($field:ident)*;)*) => {$(
        impl<$($generic)*> Parts for $value {
            fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
                $(self.$field.all_near(&other.$field, near))&&*
            }
        }
    )*};
}
parts_are_fields! {
    [T: Parts] Dual<T>: re eps;
    [T: Parts] Dual2<T>: re v1 v2;
    [T: Parts] Dual3<T>: re v1 v2 v3;
    [T: Parts] HyperDual<T>: re eps1 eps2 eps1eps2;
    [T: Parts] HyperHyperDual<T>: re eps1 eps2 eps3 eps1eps2 eps1eps3 eps2eps3 eps1eps2eps3;
    [T: Parts + num_dual::DualNum + Copy, const D: usize] DualSVec<T, D>: re eps;
    [T: Parts, const N: usize] Jet1<T, N>: value d;
    [T: Parts, const N: usize] Jet2<T, N>: value d dd;
    [T: Parts] Sums<T>: cells faces hinges;
    [T: Parts] Three<T>: cells faces hinges;
    [T: Parts] Action<T>: interior boundary;
    [] ActionGradient: gradient schlaefli;
    [] HessianEntry: row column value;
    [] HingeDefect: hinge defect size;
}

#[cfg(feature = "lanes")]
impl Parts for Lanes {
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        self.to_array().all_near(&other.to_array(), near)
    }
}

/// On one space, the coefficients.
impl<C: Copy + Parts, const N: usize> Parts for ReggeFunction<C, N> {
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        self.space() == other.space() && self.coefficients().all_near(other.coefficients(), near)
    }
}

/// A value of any type, to be compared by all of its parts.
#[derive(Clone, Copy, Debug)]
pub struct AllParts<'a, P: ?Sized>(pub &'a P);

impl<P: Parts + ?Sized> PartialEq for AllParts<'_, P> {
    fn eq(&self, other: &Self) -> bool {
        self.0.all_near(other.0, &|a, b| a == b)
    }
}

impl<P: Parts + ?Sized> Parts for AllParts<'_, P> {
    fn all_near(&self, other: &Self, near: &dyn Fn(f64, f64) -> bool) -> bool {
        self.0.all_near(other.0, near)
    }
}

/// The traits of approx, for types with parts.
macro_rules! approximate {
    ($([$($generic:tt)*] $value:ty;)*) => {$(
        impl<$($generic)*> AbsDiffEq for $value {
            type Epsilon = f64;

            fn default_epsilon() -> f64 {
                f64::default_epsilon()
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
                self.all_near(other, &|a, b| a.abs_diff_eq(&b, epsilon))
            }
        }

        impl<$($generic)*> RelativeEq for $value {
            fn default_max_relative() -> f64 {
                f64::default_max_relative()
            }

            fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
                self.all_near(other, &|a, b| a.relative_eq(&b, epsilon, max_relative))
            }
        }
    )*};
}
approximate! {
    [P: Parts + ?Sized] AllParts<'_, P>;
    [T: Parts + PartialEq, const N: usize] Jet1<T, N>;
    [T: Parts + PartialEq, const N: usize] Jet2<T, N>;
    [T: Parts + PartialEq] Sums<T>;
    [T: Parts + PartialEq] Three<T>;
    [T: Parts + PartialEq] Action<T>;
    [] ActionGradient;
    [] HessianEntry;
    [] HingeDefect;
    [C: Copy + Parts + PartialEq, const N: usize] ReggeFunction<C, N>;
}

#[cfg(feature = "lanes")]
approximate! {
    [] Lanes;
}

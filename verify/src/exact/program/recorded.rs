//! The scalar that writes down what is done with it.

use super::{Program, Step};
use regge_curvature::scalar::{Algebraic, Field};
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// A number of which only the way is known by which it was computed: a place in the program of this thread.
///
/// Products with 0 and 1, sums with 0, operations between constants and roots of their squares leave no step behind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Recorded(u32);

/// The program that is being written.
#[derive(Default)]
struct Recorder {
    program: Program,
    places: HashMap<Step, u32>,
}

thread_local! {
    static RECORDER: RefCell<Recorder> = RefCell::default();
}

/// The program of `f`, which is given so many inputs, and what it returned.
///
/// Recorded numbers mean something inside `f`, and afterwards as places of this program. The program belongs to the thread:
/// `f` may not record another one, and may not hand its numbers to other threads.
pub fn record<T>(inputs: usize, f: impl FnOnce(&[Recorded]) -> T) -> (Program, T) {
    RECORDER.take();
    let inputs: Vec<Recorded> = (0..inputs).map(|k| step(Step::Input(k as u32))).collect();
    let result = f(&inputs);
    (RECORDER.take().program, result)
}

/// The place of a step, which is written down if it is new.
fn step(step: Step) -> Recorded {
    RECORDER.with_borrow_mut(|recorder| {
        let steps = &mut recorder.program.steps;
        let place = *recorder.places.entry(step).or_insert_with(|| {
            steps.push(step);
            u32::try_from(steps.len() - 1).expect("a program has fewer than 2³² steps")
        });
        Recorded(place)
    })
}

impl Recorded {
    /// Its place among the steps.
    pub fn place(self) -> usize {
        self.0 as usize
    }

    /// The rational number that it is, whatever the inputs.
    fn constant(self) -> Option<(i64, i64)> {
        let step = RECORDER.with_borrow(|r| r.program.steps[self.place()]);
        match step {
            Step::Constant(n, d) => Some((n, d)),
            _ => None,
        }
    }

    fn is(self, n: i64) -> bool {
        self.constant() == Some((n, 1))
    }

    /// n/d in lowest terms, unless it is undefined or too large.
    fn rational(n: i128, d: i128) -> Option<Self> {
        let divisor = gcd(n, d) * d.signum();
        let (n, d) = (n.checked_div(divisor)?, d.checked_div(divisor)?);
        Some(step(Step::Constant(n.try_into().ok()?, d.try_into().ok()?)))
    }

    /// The constant that `f` makes of two constants.
    fn folded(self, other: Self, f: fn([i128; 4]) -> (i128, i128)) -> Option<Self> {
        let ((a, b), (c, d)) = (self.constant()?, other.constant()?);
        let (n, d) = f([a, b, c, d].map(i128::from));
        Self::rational(n, d)
    }
}

/// The greatest common divisor, not negative.
fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.abs()
}

/// a/b + c/d, not in lowest terms.
fn sum([a, b, c, d]: [i128; 4]) -> (i128, i128) {
    (a * d + c * b, b * d)
}

/// a/b − c/d.
fn difference([a, b, c, d]: [i128; 4]) -> (i128, i128) {
    (a * d - c * b, b * d)
}

/// a/b · c/d.
fn product([a, b, c, d]: [i128; 4]) -> (i128, i128) {
    (a * c, b * d)
}

/// a/b over c/d.
fn quotient([a, b, c, d]: [i128; 4]) -> (i128, i128) {
    (a * d, b * c)
}

/// The two operands of an operation that does not mind their order.
fn sorted(a: Recorded, b: Recorded) -> (u32, u32) {
    (a.0.min(b.0), a.0.max(b.0))
}

impl Add for Recorded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.is(0) {
            return other;
        }
        if other.is(0) {
            return self;
        }
        let constant = self.folded(other, sum);
        let (a, b) = sorted(self, other);
        constant.unwrap_or_else(|| step(Step::Sum(a, b)))
    }
}

impl Sub for Recorded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        if other.is(0) {
            return self;
        }
        if self.is(0) {
            return -other;
        }
        let constant = self.folded(other, difference);
        constant.unwrap_or_else(|| step(Step::Difference(self.0, other.0)))
    }
}

impl Mul for Recorded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self.is(0) || other.is(1) {
            return self;
        }
        if other.is(0) || self.is(1) {
            return other;
        }
        let constant = self.folded(other, product);
        let (a, b) = sorted(self, other);
        constant.unwrap_or_else(|| step(Step::Product(a, b)))
    }
}

impl Div for Recorded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.is(1) {
            return self;
        }
        if self.is(0) && !other.is(0) {
            return self;
        }
        let constant = self.folded(other, quotient);
        constant.unwrap_or_else(|| step(Step::Quotient(self.0, other.0)))
    }
}

impl Neg for Recorded {
    type Output = Self;
    fn neg(self) -> Self {
        let constant = Self::zero().folded(self, difference);
        constant.unwrap_or_else(|| step(Step::Opposite(self.0)))
    }
}

impl AddAssign for Recorded {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Recorded {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Recorded {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Field for Recorded {
    fn from_int(n: i64) -> Self {
        step(Step::Constant(n, 1))
    }

    fn ratio(n: i64, d: i64) -> Self {
        let constant = Self::rational(n.into(), d.into());
        constant.unwrap_or_else(|| Self::from_int(n) / Self::from_int(d))
    }
}

impl Algebraic for Recorded {
    fn sqrt(self) -> Self {
        let root = |x: i64| x.checked_isqrt().filter(|root| root * root == x);
        let constant = self.constant().and_then(|(n, d)| root(n).zip(root(d)));
        match constant {
            Some((n, d)) => step(Step::Constant(n, d)),
            None => step(Step::Root(self.0)),
        }
    }
}

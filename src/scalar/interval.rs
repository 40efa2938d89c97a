//! Enclosures: intervals that contain what real numbers would have given, through the same kernels.
//!
//! Sums, products, quotients and roots of floating point numbers are rounded to the nearest. In which direction is known from
//! the remainder, which is computed without error; the next number on that side encloses the exact result, and what is not
//! rounded stays as it is. There is no order between intervals, and the rounding mode is never changed.

use super::{Algebraic, Field};
use std::f64::consts::PI;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

/// All real numbers from one to another. What does not exist (1/0, the root of what may be negative) is NaN to NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
}

impl Interval {
    /// What need not exist.
    const UNDEFINED: Self = Self {
        low: f64::NAN,
        high: f64::NAN,
    };

    /// The number x and no other.
    pub fn exactly(x: f64) -> Self {
        Self { low: x, high: x }
    }

    /// π.
    pub fn pi() -> Self {
        // The nearest number is below π.
        Self {
            low: PI,
            high: PI.next_up(),
        }
    }

    /// The least number that it may be.
    pub fn low(self) -> f64 {
        self.low
    }

    /// The largest number that it may be.
    pub fn high(self) -> f64 {
        self.high
    }

    /// Could it be x?
    pub fn contains(self, x: f64) -> bool {
        self.low <= x && x <= self.high
    }

    /// Is it positive, whichever of its numbers it is? Not if it does not exist.
    pub fn is_positive(self) -> bool {
        self.low > 0.0
    }

    /// What it has in common with another enclosure of the same number.
    pub fn meet(self, other: Self) -> Self {
        Self::between(self.low.max(other.low), self.high.min(other.high))
    }

    /// How far apart its ends are, rounded up.
    pub fn width(self) -> f64 {
        (self.high - self.low).next_up()
    }

    /// The only integer in it, if there is one and one only.
    pub fn integer(self) -> Option<i64> {
        let (first, last) = (self.low.ceil(), self.high.floor());
        // Larger ones are not all floating point numbers.
        (first == last && first.abs() < 1e15).then_some(first as i64)
    }

    /// From one bound to the other; undefined if one of them does not exist, as ∞ − ∞ does not.
    fn between(low: f64, high: f64) -> Self {
        if low.is_nan() || high.is_nan() {
            return Self::UNDEFINED;
        }
        Self { low, high }
    }

    /// From the least to the largest of these bounds; undefined if one of them is.
    fn around(ends: [[f64; 2]; 4]) -> Self {
        if ends.iter().flatten().any(|x| x.is_nan()) {
            return Self::UNDEFINED;
        }
        let low = ends.iter().map(|e| e[0]).fold(f64::INFINITY, f64::min);
        let high = ends.iter().map(|e| e[1]).fold(f64::NEG_INFINITY, f64::max);
        Self { low, high }
    }

    /// The smallest interval that contains both; undefined if one of them is.
    pub fn hull(self, other: Self) -> Self {
        if self.low.is_nan() || other.low.is_nan() {
            return Self::UNDEFINED;
        }
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    /// The angle in (0, π) with this positive sine and this cosine, which need not be normalised.
    ///
    /// It falls with the cosine; with the sine it rises where the cosine is positive and falls where it is negative. So its
    /// bounds are taken at corners.
    pub fn angle(sin: Self, cos: Self) -> Self {
        if !sin.is_positive() {
            return Self::UNDEFINED;
        }
        let least = point_angle(if cos.high > 0.0 { sin.low } else { sin.high }, cos.high);
        let most = point_angle(if cos.low > 0.0 { sin.high } else { sin.low }, cos.low);
        least.hull(most)
    }
}

/// A rounded result and the number by which the exact one is larger, of which the sign counts: bounds of the exact one. Where
/// the difference may be rounded itself, as it is where numbers are tiny, or does not exist, both neighbours are.
fn bounds(rounded: f64, more: f64) -> [f64; 2] {
    // The difference is about 2⁻⁵³ of the result, and its terms have twice as many digits.
    const TINY: f64 = 1e-200;
    if rounded.abs() < TINY || !rounded.is_finite() || more.is_nan() {
        return [rounded.next_down(), rounded.next_up()];
    }
    if more > 0.0 {
        [rounded, rounded.next_up()]
    } else if more < 0.0 {
        [rounded.next_down(), rounded]
    } else {
        [rounded; 2]
    }
}

/// Of a + b. (The difference is exact: Knuth.)
fn sum(a: f64, b: f64) -> [f64; 2] {
    let sum = a + b;
    let other = sum - a;
    let more = (a - (sum - other)) + (b - other);
    // Tiny sums are exact.
    if more == 0.0 {
        [sum; 2]
    } else {
        bounds(sum, more)
    }
}

/// Of ab.
fn product(a: f64, b: f64) -> [f64; 2] {
    if (a == 0.0 && b.is_finite()) || (b == 0.0 && a.is_finite()) {
        return [0.0; 2];
    }
    let product = a * b;
    bounds(product, a.mul_add(b, -product))
}

/// Of a/b.
fn quotient(a: f64, b: f64) -> [f64; 2] {
    if a == 0.0 && b.is_finite() {
        return [0.0; 2];
    }
    let quotient = a / b;
    let rest = (-quotient).mul_add(b, a);
    // The remainder is exact unless it is tiny itself.
    let more = if a.abs() < 1e-200 {
        f64::NAN
    } else {
        rest * b.signum()
    };
    bounds(quotient, more)
}

/// Of √x, x ≥ 0.
fn root(x: f64) -> [f64; 2] {
    if x == 0.0 {
        return [0.0; 2];
    }
    let root = x.sqrt();
    let more = if x < 1e-200 {
        f64::NAN
    } else {
        (-root).mul_add(root, x)
    };
    let [low, high] = bounds(root, more);
    [low.max(0.0), high]
}

/// θ with tan θ = s/c, s > 0: halved four times by tan(θ/2) = s/(r + c) and t/(1 + √(1 + t²)), then by the series.
fn point_angle(s: f64, c: f64) -> Interval {
    let (s, c) = (Interval::exactly(s), Interval::exactly(c));
    if c.low < 0.0 {
        return Interval::pi() - acute_angle(s, -c);
    }
    acute_angle(s, c)
}

/// The same where c ≥ 0.
fn acute_angle(s: Interval, c: Interval) -> Interval {
    let one = Interval::one();
    let mut t = s / ((s * s + c * c).sqrt() + c);
    for _ in 0..3 {
        t = t / (one + (one + t * t).sqrt());
    }
    // t ≤ tan(π/32) < 0.1: terms fall by a factor of a hundred, with alternating signs, so that the rest is less than the
    // first one left out.
    let square = t * t;
    let (mut power, mut sum) = (t, t);
    for k in 1..=9 {
        power = -(power * square);
        let term = power * Interval::ratio(1, 2 * k + 1);
        sum = if k < 9 {
            sum + term
        } else {
            sum.hull(sum + term)
        };
    }
    sum * Interval::from_int(16)
}

impl Add for Interval {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::between(sum(self.low, other.low)[0], sum(self.high, other.high)[1])
    }
}

impl Sub for Interval {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Interval {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::around([
            product(self.low, other.low),
            product(self.low, other.high),
            product(self.high, other.low),
            product(self.high, other.high),
        ])
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        // Not if the divisor is NaN, either.
        if !(other.low > 0.0 || other.high < 0.0) {
            return Self::UNDEFINED;
        }
        Self::around([
            quotient(self.low, other.low),
            quotient(self.low, other.high),
            quotient(self.high, other.low),
            quotient(self.high, other.high),
        ])
    }
}

impl Neg for Interval {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            low: -self.high,
            high: -self.low,
        }
    }
}

impl AddAssign for Interval {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Interval {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign for Interval {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl Field for Interval {
    /// Integers beyond 2⁵³ are rounded, and enclosed.
    fn from_int(n: i64) -> Self {
        let x = n as f64;
        if n.unsigned_abs() <= 1 << f64::MANTISSA_DIGITS {
            Self::exactly(x)
        } else {
            Self {
                low: x.next_down(),
                high: x.next_up(),
            }
        }
    }

    fn half() -> Self {
        Self::exactly(0.5)
    }
}

impl Algebraic for Interval {
    /// Undefined if it may be negative.
    fn sqrt(self) -> Self {
        if self.low >= 0.0 {
            Self {
                low: root(self.low)[0],
                high: root(self.high)[1],
            }
        } else {
            Self::UNDEFINED
        }
    }
}

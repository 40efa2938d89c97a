//! Formulas in the coordinates, evaluated over any real scalar: at jets, their derivatives are exact.

mod code;
mod function;
mod names;
mod parse;
#[cfg(test)]
mod tests;
mod token;

use function::{Callable, FUNCTIONS};
use names::Names;
pub(super) use names::nearest;
use regge_curvature::scalar::Real;
use std::fmt;

/// How deep brackets, signs and powers may be nested.
pub const LARGEST_DEPTH: usize = 100;

/// How long a formula may be, in bytes: what computer algebra writes fits.
pub const LARGEST_LENGTH: usize = 1 << 20;

/// The functions that a formula may call, as they are written: `sqrt(a)`, `atan2(a, b)`, `min(a, b, ...)`.
pub fn functions() -> Vec<String> {
    FUNCTIONS.iter().map(|(name, f)| f.written(name)).collect()
}

/// A formula, ready to be evaluated.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    code: Vec<code::Op>,
    depth: usize,
}

/// Why a text is no formula.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpressionError {
    /// Where, in characters from 1.
    pub column: usize,
    /// Why.
    pub reason: String,
}

impl std::error::Error for ExpressionError {}

impl fmt::Display for ExpressionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "column {}: {}", self.column, self.reason)
    }
}

impl ExpressionError {
    fn new(column: usize, reason: impl Into<String>) -> Self {
        Self {
            column,
            reason: reason.into(),
        }
    }
}

impl Expression {
    /// Reads a formula in `dimension` coordinates: x1, x2, …, and up to three also x, y, z.
    ///
    /// Operators by precedence: ^ (from the right), the sign, * and /, + and −. Functions: those of [`functions`].
    /// Constants: pi, e.
    ///
    /// # Errors
    /// Names the column and what is wrong there.
    pub fn parse(text: &str, dimension: usize) -> Result<Self, ExpressionError> {
        let code = parse::parse(text, &Names::new(dimension))?;
        let depth = code::depth(&code);
        Ok(Self { code, depth })
    }

    /// The names of the functions in it that have a kink or a jump, each once.
    pub fn kinks(&self) -> Vec<&'static str> {
        let used = |callable: &Callable| match callable {
            Callable::One(f) => f.has_kink() && self.code.contains(&code::Op::Call(*f)),
            Callable::Two(f) | Callable::More(f) => {
                f.has_kink() && self.code.contains(&code::Op::Pair(*f))
            }
            Callable::Power => false,
        };
        let found = FUNCTIONS.iter().filter(|(_, callable)| used(callable));
        found.map(|(name, _)| *name).collect()
    }

    /// The value at x.
    ///
    /// # Panics
    /// If x has fewer coordinates than the formula was read for.
    pub fn at<S: Real>(&self, x: &[S]) -> S {
        code::run(&self.code, self.depth, x)
    }
}

//! Formulas in the coordinates, evaluated over any real scalar: at jets, their derivatives are exact.

mod code;
mod derivative;
mod function;
mod graph;
mod lower;
mod names;
mod parse;
mod program;
#[cfg(test)]
mod tests;
mod token;

use function::{Callable, FUNCTIONS};
use graph::Graph;
use names::Names;
pub(super) use names::nearest;
use program::Program;
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
    program: Program,
}

/// Several formulas, ready to be evaluated together: what they have in common is computed once.
#[derive(Clone, Debug, PartialEq)]
pub struct Expressions {
    formulas: Vec<Expression>,
    program: Program,
}

/// The first derivatives of several formulas, ready to be evaluated together.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradients {
    program: Program,
    /// How many derivatives each formula has.
    coordinates: usize,
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
        let program = program_of(&[&code]);
        Ok(Self { code, program })
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
        let mut result = S::zero();
        self.program.run(x, |_, value| result = value);
        result
    }
}

impl Expressions {
    /// These formulas, in the same coordinates.
    pub fn new(formulas: Vec<Expression>) -> Self {
        let codes: Vec<&[code::Op]> = formulas.iter().map(|f| &f.code[..]).collect();
        let program = program_of(&codes);
        Self { formulas, program }
    }

    /// One by one.
    pub fn formulas(&self) -> &[Expression] {
        &self.formulas
    }

    /// Their first derivatives by the coordinates x1, …, x_n.
    pub fn gradients(&self, n: usize) -> Gradients {
        let mut graph = Graph::default();
        let codes = self.formulas.iter().map(|f| &f.code);
        let results: Vec<u32> = codes.map(|code| graph.add(code)).collect();
        let by_coordinate: Vec<_> = (0..n).map(|m| graph.derivatives(&results, m)).collect();
        let derivatives: Vec<u32> = (0..results.len())
            .flat_map(|k| by_coordinate.iter().map(move |of| of[k]))
            .collect();
        Gradients {
            program: Program::new(&graph, &derivatives),
            coordinates: n,
        }
    }

    /// `take(i, value)` with the value of the i-th formula at x, for all of them in order.
    ///
    /// # Panics
    /// If x has fewer coordinates than the formulas were read for.
    pub fn at<S: Real>(&self, x: &[S], take: impl FnMut(usize, S)) {
        self.program.run(x, take);
    }
}

impl Gradients {
    /// `take(m, value)` with the value of ∂_m at x, for all m of the first formula, then of the second, and so on.
    ///
    /// # Panics
    /// If x has fewer coordinates than the formulas were read for.
    pub fn at<S: Real>(&self, x: &[S], mut take: impl FnMut(usize, S)) {
        let n = self.coordinates;
        self.program.run(x, |k, value| take(k % n, value));
    }
}

fn program_of(codes: &[&[code::Op]]) -> Program {
    let mut graph = Graph::default();
    let results: Vec<u32> = codes.iter().map(|code| graph.add(code)).collect();
    Program::new(&graph, &results)
}

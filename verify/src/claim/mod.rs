//! The harness: what a claim is, how it is judged, and how forgeries are made of it.
//!
//! A claim yields [`Equation`]s with named terms, one set for every random instance. The [`Tally`] judges them and
//! forges every term in three ways: it drops, flips and doubles it. A claim passes if all its equations hold *and*
//! every forgery is caught wherever its term does not vanish. Where a term vanishes identically, the claim says
//! so, and that is checked as well.

mod check;
mod equation;
mod pointwise;
mod scalar;
pub mod seed;
mod tally;
mod weighted;

pub use check::{Budget, Check, ENOUGH, Excuses};
pub use equation::{Components, Equation, Forged, Relation, Term};
pub use pointwise::{Over, Pointwise, PointwiseCheck};
pub use scalar::{Ground, Timed};
pub use tally::{Case, Tally};

use serde::Serialize;

/// What a page says of a claim, whatever the dimension.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// The row of the catalogue: `P13`.
    pub label: &'static str,
    /// The labels of the paper's LaTeX source; none for what the paper does not print.
    pub paper: &'static [&'static str],
    /// A name for it.
    pub title: &'static str,
    /// The statement, in LaTeX (math mode).
    pub statement: &'static str,
    /// What keeps the two sides apart: which functions each of them uses.
    pub sides: &'static str,
}

/// Where the numbers of a run come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Derivatives by automatic differentiation in floating point numbers.
    Ad,
    /// Over a prime field.
    Exact,
    /// Against numbers or formulas with a source outside this project.
    Oracle,
    /// By integrating along a path of metrics.
    Homotopy,
}

impl Method {
    /// As reports write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ad => "AD",
            Self::Exact => "exact",
            Self::Oracle => "oracle",
            Self::Homotopy => "homotopy",
        }
    }
}

/// How the residual of an equation is judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Judgement {
    /// Equality in the field. A false identity survives one draw with probability ≤ degree/p.
    Exact {
        /// A bound of the degree of the identity, cleared of denominators and roots.
        degree: f64,
    },
    /// |left − right| over the sum of the terms' magnitudes is at most this.
    Rounding {
        /// The bound.
        tolerance: f64,
    },
    /// The same at the highest quadrature order, where the residual must have fallen to this.
    Quadrature {
        /// The bound.
        tolerance: f64,
    },
    /// A fitted order lies in a band: the residual is its distance from the middle over half of the width.
    Rate,
    /// left ≤ right: the residual is left/right, and at most 1 (up to rounding).
    Bound,
}

impl Judgement {
    /// What a residual may be at most.
    pub fn tolerance(self) -> f64 {
        match self {
            Self::Exact { .. } => 0.0,
            Self::Rounding { tolerance } | Self::Quadrature { tolerance } => tolerance,
            Self::Rate => 1.0,
            // A few units in the last place of a quotient.
            Self::Bound => 1.0 + 1e-12,
        }
    }

    /// log₂ of the probability that a false identity survives this many independent draws.
    pub fn false_accept_log2(self, draws: usize) -> Option<f64> {
        match self {
            Self::Exact { degree } => Some(draws as f64 * (degree.log2() - 61.0)),
            _ => None,
        }
    }
}

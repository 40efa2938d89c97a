//! How a claim is checked, and what its residuals may be.

use serde::Serialize;

/// Where the numbers of a run come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// Derivatives by automatic differentiation in floating point numbers.
    Ad,
    /// Over prime fields.
    Exact,
    /// Over rational numbers, at points that determine an identity.
    Proof,
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
            Self::Proof => "proof",
            Self::Oracle => "oracle",
            Self::Homotopy => "homotopy",
        }
    }
}

/// How the residual of an equation is judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Judgement {
    /// Equality in the field. How likely a false identity survives is the matter of a [`Bound`](super::Bound).
    Exact,
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
            Self::Exact => 0.0,
            Self::Rounding { tolerance } | Self::Quadrature { tolerance } => tolerance,
            Self::Rate => 1.0,
            // A few units in the last place of a quotient.
            Self::Bound => 1.0 + 1e-12,
        }
    }
}

//! The local L² projection inside the averages, by name.

use crate::named::Named;
use crate::printed_rules::printed_rule;
use regge_curvature::interpolate::Interpolant;

/// The local L² projection inside the averages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProjectionKind {
    /// To rounding where the mesh resolves g.
    Exact,
    /// By a rule of exactness 2r only, as in the printed tables.
    Discrete,
}

impl Named for ProjectionKind {
    const KIND: &'static str = "projection";

    fn all() -> Vec<Self> {
        vec![Self::Exact, Self::Discrete]
    }

    fn name_of(&self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Discrete => "discrete",
        }
    }
}

impl ProjectionKind {
    /// The interpolant with this projection, if it has one at all.
    pub fn inside(self, interpolant: Interpolant) -> Interpolant {
        match self {
            Self::Discrete if interpolant.projects() => {
                interpolant.projected_by(|dimension, degree| printed_rule(dimension, 2 * degree))
            }
            Self::Exact | Self::Discrete => interpolant,
        }
    }
}

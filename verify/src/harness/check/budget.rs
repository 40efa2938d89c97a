//! How much is done: of a run, and of one check.

use regge_curvature::formulas::{Formulas, PAPER};

/// How much work one entry may do, and where its randomness comes from.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// The run's seed.
    pub seed: u64,
    /// A quicker draw: fewer instances, fewer and smaller meshes, lower orders.
    pub quick: bool,
    /// By which formulas the library computes.
    pub formulas: Formulas,
}

impl Budget {
    /// The full catalogue.
    pub fn full(seed: u64) -> Self {
        Self {
            seed,
            quick: false,
            formulas: PAPER,
        }
    }

    /// What `cargo test` runs.
    pub fn quick(seed: u64) -> Self {
        Self {
            seed,
            quick: true,
            formulas: PAPER,
        }
    }
}

/// How many random instances a check has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cases {
    /// In a full run.
    pub full: usize,
    /// In a quick one.
    pub quick: usize,
}

impl Cases {
    pub(super) fn of(self, budget: &Budget) -> usize {
        if budget.quick { self.quick } else { self.full }
    }
}

/// Is this one of the dimensions?
pub const fn has(dimensions: &[usize], dimension: usize) -> bool {
    let mut i = 0;
    while i < dimensions.len() {
        if dimensions[i] == dimension {
            return true;
        }
        i += 1;
    }
    false
}

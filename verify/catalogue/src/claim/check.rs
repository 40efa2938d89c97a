//! What the run sees of a claim: something that can be checked, in one dimension, by one method.

use super::{Method, Record};
use crate::report::Entry;

/// How much work one entry may do.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// The run's seed.
    pub seed: u64,
    /// Random instances in floating point numbers.
    pub cases: usize,
    /// Random instances over the prime field.
    pub exact_cases: usize,
    /// A quicker draw: fewer and smaller meshes, lower orders.
    pub quick: bool,
}

impl Budget {
    /// The full catalogue: 24 instances in each of four dimensions, 8 more over the field.
    pub fn full(seed: u64) -> Self {
        Self {
            seed,
            cases: 24,
            exact_cases: 8,
            quick: false,
        }
    }

    /// What `cargo test` runs.
    pub fn quick(seed: u64) -> Self {
        Self {
            seed,
            cases: 6,
            exact_cases: 4,
            quick: true,
        }
    }
}

/// One claim in one dimension by one method: one entry of the report.
pub trait Check: Send + Sync {
    /// What the page says.
    fn record(&self) -> &'static Record;
    /// N.
    fn dimension(&self) -> usize;
    /// How.
    fn method(&self) -> Method;
    /// Does all its cases.
    fn run(&self, budget: &Budget) -> Entry;
}

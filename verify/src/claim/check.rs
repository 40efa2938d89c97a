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

/// What a claim need not do, and why.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Excuses {
    /// Why no second method checks it.
    pub one_method: Option<&'static str>,
    /// Why it has fewer than [`ENOUGH`] random instances.
    pub few_cases: Option<&'static str>,
}

impl Excuses {
    /// None.
    pub const NONE: Self = Self {
        one_method: None,
        few_cases: None,
    };

    /// There is one method only.
    pub const fn one_method(why: &'static str) -> Self {
        Self {
            one_method: Some(why),
            few_cases: None,
        }
    }

    /// There are as many instances as there are.
    pub const fn few_cases(self, why: &'static str) -> Self {
        Self {
            few_cases: Some(why),
            ..self
        }
    }
}

/// How many random instances a claim has by one of its methods at least, over its dimensions and degrees.
pub const ENOUGH: usize = 64;

/// One claim in one dimension by one method: one entry of the report.
pub trait Check: Send + Sync {
    /// What the page says.
    fn record(&self) -> &'static Record;
    /// N.
    fn dimension(&self) -> usize;
    /// How.
    fn method(&self) -> Method;
    /// How many cases it has.
    fn cases(&self, budget: &Budget) -> usize;
    /// What it need not do. Of several checks of a claim one is enough to say so.
    fn excuses(&self) -> Excuses {
        Excuses::NONE
    }
    /// Does all its cases.
    fn run(&self, budget: &Budget) -> Entry;
}

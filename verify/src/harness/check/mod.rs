//! A claim in one dimension by one method, as data, and how it is run.

mod budget;
mod meshes;
mod numbers;

pub use budget::{Budget, Cases, has};
pub use meshes::OnMeshes;
pub use numbers::OnNumbers;

use super::case::Key;
use super::entry::Entry;
use super::judgement::Method;
use super::record::{Excuses, Record};
use super::scalar::Ground;
use crate::exact::Fp;

/// One claim in one dimension by one method: one entry of the report.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// What the page says.
    pub record: &'static Record,
    /// N.
    pub dimension: usize,
    /// How.
    pub method: Method,
    /// What it need not do. Of several checks of a claim one is enough to say so.
    pub excuses: Excuses,
    /// What is drawn, and what is computed from it.
    pub kind: Kind,
}

/// The claims that are to be checked, in their order.
pub type Catalogue = Vec<Check>;

/// What a check draws: one kind for each scalar in which residuals are taken, and one for meshes. The harness is
/// compiled once for each, however many claims there are.
#[derive(Clone, Copy, Debug)]
pub enum Kind {
    /// Floating point numbers.
    Real(OnNumbers<f64>),
    /// Elements of the prime field.
    Exact(OnNumbers<Fp>),
    /// Fields on meshes.
    Mesh(OnMeshes),
}

impl Check {
    /// How many cases it has.
    pub fn cases(&self, budget: &Budget) -> usize {
        match &self.kind {
            Kind::Real(check) => check.cases.of(budget),
            Kind::Exact(check) => check.cases.of(budget),
            Kind::Mesh(check) => check.settings(self.dimension, budget.quick).len(),
        }
    }

    /// Does all its cases.
    pub fn run(&self, budget: &Budget) -> Entry {
        let (key, cases) = (self.key(budget), self.cases(budget));
        let (tally, scalar) = match &self.kind {
            Kind::Real(check) => (check.run(key, cases, &budget.formulas), f64::NAME),
            Kind::Exact(check) => (check.run(key, cases, &budget.formulas), Fp::NAME),
            Kind::Mesh(check) => (check.run(key, budget.quick, &budget.formulas), f64::NAME),
        };
        let mut entry = tally.finish(self.record, self.dimension, scalar, self.method);
        entry.one_method = self.excuses.one_method.map(str::to_owned);
        entry.few_cases = self.excuses.few_cases.map(str::to_owned);
        entry
    }

    /// Where the randomness of its first case comes from.
    fn key(&self, budget: &Budget) -> Key<'static> {
        Key {
            seed: budget.seed,
            label: self.record.label,
            dimension: self.dimension,
            method: self.method.name(),
            case: 0,
        }
    }
}

//! A claim in one dimension by one method, as data, and how it is run.

mod budget;
mod integrals;
mod meshes;
mod numbers;
mod programs;

pub use budget::{Budget, Cases, has};
pub use integrals::Integrals;
pub use meshes::OnMeshes;
pub use numbers::OnNumbers;
pub use programs::OnPrograms;

use super::case::Key;
use super::entry::{Entry, Verdict};
use super::judgement::{Judgement, Method};
use super::proof::{Goal, Outcome, Proofs};
use super::record::{Excuses, Record};
use super::scalar::Drawn;
use super::tally::Tally;
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
    /// Elements of two prime fields, of which integrals are made.
    Integrals(Integrals),
    /// Elements of two prime fields, over which recorded programs are run.
    Programs(OnPrograms),
    /// Nothing: the points are those that determine the claim.
    Proof(Proofs),
    /// Fields on meshes.
    Mesh(OnMeshes),
}

impl Check {
    /// How many cases it has.
    pub fn cases(&self, budget: &Budget) -> usize {
        match &self.kind {
            Kind::Real(check) => check.cases.of(budget),
            Kind::Integrals(check) => check.cases.of(budget),
            Kind::Programs(check) => check.cases.of(budget),
            // There is no chance in it.
            Kind::Proof(_) => 1,
            Kind::Mesh(check) => check.settings(self.dimension, budget.quick).len(),
        }
    }

    /// Does all its cases.
    pub fn run(&self, budget: &Budget) -> Entry {
        let (key, cases) = (self.key(budget), self.cases(budget));
        let finish =
            |tally: Tally, scalar| tally.finish(self.record, self.dimension, scalar, self.method);
        let exactly = |(tally, bound, chance)| Entry {
            bound: Some(bound),
            false_accept_log2: Some(chance),
            ..finish(tally, Fp::NAME)
        };
        let mut entry = match &self.kind {
            Kind::Real(check) => finish(check.run(key, cases, &budget.formulas), f64::NAME),
            Kind::Mesh(check) => finish(check.run(key, budget.quick, &budget.formulas), f64::NAME),
            Kind::Proof(check) => self.proved(check.run(key, &budget.formulas)),
            Kind::Integrals(check) => exactly(check.run(key, cases, &budget.formulas)),
            Kind::Programs(check) => exactly(check.run(key, cases, &budget.formulas)),
        };
        entry.on_meshes = matches!(self.kind, Kind::Mesh(_) | Kind::Integrals(_));
        entry.one_method = self.excuses.one_method.map(str::to_owned);
        entry.few_cases = self.excuses.few_cases.map(str::to_owned);
        entry
    }

    /// What it proves, as programs; nothing where it proves nothing.
    pub fn goals(&self, budget: &Budget) -> Vec<Goal> {
        match &self.kind {
            Kind::Proof(check) => check.goals(self.key(budget), &budget.formulas),
            _ => Vec::new(),
        }
    }

    fn proved(&self, outcome: Outcome) -> Entry {
        let holds = outcome.failure.is_none() && outcome.forgeries.iter().all(|f| f.caught);
        let tally = Tally::new(Judgement::Exact);
        Entry {
            cases: outcome.proof.points,
            proof: Some(outcome.proof),
            verdict: if holds { Verdict::Pass } else { Verdict::Fail },
            forgeries: outcome.forgeries,
            vacuous: outcome.vacuous,
            failure: outcome.failure,
            ..tally.finish(self.record, self.dimension, "ℚ", self.method)
        }
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

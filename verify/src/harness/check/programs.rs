//! Checks over prime fields: the claim is recorded once, as the program that the library's code executes, and run at random
//! elements of two fields.

use super::budget::Cases;
use crate::exact::{Fp, Fq, Program, Recorded, record};
use crate::harness::bound::{Bound, identities};
use crate::harness::case::Key;
use crate::harness::equation::Equation;
use crate::harness::judgement::Judgement;
use crate::harness::proof::AtPoints;
use crate::harness::scalar::{Drawn, Ground};
use crate::harness::tally::{Case, Tally};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use regge_curvature::formulas::Formulas;

/// Equations between things that are made of numbers by algebra alone.
#[derive(Clone, Copy, Debug)]
pub struct OnPrograms {
    /// How many cases there are; of every two, one over each field.
    pub cases: Cases,
    /// What each of the numbers of a case is, by name.
    pub groups: fn() -> Vec<String>,
    /// The equations of the case with these numbers.
    pub claim: &'static dyn AtPoints,
}

/// A claim, recorded.
struct Claim {
    program: Program,
    needed: Vec<bool>,
    equations: Vec<Equation<Recorded>>,
    bound: Bound,
    /// How many numbers make a case.
    count: usize,
}

impl OnPrograms {
    /// Does so many cases, each with randomness of its own. The chance that a false claim passes is that of the draws from one
    /// field alone: it may hold modulo the other prime.
    pub(super) fn run(
        &self,
        first: Key<'_>,
        cases: usize,
        formulas: &Formulas,
    ) -> (Tally, Bound, f64) {
        let claim = self.record(formulas);
        let mut tally = Tally::new(Judgement::Exact);
        for number in 0..cases {
            let key = Key {
                case: number,
                ..first
            };
            let held = match number % 2 {
                0 => claim.try_case::<Fp>(&mut tally, &key),
                _ => claim.try_case::<Fq>(&mut tally, &key),
            };
            if !held {
                break;
            }
        }
        let chance = claim.bound.chance_of_both(cases.div_ceil(2), cases / 2);
        (tally, claim.bound, chance)
    }

    fn record(&self, formulas: &Formulas) -> Claim {
        let groups = (self.groups)();
        let (program, (equations, differences)) = record(groups.len(), |numbers| {
            let equations = self.claim.equations(numbers, formulas);
            let differences = identities(&equations);
            (equations, differences)
        });
        let all: Vec<Recorded> = equations.iter().flat_map(Equation::numbers).collect();
        let bound = Bound::new(&program, &groups, &differences, &all);
        Claim {
            needed: program.needed(all),
            program,
            equations,
            bound,
            count: groups.len(),
        }
    }
}

impl Claim {
    /// The equations at these numbers, unless a root or an inverse is missing.
    fn at<B: Ground>(&self, numbers: &[B]) -> Option<Vec<Equation<B>>> {
        let values = self.program.run(&self.needed, numbers, B::is_poison)?;
        let value = |x: Recorded| values[x.place()];
        Some(self.equations.iter().map(|e| e.map(&value)).collect())
    }

    /// Draws until all roots exist. None if they never do.
    fn draw<B: Drawn>(&self, runner: &mut TestRunner) -> Option<(Vec<Equation<B>>, Vec<B>, usize)> {
        let strategy = proptest::collection::vec(B::number(), self.count);
        for spoilt in 0..=B::REDRAWS {
            let tree = strategy.new_tree(runner);
            let numbers = tree.expect("a list of one length is drawn").current();
            if let Some(equations) = self.at(&numbers) {
                return Some((equations, numbers, spoilt));
            }
        }
        None
    }

    /// Judges one case; false if it does not hold.
    fn try_case<B: Drawn>(&self, tally: &mut Tally, key: &Key<'_>) -> bool {
        let case = Case {
            number: key.case,
            ..Case::default()
        };
        let Some((equations, numbers, spoilt)) = self.draw::<B>(&mut key.runner()) else {
            let what = "no draw had all the roots that the claim takes";
            tally.fail(&case, what.to_owned());
            return false;
        };
        tally.redrawn(spoilt);
        let holds = tally.add(&case, &equations);
        if !holds {
            tally.shrunk(self.shrink(numbers));
        }
        holds
    }

    /// Sets every number to zero that the failure does not need, one after the other.
    fn shrink<B: Drawn>(&self, mut numbers: Vec<B>) -> Vec<String> {
        for k in 0..numbers.len() {
            let kept = std::mem::replace(&mut numbers[k], B::zero());
            let fails = self.at(&numbers).is_some_and(|equations| {
                !Tally::new(Judgement::Exact).add(&Case::default(), &equations)
            });
            if !fails {
                numbers[k] = kept;
            }
        }
        let nonzero = numbers.iter().enumerate().filter(|(_, x)| **x != B::zero());
        nonzero.map(|(k, x)| format!("#{k} = {x:?}")).collect()
    }
}

//! Checks whose cases are lists of random numbers of one length: claims that hold at a point, and exact integrals.

use super::budget::Cases;
use crate::harness::case::Key;
use crate::harness::equation::Equation;
use crate::harness::judgement::Judgement;
use crate::harness::scalar::Drawn;
use crate::harness::tally::{Case, Tally};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use regge_curvature::formulas::Formulas;

/// Equations between things that are made of random numbers.
#[derive(Clone, Copy, Debug)]
pub struct OnNumbers<B> {
    /// How the residuals are judged.
    pub judgement: Judgement,
    /// How many cases there are.
    pub cases: Cases,
    /// How many numbers make a case.
    pub count: usize,
    /// The equations of the case with these numbers, the library computing by these formulas.
    pub equations: fn(&[B], &Formulas) -> Vec<Equation<B>>,
    /// Is a failing case tried again with fewer numbers? Not where each try takes seconds.
    pub shrinks: bool,
}

/// A case whose roots all exist.
struct Usable<B> {
    equations: Vec<Equation<B>>,
    numbers: Vec<B>,
    /// How many draws before it lacked a root.
    spoilt: usize,
}

impl<B: Drawn> OnNumbers<B> {
    /// Does so many cases, each with randomness of its own.
    pub(super) fn run(&self, first: Key<'_>, cases: usize, formulas: &Formulas) -> Tally {
        let mut tally = Tally::new(self.judgement);
        self.add_to(&mut tally, first, cases, formulas);
        tally
    }

    /// Adds so many cases; false if one of them does not hold.
    pub(super) fn add_to(
        &self,
        tally: &mut Tally,
        first: Key<'_>,
        cases: usize,
        formulas: &Formulas,
    ) -> bool {
        for number in first.case..first.case + cases {
            let case = Case {
                number,
                ..Case::default()
            };
            let key = Key {
                case: number,
                ..first
            };
            let Some(drawn) = self.draw(&mut key.runner(), formulas) else {
                let what = "no draw had all the roots that the claim takes";
                tally.fail(&case, what.to_owned());
                return false;
            };
            tally.redrawn(drawn.spoilt);
            if !tally.add(&case, &drawn.equations) {
                if self.shrinks {
                    tally.shrunk(self.shrink(drawn.numbers, formulas));
                }
                return false;
            }
        }
        true
    }

    /// Draws until all roots exist. None if they never do.
    fn draw(&self, runner: &mut TestRunner, formulas: &Formulas) -> Option<Usable<B>> {
        let strategy = proptest::collection::vec(B::number(), self.count);
        for spoilt in 0..=B::REDRAWS {
            let tree = strategy.new_tree(runner);
            let numbers = tree.expect("a list of one length is drawn").current();
            let equations = (self.equations)(&numbers, formulas);
            if B::REDRAWS == 0 || !equations.iter().any(Equation::is_poisoned) {
                return Some(Usable {
                    equations,
                    numbers,
                    spoilt,
                });
            }
        }
        None
    }

    /// Sets every number to zero that the failure does not need, one after the other: a thousand numbers become a
    /// handful, which proptest's own search does not reach in reasonable time.
    fn shrink(&self, mut numbers: Vec<B>, formulas: &Formulas) -> Vec<String> {
        for k in 0..numbers.len() {
            let kept = std::mem::replace(&mut numbers[k], B::zero());
            let equations = (self.equations)(&numbers, formulas);
            let usable = !equations.iter().any(Equation::is_poisoned);
            let holds = || Tally::new(self.judgement).add(&Case::default(), &equations);
            if !usable || holds() {
                numbers[k] = kept;
            }
        }
        let nonzero = numbers.iter().enumerate().filter(|(_, x)| **x != B::zero());
        nonzero.map(|(k, x)| format!("#{k} = {x:?}")).collect()
    }
}

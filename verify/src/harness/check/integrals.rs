//! Checks between exact integrals over two prime fields.

use super::budget::Cases;
use super::numbers::OnNumbers;
use crate::exact::{Fp, Fq};
use crate::harness::bound::Bound;
use crate::harness::case::Key;
use crate::harness::equation::Equation;
use crate::harness::judgement::Judgement;
use crate::harness::tally::Tally;
use regge_curvature::formulas::Formulas;

/// Equations between exact integrals of fields that are made of random numbers. Where the points of the rules lie depends on
/// the numbers, so that there is no one program to be recorded.
#[derive(Clone, Copy, Debug)]
pub struct Integrals {
    /// How many cases there are; of every two, one over each field.
    pub cases: Cases,
    /// How many numbers make a case.
    pub count: usize,
    /// The equations over the first field.
    pub in_p: fn(&[Fp], &Formulas) -> Vec<Equation<Fp>>,
    /// The same over the second.
    pub in_q: fn(&[Fq], &Formulas) -> Vec<Equation<Fq>>,
    /// Their degree.
    pub bound: fn(&Formulas) -> Bound,
}

impl Integrals {
    /// Does so many cases. The chance is that of the draws from one field alone.
    pub(super) fn run(
        &self,
        first: Key<'_>,
        cases: usize,
        formulas: &Formulas,
    ) -> (Tally, Bound, f64) {
        let mut tally = Tally::new(Judgement::Exact);
        let (of_p, of_q) = (cases.div_ceil(2), cases / 2);
        let rest = Key {
            case: first.case + of_p,
            ..first
        };
        if self
            .over(self.in_p)
            .add_to(&mut tally, first, of_p, formulas)
        {
            self.over(self.in_q)
                .add_to(&mut tally, rest, of_q, formulas);
        }
        let bound = (self.bound)(formulas);
        let chance = bound.chance_of_both(of_p, of_q);
        (tally, bound, chance)
    }

    fn over<B>(&self, equations: fn(&[B], &Formulas) -> Vec<Equation<B>>) -> OnNumbers<B> {
        OnNumbers {
            judgement: Judgement::Exact,
            cases: self.cases,
            count: self.count,
            equations,
            shrinks: false,
        }
    }
}

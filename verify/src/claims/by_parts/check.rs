//! From an identity to an entry of the report.

use super::ByParts;
use super::fields::Fields;
use crate::claim::seed::Key;
use crate::claim::{Budget, Case, Check, Equation, Ground, Judgement, Method, Record, Tally};
use crate::exact::Fp;
use crate::report::Entry;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use regge_curvature::formulas::Formulas;
use std::marker::PhantomData;

/// One of them in dimension N by the formulas K.
pub struct ByPartsCheck<C, K, const N: usize>(PhantomData<fn() -> (C, K)>);

impl<C, K, const N: usize> Default for ByPartsCheck<C, K, N> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

impl<C: ByParts, K: Formulas, const N: usize> ByPartsCheck<C, K, N> {
    /// Draws until all roots exist: the equations and how many draws were spoilt.
    fn draw(runner: &mut TestRunner) -> Option<(Vec<Equation<Fp>>, usize)> {
        let numbers = proptest::collection::vec(Fp::number(), Fields::<N>::COUNT);
        for spoilt in 0..Fp::REDRAWS {
            let drawn = numbers.new_tree(runner).ok()?.current();
            let equations = C::equations::<K, N>(drawn);
            if !equations.iter().any(Equation::is_poisoned) {
                return Some((equations, spoilt));
            }
        }
        None
    }
}

impl<C: ByParts, K: Formulas, const N: usize> Check for ByPartsCheck<C, K, N> {
    fn record(&self) -> &'static Record {
        &C::RECORD
    }

    fn dimension(&self) -> usize {
        N
    }

    fn method(&self) -> Method {
        Method::Exact
    }

    /// 2⁻⁵⁴ a draw: two are enough; on the tetrahedron each takes seconds.
    fn cases(&self, budget: &Budget) -> usize {
        match (budget.quick, N) {
            (true, 3..) => 1,
            (true, _) | (_, 3..) => 2,
            _ => 4,
        }
    }

    fn run(&self, budget: &Budget) -> Entry {
        // One identity of integrals in the coefficients of the fields: degree ≤ 2 · 40 in L's, 1 in σ's and w's.
        let mut tally = Tally::new(Judgement::Exact { degree: 100.0 });
        for number in 0..self.cases(budget) {
            let case = Case {
                number,
                ..Case::default()
            };
            let key = Key {
                seed: budget.seed,
                label: C::RECORD.label,
                dimension: N,
                method: Method::Exact.name(),
                case: number,
            };
            let Some((equations, spoilt)) = Self::draw(&mut key.runner()) else {
                let what = "no draw had all the roots that the claim takes";
                tally.fail(&case, what.to_owned());
                break;
            };
            tally.redrawn(spoilt);
            if !tally.add(&case, &equations) {
                break;
            }
        }
        tally.finish(&C::RECORD, N, Fp::NAME, Method::Exact)
    }
}

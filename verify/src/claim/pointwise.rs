//! Claims that hold at a point: one body for floating point numbers and for the prime field.

use super::check::{Budget, Check, Excuses};
use super::seed::Key;
use super::{Case, Equation, Ground, Judgement, Method, Record, Tally, Timed};
use crate::instance::{self, Instance};
use crate::report::Entry;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use regge_curvature::formulas::Formulas;
use regge_curvature::scalar::Field;
use std::marker::PhantomData;

/// The scalars that a pointwise claim runs over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// Floating point numbers with derivatives, and the prime field.
    Both,
    /// The same; in floating point numbers it is an oracle, a formula with a source outside this project.
    Oracle,
    /// Integers only: over the prime field.
    Integers,
    /// Inequalities (see [`Equation::at_most`]): not over a field without order.
    Ordered,
}

/// One statement that holds at every point, for any jets of the metric.
///
/// The body is written once. Over `Dual64` it differentiates in time through the library's own code; over
/// `Jet1<Fp, 1>` the same code is exact. Formulas that the paper states go through `K`.
pub trait Pointwise: Send + Sync + 'static {
    /// What the page says.
    const RECORD: Record;
    /// Where it is meaningful.
    const DIMENSIONS: &'static [usize] = &[2, 3, 4, 5];
    /// |left − right| over the sum of the terms' magnitudes. Terms are sums of up to N⁴ products through g⁻¹ and
    /// ∂g⁻¹; the instances' condition numbers are below 10², so that rounding is amplified by less than 10⁴.
    const TOLERANCE: f64 = 1e-11;
    /// How many roots the body takes, of volumes, normals and frames.
    const ROOTS: u32 = 3;
    /// By which scalars.
    const OVER: Over = Over::Both;
    /// Why there is one method only.
    const EXCUSES: Excuses = Excuses::NONE;

    /// The equations at one instance.
    fn equations<K: Formulas, S: Timed, const N: usize>(
        i: &Instance<S, N>,
    ) -> Vec<Equation<S::Base>>;

    /// How the residual is judged over a ground scalar.
    fn judgement<B: Ground>(dimension: usize) -> Judgement {
        if B::METHOD == Method::Exact {
            return Judgement::Exact {
                degree: degree_bound(dimension, Self::ROOTS),
            };
        }
        match Self::OVER {
            Over::Ordered => Judgement::Bound,
            _ => Judgement::Rounding {
                tolerance: Self::TOLERANCE,
            },
        }
    }
}

/// A bound of the degree of a claim in the instance's numbers, cleared of denominators and roots.
///
/// g has degree 2 in the numbers drawn, so that det g and the numerators of g⁻¹ have degree ≤ 2N. A term of a
/// claim contains g⁻¹ at most ten times and twenty other factors of degree ≤ 2, its rate of change no more than
/// twice as much: the degree is ≤ 2 · (10 · 2N + 20 · 2) · 4 when both sides are brought to one denominator. Each
/// square root doubles the degree (the product over its two signs), and the draws that have the root are half of
/// all draws, which doubles the chance once more.
fn degree_bound(dimension: usize, roots: u32) -> f64 {
    f64::from(8 * (20 * dimension as u32 + 40)) * 4f64.powi(roots as i32)
}

/// A pointwise claim in dimension N over the scalar S, by the formulas K.
pub struct PointwiseCheck<C, K, S, const N: usize>(PhantomData<fn() -> (C, K, S)>);

impl<C, K, S, const N: usize> Default for PointwiseCheck<C, K, S, N> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

impl<C: Pointwise, K: Formulas, S: Timed, const N: usize> PointwiseCheck<C, K, S, N> {
    fn instance(numbers: &[S::Base]) -> Instance<S, N> {
        Instance::from_numbers(numbers)
    }

    /// Draws until all roots exist. The equations, the numbers drawn, and how many draws were spoilt.
    fn draw(runner: &mut TestRunner) -> Option<(Vec<Equation<S::Base>>, Vec<S::Base>, usize)> {
        let strategy = instance::numbers::<S, N>();
        for spoilt in 0..=S::Base::REDRAWS {
            let numbers = strategy.new_tree(runner).ok()?.current();
            let equations = C::equations::<K, S, N>(&Self::instance(&numbers));
            let usable = S::Base::REDRAWS == 0 || !equations.iter().any(Equation::is_poisoned);
            if usable {
                return Some((equations, numbers, spoilt));
            }
        }
        None
    }

    /// Sets every number to zero that the failure does not need, one after the other: a thousand numbers become a
    /// handful, which proptest's own search does not reach in reasonable time.
    fn shrink(mut numbers: Vec<S::Base>) -> Vec<String> {
        for k in 0..numbers.len() {
            let kept = std::mem::replace(&mut numbers[k], S::Base::zero());
            let equations = C::equations::<K, S, N>(&Self::instance(&numbers));
            let usable = !equations.iter().any(Equation::is_poisoned);
            let holds = || Tally::new(C::judgement::<S::Base>(N)).add(&Case::default(), &equations);
            if !usable || holds() {
                numbers[k] = kept;
            }
        }
        let nonzero = numbers
            .iter()
            .enumerate()
            .filter(|(_, x)| **x != S::Base::zero());
        nonzero.map(|(k, x)| format!("#{k} = {x:?}")).collect()
    }
}

impl<C: Pointwise, K: Formulas, S: Timed, const N: usize> Check for PointwiseCheck<C, K, S, N> {
    fn record(&self) -> &'static Record {
        &C::RECORD
    }

    fn dimension(&self) -> usize {
        N
    }

    fn method(&self) -> Method {
        match (S::Base::METHOD, C::OVER) {
            (Method::Ad, Over::Oracle) => Method::Oracle,
            (method, _) => method,
        }
    }

    fn cases(&self, budget: &Budget) -> usize {
        let cases = if S::Base::METHOD == Method::Exact {
            budget.exact_cases
        } else {
            budget.cases
        };
        // A claim in one or two dimensions has as many instances as one in four.
        cases * (4 / C::DIMENSIONS.len().min(4))
    }

    fn excuses(&self) -> Excuses {
        C::EXCUSES
    }

    fn run(&self, budget: &Budget) -> Entry {
        let mut tally = Tally::new(C::judgement::<S::Base>(N));
        for number in 0..self.cases(budget) {
            let case = Case {
                number,
                ..Case::default()
            };
            let (label, method) = (C::RECORD.label, self.method().name());
            let key = Key {
                seed: budget.seed,
                label,
                dimension: N,
                method,
                case: number,
            };
            let Some((equations, numbers, spoilt)) = Self::draw(&mut key.runner()) else {
                tally.fail(
                    &case,
                    "no draw had all the roots that the claim takes".to_owned(),
                );
                break;
            };
            tally.redrawn(spoilt);
            if !tally.add(&case, &equations) {
                tally.shrunk(Self::shrink(numbers));
                break;
            }
        }
        tally.finish(&C::RECORD, N, S::Base::NAME, self.method())
    }
}

//! Which roots of a program are in its results. √a √b is none where ab is a square, though either root is.

use crate::exact::{Fp, Program, Recorded, Step};
use crate::harness::{Drawn, Key};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use regge_curvature::scalar::{Algebraic, Field};

/// At so many draws a product must be a square in order to be one everywhere. Of other products half of the values are.
const DRAWS: usize = 40;
/// Of more roots than this the signs are not tried.
const MOST: usize = 8;

/// The places of the roots that these results are computed from.
pub(super) fn roots(program: &Program, results: &[Recorded]) -> Vec<usize> {
    let needed = program.needed(results.iter().copied());
    let is_root = |k: &usize| needed[*k] && matches!(program.steps()[*k], Step::Root(_));
    (0..needed.len()).filter(is_root).collect()
}

/// A result, and the roots that it may contain.
pub(super) struct Suspect<'p> {
    pub program: &'p Program,
    pub result: Recorded,
    /// The places of the roots.
    pub roots: Vec<usize>,
    /// How many numbers the program is given.
    pub inputs: usize,
}

/// Signs of roots, or a product of roots: one bit for each.
type Bits = usize;

impl Suspect<'_> {
    /// How many independent roots the result contains. Signs may be changed together if that keeps the products of roots that
    /// are no roots; among so many choices, 2^roots, the result has different values, at a draw. All, if there is none that has
    /// the roots.
    pub fn contained(&self, key: Key<'_>) -> u32 {
        let count = self.roots.len();
        let mut runner = key.runner();
        if count == 0 || count > MOST {
            return count as u32;
        }
        let squares = self.squares(&mut runner);
        let keeps = |signs: &Bits| {
            squares
                .iter()
                .all(|s| (s & signs).count_ones().is_multiple_of(2))
        };
        let admitted: Vec<Bits> = (0..1 << count).filter(keeps).collect();
        for _ in 0..=Fp::REDRAWS {
            let numbers = self.draw(&mut runner);
            if let Some(value) = self.with_signs(&numbers, 0) {
                let same = |signs: &&Bits| self.with_signs(&numbers, **signs) == Some(value);
                let unchanged = admitted.iter().filter(same).count();
                return (admitted.len() / unchanged).ilog2();
            }
        }
        count as u32
    }

    fn draw(&self, runner: &mut TestRunner) -> Vec<Fp> {
        let strategy = proptest::collection::vec(Fp::number(), self.inputs);
        let tree = strategy.new_tree(runner);
        tree.expect("a list of one length is drawn").current()
    }

    /// The result where the roots have these signs.
    fn with_signs(&self, numbers: &[Fp], signs: Bits) -> Option<Fp> {
        let needed = self.program.needed([self.result]);
        let other = |k| {
            let place = self.roots.iter().position(|root| *root == k);
            place.is_some_and(|place| signs >> place & 1 == 1)
        };
        let sign = |k, x: Fp| if other(k) { -x } else { x };
        let values = self
            .program
            .run_with(&needed, numbers, Fp::is_poison, sign)?;
        Some(values[self.result.place()])
    }

    /// The products of numbers under roots that are squares.
    fn squares(&self, runner: &mut TestRunner) -> Vec<Bits> {
        let needed = self.program.needed([self.result]);
        let mut found: Vec<Bits> = (1..1 << self.roots.len()).collect();
        for _ in 0..DRAWS {
            let numbers = self.draw(runner);
            // A root that a draw has not is of no interest here.
            let any = |k, x: Fp| match self.program.steps()[k] {
                Step::Root(_) if x.is_poison() => Fp::one(),
                _ => x,
            };
            let values = self.program.run_with(&needed, &numbers, |_| false, any);
            let values = values.expect("nothing is refused");
            let under = |place: usize| match self.program.steps()[self.roots[place]] {
                Step::Root(a) => values[a as usize],
                _ => Fp::one(),
            };
            let product = |bits: Bits| {
                let places = (0..self.roots.len()).filter(|p| bits >> p & 1 == 1);
                places.fold(Fp::one(), |product, p| product * under(p))
            };
            found.retain(|bits| !product(*bits).sqrt().is_poison());
        }
        found
    }
}

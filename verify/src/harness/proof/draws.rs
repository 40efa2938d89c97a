//! Programs at random elements of a prime field.

use crate::exact::{Program, Recorded};
use crate::harness::case::Key;
use crate::harness::scalar::Drawn;
use proptest::strategy::{Strategy, ValueTree};

/// Values of the needed steps at the first draw from a number on that has all roots.
pub(super) fn draw<B: Drawn>(
    program: &Program,
    inputs: usize,
    results: &[Recorded],
    key: Key<'_>,
) -> Option<Vec<B>> {
    let needed = program.needed(results.iter().copied());
    let strategy = proptest::collection::vec(B::number(), inputs);
    let mut runner = key.runner();
    for _ in 0..=B::REDRAWS {
        let tree = strategy.new_tree(&mut runner);
        let numbers = tree.expect("a list of one length is drawn").current();
        let values = program.run(&needed, &numbers, B::is_poison);
        if values.is_some() {
            return values;
        }
    }
    None
}

//! The random numbers of one case on a mesh, which are drawn while its fields are made.

use super::seed::Key;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;

/// Random numbers of one case.
pub struct Draw {
    runner: TestRunner,
    /// What was drawn.
    pub(in crate::harness) drawn: Vec<f64>,
    /// What is to be drawn instead, when a case is replayed.
    given: Option<Vec<f64>>,
}

impl Draw {
    /// The numbers of a case.
    pub fn new(key: &Key<'_>) -> Self {
        Self {
            runner: key.runner(),
            drawn: Vec::new(),
            given: None,
        }
    }

    /// These numbers; further ones as the case has them.
    pub(in crate::harness) fn replay(key: &Key<'_>, given: &[f64]) -> Self {
        Self {
            given: Some(given.to_vec()),
            ..Self::new(key)
        }
    }

    /// So many numbers from −1…1.
    pub fn numbers(&mut self, len: usize) -> Vec<f64> {
        let strategy = proptest::collection::vec(-1.0..1.0, len);
        let mut numbers: Vec<f64> = strategy
            .new_tree(&mut self.runner)
            .expect("a range of numbers can be drawn from")
            .current();
        if let Some(given) = &self.given {
            for (x, y) in numbers.iter_mut().zip(given.iter().skip(self.drawn.len())) {
                *x = *y;
            }
        }
        self.drawn.extend(&numbers);
        numbers
    }
}

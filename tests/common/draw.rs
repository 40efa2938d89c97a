//! Random tensors at a point, by proptest: what fails shrinks towards g = δ and other tensors that vanish.

use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestError, TestRng, TestRunner};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, Vector, symmetric};
use std::cell::Cell;

/// Some hundred roundings of numbers of size 10: eigenvalues of g lie between 0.2 and 1.8.
const ROUNDING: f64 = 1e-12;

/// Hands out random numbers in [−1, 1) as tensors.
pub struct Source<'a>(std::slice::Iter<'a, f64>);

impl Source<'_> {
    fn number(&mut self) -> f64 {
        *self.0.next().expect("NUMBERS is enough")
    }

    pub fn jet<const N: usize>(&mut self) -> Jet2<f64, N> {
        Jet2::from_numbers(|| self.number())
    }

    pub fn vector<const N: usize>(&mut self) -> Vector<Jet2<f64, N>, N> {
        Vector::from_fn(|_, _| self.jet())
    }

    pub fn tensor<const N: usize>(&mut self) -> Mat<Jet2<f64, N>, N> {
        symmetric(|_, _| self.jet())
    }

    /// δ + s/5: the row sums of |s|/5 are below 4/5.
    pub fn metric<const N: usize>(&mut self) -> Mat<Jet2<f64, N>, N> {
        let fifth = Jet2::constant(0.2);
        let delta = |i, j| Jet2::constant(f64::from(u8::from(i == j)));
        symmetric(|i, j| delta(i, j) + fifth * self.jet())
    }
}

/// More than a metric, two tensors and three vectors take when N = 4.
const NUMBERS: usize = 800;

/// Of a property: the first comparison that fails.
pub type Outcome = Result<(), TestCaseError>;

/// The property for 32 draws, the same ones in each run.
pub fn check(property: impl Fn(&mut Source<'_>) -> Outcome) {
    let config = Config {
        cases: 32,
        failure_persistence: None,
        ..Config::default()
    };
    let rng = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let numbers = proptest::collection::vec(-1.0..1.0, NUMBERS);
    let taken = Cell::new(0);
    // proptest is compiled anew for each type of what it runs.
    let draw: &dyn Fn(Vec<f64>) -> Outcome = &|numbers| {
        let mut source = Source(numbers.iter());
        let outcome = property(&mut source);
        taken.set(taken.get().max(NUMBERS - source.0.len()));
        outcome
    };
    TestRunner::new_with_rng(config, rng)
        .run(&numbers, draw)
        .unwrap_or_else(|failure| panic!("{}", shortened(failure, taken.get())));
}

/// What failed, and the numbers that it takes: of those that were taken, all others have shrunk to 0.
fn shortened(failure: TestError<Vec<f64>>, taken: usize) -> String {
    match failure {
        TestError::Abort(reason) => reason.to_string(),
        TestError::Fail(reason, numbers) => {
            let all = numbers.into_iter().take(taken).enumerate();
            let needed: Vec<(usize, f64)> = all.filter(|(_, x)| *x != 0.0).collect();
            format!("{reason}, with the numbers {needed:?}")
        }
    }
}

/// a = b up to rounding.
pub fn close(name: &str, a: f64, b: f64) -> Outcome {
    if (a - b).abs() < ROUNDING {
        return Ok(());
    }
    Err(TestCaseError::fail(format!("{name}: {a} is not {b}")))
}

/// All entries are 0 up to rounding; nalgebra's `amax` would overlook one that is NaN.
pub fn vanishes<'a>(name: &str, mut entries: impl Iterator<Item = &'a f64>) -> Outcome {
    entries.try_for_each(|entry| close(name, *entry, 0.0))
}

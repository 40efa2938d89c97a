//! Floor 2. What a claim is, and how much is to be computed for it.

use crate::finding::Finding;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::formulas::{Formulas, PAPER};
use regge_curvature::functional::Rules;

/// How much is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Where all randomness comes from.
    pub seed: u64,
    /// Fewer levels, one run.
    pub quick: bool,
    /// The formulas that the library computes by: the paper's, but where somebody wants to see which verdicts turn.
    pub formulas: Formulas,
}

impl Effort {
    /// By the paper's formulas.
    pub const fn new(seed: u64, quick: bool) -> Self {
        Self {
            seed,
            quick,
            formulas: PAPER,
        }
    }

    /// The same by other formulas.
    pub const fn with_formulas(self, formulas: Formulas) -> Self {
        Self { formulas, ..self }
    }

    /// Rules of this order, with the formulas.
    pub fn rules(&self, dimension: usize, order: usize) -> Rules {
        Rules::new(dimension, order).with_formulas(self.formulas)
    }

    /// The seeds of the runs.
    pub fn seeds(&self) -> Vec<u64> {
        let runs = if self.quick { 1 } else { 3 };
        // Runs of neighbouring seeds have nothing in common.
        (0..runs)
            .map(|run| self.seed.wrapping_mul(1000) + run)
            .collect()
    }

    /// All levels, or the first so many.
    pub fn levels<'a, T>(&self, all: &'a [T], few: usize) -> &'a [T] {
        if self.quick { &all[..few] } else { all }
    }

    /// Several numbers on meshes of so many cubes a side, run by run, as one series each. `of` has h and the numbers.
    ///
    /// # Errors
    /// Those of `of`.
    pub fn sweep<const M: usize>(
        &self,
        sides: &[usize],
        of: &dyn Fn(usize, u64) -> Result<(f64, [f64; M]), Error>,
    ) -> Result<[Series; M], Error> {
        let mut runs: [Vec<Vec<(f64, f64)>>; M] = std::array::from_fn(|_| Vec::new());
        for seed in self.seeds() {
            runs.iter_mut().for_each(|run| run.push(Vec::new()));
            for &side in sides {
                let (h, values) = of(side, seed)?;
                for (run, value) in runs.iter_mut().zip(values) {
                    run.last_mut().expect("it was begun").push((h, value));
                }
            }
        }
        Ok(runs.map(|runs| Series::over_h(&runs)))
    }
}

/// A statement of the paper's analysis, and how it is measured.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// The row of the catalogue: `A01`.
    pub label: &'static str,
    /// The labels of the paper's LaTeX source; none for what has none.
    pub paper: &'static [&'static str],
    /// A name for it.
    pub title: &'static str,
    /// The statement, in LaTeX (math mode).
    pub statement: &'static str,
    /// What is measured, and how.
    pub how: &'static str,
    /// Measures it.
    pub measure: fn(&Effort) -> Result<Vec<Finding>, Error>,
}

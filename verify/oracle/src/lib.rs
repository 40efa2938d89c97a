//! Reference values that nobody here computed: the cases of `cases/`, made with NGSolve (see the README).

mod read;

pub use read::{Curvature, HMinus2, Oracle, Sample};

use regge_curvature::metrics::Metric;

/// One case's text.
macro_rules! case {
    ($name:literal) => {
        include_str!(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/cases/",
            $name,
            ".json"
        ))
    };
}

/// All cases, smallest first: dimension and text.
const CASES: [(usize, &str); 10] = [
    (2, case!("n2-structured-k2-r0")),
    (2, case!("n2-structured-k2-r1")),
    (2, case!("n2-unstructured-r1")),
    (2, case!("n2-structured-k2-r2")),
    (2, case!("n2-unstructured-canonical-r2")),
    (3, case!("n3-structured-k1-r0")),
    (3, case!("n3-structured-k1-r1")),
    (3, case!("n3-structured-k1-r2")),
    (3, case!("n3-structured-k2-canonical-r0")),
    (3, case!("n3-structured-k2-canonical-r1")),
];

/// The numbers of the cases of a dimension.
pub fn numbers(dimension: usize) -> Vec<usize> {
    (0..CASES.len())
        .filter(|&i| CASES[i].0 == dimension)
        .collect()
}

/// All cases.
pub fn all() -> Vec<Oracle> {
    (0..CASES.len()).map(case).collect()
}

/// A case by its number.
///
/// # Panics
/// If its file is damaged, which is known at compile time of the tests.
pub fn case(number: usize) -> Oracle {
    serde_json::from_str(CASES[number].1).unwrap_or_else(|e| panic!("oracle {number}: {e}"))
}

impl Oracle {
    /// The smooth metric.
    ///
    /// # Panics
    /// If nobody knows it.
    pub fn formula(&self) -> Metric {
        let named = Metric::ALL.iter().find(|m| m.0 == self.metric);
        named
            .unwrap_or_else(|| panic!("no metric {}", self.metric))
            .1
    }
}

//! Floor 5 of the verification. Runs the catalogue, or a part of it.

use crate::claims::{Catalogue, catalogue};
use crate::harness::{Budget, Check, Entry, Method};
use crate::report::Report;
use rayon::prelude::*;
use regge_curvature::formulas::{Formulas, PAPER};
use std::fmt;

/// What to run.
#[derive(Clone, Debug)]
pub struct Options {
    /// Only these claims: rows of the catalogue or labels of the paper. All, if empty.
    pub only: Vec<String>,
    /// Only this dimension.
    pub dimension: Option<usize>,
    /// Where all randomness comes from.
    pub seed: u64,
    /// Fewer instances.
    pub quick: bool,
    /// By which formulas the library computes: the paper's, unless a sceptic breaks one.
    pub formulas: Formulas,
}

impl Default for Options {
    fn default() -> Self {
        // The day on which the catalogue was begun.
        Self {
            only: Vec::new(),
            dimension: None,
            seed: 20_261_122,
            quick: false,
            formulas: PAPER,
        }
    }
}

/// A quick run proves what it can in dimensions up to this.
const QUICK_PROOFS: usize = 3;

/// One entry is done.
#[derive(Clone, Copy, Debug)]
pub struct Progress<'a> {
    /// How many entries there are.
    pub total: usize,
    /// This one.
    pub entry: &'a Entry,
}

/// A label that no claim has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownLabel {
    /// As it was given.
    pub label: String,
    /// The most similar ones.
    pub nearest: Vec<String>,
}

impl fmt::Display for UnknownLabel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "no claim is called {:?}; the nearest: {}",
            self.label,
            self.nearest.join(", ")
        )
    }
}

impl std::error::Error for UnknownLabel {}

/// Runs the catalogue.
///
/// # Errors
/// If a label is unknown.
pub fn run(
    options: &Options,
    progress: &(dyn Fn(Progress<'_>) + Sync),
) -> Result<Report, UnknownLabel> {
    run_catalogue(catalogue(), options, progress)
}

/// Runs these claims. The report does not depend on the number of threads.
///
/// # Errors
/// If a label is unknown.
pub fn run_catalogue(
    catalogue: Catalogue,
    options: &Options,
    progress: &(dyn Fn(Progress<'_>) + Sync),
) -> Result<Report, UnknownLabel> {
    for label in &options.only {
        if !catalogue.iter().any(|c| is_called(c, label)) {
            return Err(unknown(&catalogue, label));
        }
    }
    let wanted = |c: &Check| {
        let named = options.only.is_empty() || options.only.iter().any(|l| is_called(c, l));
        // In higher dimensions a proof takes half a minute.
        let quick = c.method != Method::Proof || c.dimension <= QUICK_PROOFS;
        let wanted = quick || !options.quick;
        named && wanted && options.dimension.is_none_or(|n| n == c.dimension)
    };
    let checks: Catalogue = catalogue.into_iter().filter(wanted).collect();
    let budget = Budget {
        seed: options.seed,
        quick: options.quick,
        formulas: options.formulas,
    };
    let total = checks.len();
    let run_one = |check: &Check| {
        let entry = check.run(&budget);
        progress(Progress {
            total,
            entry: &entry,
        });
        entry
    };
    Ok(Report {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        revision: "unknown".to_owned(),
        seed: options.seed,
        claims: checks.par_iter().map(run_one).collect(),
    })
}

fn is_called(check: &Check, label: &str) -> bool {
    let record = check.record;
    record.label.eq_ignore_ascii_case(label) || record.paper.contains(&label)
}

/// The three labels that differ least from the one given.
fn unknown(catalogue: &Catalogue, label: &str) -> UnknownLabel {
    let records = catalogue.iter().map(|c| c.record);
    let mut labels: Vec<&str> = records
        .flat_map(|r| r.paper.iter().copied().chain([r.label]))
        .collect();
    labels.sort_unstable();
    labels.dedup();
    labels.sort_by_key(|l| strsim::damerau_levenshtein(&l.to_lowercase(), &label.to_lowercase()));
    let nearest = labels.into_iter().take(3).map(str::to_owned).collect();
    UnknownLabel {
        label: label.to_owned(),
        nearest,
    }
}

//! The report of the analysis as data: by claim, and by label of the paper.

use regge_analysis::report::{OfLabel, Report, of_label};
use regge_verify::paper::{self, Label};
use serde::Serialize;
use std::collections::BTreeMap;

/// The version of the form: a field more does not change it, a field less or another meaning does.
const FORMAT: u32 = 1;

/// What `--analysis --json` writes.
#[derive(Serialize)]
pub struct Document<'a> {
    format: u32,
    #[serde(flatten)]
    report: &'a Report,
    labels: BTreeMap<String, Entry<'a>>,
}

/// A label of the paper.
#[derive(Serialize)]
struct Entry<'a> {
    /// claim, definition, bound, rate, remark, figure, table or section.
    of: String,
    /// The rows of both catalogues that verify it.
    home: Vec<String>,
    /// Why there is none.
    reason: Option<String>,
    /// What this run measured of it.
    #[serde(flatten)]
    measured: Option<OfLabel<'a>>,
}

impl<'a> Document<'a> {
    /// A report with every label of the paper.
    pub fn new(report: &'a Report) -> Self {
        let entry = |(name, label): (String, Label)| {
            let measured = of_label(report, &name);
            let entry = Entry {
                of: label.kind,
                home: label.home,
                reason: label.reason,
                measured,
            };
            (name, entry)
        };
        Self {
            format: FORMAT,
            report,
            labels: paper::labels().into_iter().map(entry).collect(),
        }
    }
}

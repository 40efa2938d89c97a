//! The report by the labels of the paper: what was seen of each, and what decides it.

use super::{Measured, Report};
use crate::finding::Entry;
use serde::Serialize;

/// A finding about a label, in short.
#[derive(Clone, Debug, Serialize)]
pub struct Row<'a> {
    /// The row of the catalogue whose page has the numbers.
    pub claim: &'a str,
    /// `N = 3, r = 1`.
    pub case: &'a str,
    /// bound, sharp, rate or observation.
    pub kind: &'a str,
    /// The claimed constant or order; null if nothing is claimed.
    pub claimed: Option<f64>,
    /// What was seen of it.
    pub seen: f64,
    /// The greatest less the least of the runs' orders.
    pub spread: f64,
    /// What the levels are.
    pub axis: &'a str,
    /// The levels.
    pub levels: &'a [f64],
    /// holds, fails or observed; or that a forgery was not caught.
    pub verdict: &'a str,
}

/// What was measured of a label of the paper.
#[derive(Clone, Debug, Serialize)]
pub struct OfLabel<'a> {
    /// The finding that decides: one that fails, or else the claimed one with the least room before it would. With the verdict on
    /// all of them.
    #[serde(flatten)]
    pub decisive: Row<'a>,
    /// All that was found.
    pub findings: Vec<Row<'a>>,
}

fn row<'a>(claim: &'a Measured, entry: &'a Entry) -> Row<'a> {
    let caught = entry.forgeries.iter().all(|f| f.caught);
    Row {
        claim: claim.label,
        case: &entry.case,
        kind: entry.kind,
        claimed: entry.claimed,
        seen: entry.seen,
        spread: entry.spread,
        axis: entry.axis,
        levels: &entry.levels,
        verdict: match entry.verdict {
            "fails" => "fails",
            _ if !caught => "a forgery was not caught",
            other => other,
        },
    }
}

/// By how much a finding is decisive: less is more. What fails, or is no number, comes first, and what claims nothing last.
fn rank(entry: &Entry) -> f64 {
    match entry.room {
        _ if !entry.is_good() => f64::NEG_INFINITY,
        Some(room) => room,
        None => f64::INFINITY,
    }
}

/// What was measured of a label; none if no claim of the report is about it.
pub fn of_label<'a>(report: &'a Report, label: &str) -> Option<OfLabel<'a>> {
    let all = report.claims.iter();
    let about: Vec<(&Measured, &Entry)> = all
        .flat_map(|claim| claim.findings.iter().map(move |entry| (claim, entry)))
        .filter(|(_, entry)| entry.about.contains(&label))
        .collect();
    let first = about
        .iter()
        .min_by(|a, b| rank(a.1).total_cmp(&rank(b.1)))?;
    Some(OfLabel {
        decisive: row(first.0, first.1),
        findings: about
            .iter()
            .map(|(claim, entry)| row(claim, entry))
            .collect(),
    })
}

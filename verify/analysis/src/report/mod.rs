//! Floor 5. What was measured: data, a table, pages.

mod chart;
mod label;
mod page;

pub use label::{OfLabel, Row, of_label};
pub use page::{Page, pages};

use crate::claim::Claim;
use crate::finding::{Entry, Finding};
use serde::Serialize;
use std::fmt::Write;

/// What was found.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Of the package.
    pub version: String,
    /// Where all randomness came from.
    pub seed: u64,
    /// Fewer levels, one run?
    pub quick: bool,
    /// The claims.
    pub claims: Vec<Measured>,
}

/// A claim with what was found of it.
#[derive(Clone, Debug, Serialize)]
pub struct Measured {
    /// The row of the catalogue.
    pub label: &'static str,
    /// The labels of the paper's source.
    pub paper: &'static [&'static str],
    /// A name for it.
    pub title: &'static str,
    /// In LaTeX.
    #[serde(skip)]
    pub statement: String,
    /// What is measured, and how.
    #[serde(skip)]
    pub how: &'static str,
    /// Case by case.
    pub findings: Vec<Entry>,
}

impl Measured {
    /// A claim with its findings.
    pub fn new(claim: &Claim, findings: &[Finding]) -> Self {
        let entry = |finding: &Finding| {
            let entry = finding.entry();
            // What names no label is about all of the claim's.
            let about = match entry.about {
                [] => claim.paper,
                some => some,
            };
            Entry { about, ..entry }
        };
        Self {
            label: claim.label,
            paper: claim.paper,
            title: claim.title,
            statement: one_line(claim.statement),
            how: claim.how,
            findings: findings.iter().map(entry).collect(),
        }
    }

    /// holds, observed, or what is wrong.
    pub fn verdict(&self) -> &'static str {
        let all = &self.findings;
        if all.is_empty() || all.iter().any(|f| f.verdict == "fails") {
            return "fails";
        }
        if !all.iter().all(Entry::is_good) {
            return "a forgery was not caught";
        }
        let claimed = all.iter().any(|f| f.verdict == "holds");
        if claimed { "holds" } else { "observed" }
    }

    /// Does it hold, with every forgery caught?
    pub fn is_good(&self) -> bool {
        matches!(self.verdict(), "holds" | "observed")
    }

    /// A label of the claim that no finding is about.
    pub fn silent_on(&self) -> Option<&'static str> {
        let about = |label: &&&'static str| self.findings.iter().any(|f| f.about.contains(label));
        self.paper.iter().find(|label| !about(label)).copied()
    }

    fn forgeries(&self) -> usize {
        self.findings.iter().map(|f| f.forgeries.len()).sum()
    }
}

/// A statement without the line breaks of the source.
pub fn one_line(statement: &str) -> String {
    statement.split_whitespace().collect::<Vec<_>>().join(" ")
}

impl Report {
    /// The claims that fail, or whose forgeries were not caught.
    pub fn failures(&self) -> Vec<&Measured> {
        self.claims
            .iter()
            .filter(|claim| !claim.is_good())
            .collect()
    }

    /// How many of what.
    pub fn conclusion(&self) -> String {
        let findings: usize = self.claims.iter().map(|c| c.findings.len()).sum();
        let forgeries: usize = self.claims.iter().map(Measured::forgeries).sum();
        let all = self.claims.iter().flat_map(|c| &c.findings);
        let missed = all.flat_map(|f| &f.forgeries).filter(|f| !f.caught).count();
        format!(
            "{} claims in {findings} cases, {forgeries} forgeries; {} claims fail, {missed} forgeries not caught; seed {}",
            self.claims.len(),
            self.claims
                .iter()
                .filter(|c| c.verdict() == "fails")
                .count(),
            self.seed
        )
    }

    /// For a terminal.
    pub fn table(&self) -> String {
        let mut text = String::new();
        for claim in &self.claims {
            let _ = writeln!(text, "{} {}: {}", claim.label, claim.title, claim.verdict());
            for finding in &claim.findings {
                let _ = writeln!(text, "    {:<44} {}", finding.case, sentence(finding));
            }
        }
        text + &self.conclusion() + "\n"
    }
}

/// What was seen of a case, in a line.
fn sentence(entry: &Entry) -> String {
    let forgeries: Vec<String> = entry
        .forgeries
        .iter()
        .map(|f| {
            let caught = if f.caught { "caught" } else { "NOT CAUGHT" };
            format!("{}: {:.3} {caught}", f.name, f.seen)
        })
        .collect();
    let wrong = if forgeries.is_empty() {
        String::new()
    } else {
        format!(" [{}]", forgeries.join("; "))
    };
    format!(
        "{}; seen {:.4} ± {:.3}, {}{wrong}",
        entry.claim, entry.seen, entry.spread, entry.verdict
    )
}

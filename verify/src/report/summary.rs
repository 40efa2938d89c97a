//! The report by claims, as a table in plain text and as lines for a terminal.

use super::data::Report;
use crate::harness::{Entry, Forgery, Verdict};
use std::collections::BTreeMap;
use std::fmt::Write;

/// All entries of one claim.
#[derive(Clone, Debug)]
pub struct Row<'a> {
    /// The claim.
    pub label: &'a str,
    /// One for each dimension and method.
    pub entries: Vec<&'a Entry>,
}

impl<'a> Row<'a> {
    /// N, ascending.
    pub fn dimensions(&self) -> Vec<usize> {
        let mut all: Vec<usize> = self.entries.iter().map(|e| e.dimension).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// The same as text.
    pub fn dimensions_listed(&self) -> String {
        let all: Vec<String> = self.dimensions().iter().map(usize::to_string).collect();
        all.join(", ")
    }

    /// The weakest margin of the forgery with this name.
    pub fn weakest_of(&self, name: &str) -> Option<f64> {
        let forgeries = self.entries.iter().flat_map(|e| &e.forgeries);
        let margins = forgeries
            .filter(|f| f.name == name)
            .filter_map(|f| f.margin);
        margins.reduce(f64::min)
    }

    /// AD, exact, …, each once.
    pub fn methods(&self) -> Vec<&'a str> {
        let mut all: Vec<&str> = self.entries.iter().map(|e| e.method.as_str()).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Is there a dimension with two entries by one method?
    pub fn has_stretched(&self) -> bool {
        let keys: Vec<_> = (self.entries.iter())
            .map(|e| (e.dimension, &e.method))
            .collect();
        keys.iter()
            .enumerate()
            .any(|(k, key)| keys[..k].contains(key))
    }

    /// How many random instances, over all entries; the points of a proof are none.
    pub fn cases(&self) -> usize {
        let drawn = self.entries.iter().filter(|e| e.proof.is_none());
        drawn.map(|e| e.cases).sum()
    }

    /// The greatest, and what is allowed there; of the entries that are not exact, if there are any.
    pub fn worst_residual(&self) -> Option<(f64, f64)> {
        let inexact = self.entries.iter().filter(|e| e.tolerance > 0.0);
        let worst = inexact.max_by(|a, b| a.severity().total_cmp(&b.severity()));
        worst.map(|e| (e.worst_residual, e.tolerance))
    }

    /// The forgery that is hardest to see, by its residual over the tolerance.
    pub fn weakest_forgery(&self) -> Option<&'a Forgery> {
        let all = self
            .entries
            .iter()
            .flat_map(|e| &e.forgeries)
            .filter(|f| f.margin.is_some());
        all.min_by(|a, b| a.margin.unwrap_or(0.0).total_cmp(&b.margin.unwrap_or(0.0)))
    }

    /// What the claim need not do, in whole sentences.
    pub fn excuses(&self) -> Vec<String> {
        let one = self.entries.iter().find_map(|e| e.one_method.as_ref());
        let few = self.entries.iter().find_map(|e| e.few_cases.as_ref());
        let one = one.map(|why| format!("One method only: {why}."));
        let few = few.map(|why| format!("Few instances: {why}."));
        one.into_iter().chain(few).collect()
    }

    /// Pass if all entries do.
    pub fn verdict(&self) -> Verdict {
        let fails = self.entries.iter().any(|e| e.verdict == Verdict::Fail);
        if fails { Verdict::Fail } else { Verdict::Pass }
    }
}

impl Entry {
    /// Residual over tolerance.
    fn severity(&self) -> f64 {
        self.worst_residual / self.tolerance
    }

    /// The arguments of `regge-verify` that repeat this entry alone.
    pub fn replay(&self, seed: u64) -> String {
        format!(
            "--only {} --dimension {} --seed {seed}",
            self.label, self.dimension
        )
    }

    /// What went wrong, in a few lines.
    pub fn describe_failure(&self) -> String {
        let mut text = format!(
            "{} (N = {}, {}) fails",
            self.label, self.dimension, self.method
        );
        if let Some(failure) = &self.failure {
            let _ = write!(text, " at case {}: {}", failure.case, failure.what);
            if !failure.detail.is_empty() {
                let _ = write!(text, " [{}]", failure.detail);
            }
            if !failure.instance.is_empty() {
                let _ = write!(
                    text,
                    "; smallest instance found: {}",
                    shortened(&failure.instance)
                );
            }
        }
        for forgery in self.forgeries.iter().filter(|f| !f.caught) {
            let _ = write!(text, "\n    not caught: {}", forgery.name);
        }
        text
    }
}

/// The first few numbers of an instance.
fn shortened(numbers: &[String]) -> String {
    const SHOWN: usize = 6;
    let mut text = numbers
        .iter()
        .take(SHOWN)
        .cloned()
        .collect::<Vec<_>>()
        .join(", ");
    if numbers.len() > SHOWN {
        let _ = write!(text, " and {} more", numbers.len() - SHOWN);
    }
    text
}

impl Report {
    /// The entries by claims, in the order of the catalogue.
    pub fn rows(&self) -> Vec<Row<'_>> {
        let mut rows: Vec<Row<'_>> = Vec::new();
        for entry in &self.claims {
            match rows.iter_mut().find(|r| r.label == entry.label) {
                Some(row) => row.entries.push(entry),
                None => rows.push(Row {
                    label: &entry.label,
                    entries: vec![entry],
                }),
            }
        }
        rows
    }

    /// Did every claim hold, and was every forgery caught?
    pub fn passed(&self) -> bool {
        self.claims.iter().all(|e| e.verdict == Verdict::Pass)
    }

    /// The failed entries, the smallest dimension of each claim first.
    pub fn failures(&self) -> Vec<&Entry> {
        let mut failed: Vec<&Entry> = self
            .claims
            .iter()
            .filter(|e| e.verdict == Verdict::Fail)
            .collect();
        failed.sort_by(|a, b| (&a.label, a.dimension).cmp(&(&b.label, b.dimension)));
        failed
    }

    /// How many forgeries there are, distinct by claim and name.
    pub fn distinct_forgeries(&self) -> usize {
        let names = self
            .claims
            .iter()
            .flat_map(|e| e.forgeries.iter().map(|f| (&e.label, &f.name)));
        names.collect::<std::collections::BTreeSet<_>>().len()
    }

    /// Which claims caught each forgery that was made by hand, by what is wrong with it.
    pub fn caught_by(&self) -> BTreeMap<&str, Vec<&str>> {
        let mut index: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
        for entry in &self.claims {
            for forgery in entry.forgeries.iter().filter(|f| f.caught) {
                let Some(name) = forgery.by_hand() else {
                    continue;
                };
                let labels = index.entry(name).or_default();
                if labels.last() != Some(&entry.label.as_str()) {
                    labels.push(&entry.label);
                }
            }
        }
        index
    }

    /// The table that ends a run.
    pub fn table(&self) -> String {
        let mut text = format!(
            "{:<7}{:<13}{:<22}{:>6}{:>11}{:>11}  {}\n",
            "claim", "N", "by", "cases", "residual", "weakest", "verdict"
        );
        for row in self.rows() {
            let _ = writeln!(
                text,
                "{:<7}{:<13}{:<22}{:>6}{:>11}{:>11}  {}",
                row.label,
                row.dimensions_listed(),
                row.methods().join(" "),
                row.cases(),
                row.worst_residual()
                    .map_or("exact".to_owned(), |(r, _)| format!("{r:.1e}")),
                row.weakest_forgery()
                    .map_or("exact".to_owned(), |f| margin(f.margin)),
                if row.verdict() == Verdict::Pass {
                    row.standing()
                } else {
                    "FAILS".to_owned()
                },
            );
        }
        text + &self.conclusion()
    }

    /// Claims, entries, forgeries, and how many fail.
    pub fn conclusion(&self) -> String {
        let rows = self.rows();
        let failed = rows.iter().filter(|r| r.verdict() == Verdict::Fail).count();
        let forged = self.claims.iter().flat_map(|e| &e.forgeries);
        let missed = forged.filter(|f| !f.caught).count();
        format!(
            "{} claims in {} entries, {} forgeries; {failed} claims fail, {missed} forgeries not caught; seed {}\n",
            rows.len(),
            self.claims.len(),
            self.distinct_forgeries(),
            self.seed,
        )
    }
}

/// A margin as tables show it.
pub(super) fn margin(margin: Option<f64>) -> String {
    margin.map_or("exact".to_owned(), |m| format!("×{m:.0e}"))
}

impl Forgery {
    /// What is wrong, if somebody thought of it; nothing for dropped, flipped and doubled terms.
    pub fn by_hand(&self) -> Option<&str> {
        let (_, what) = self.name.split_once(": ")?;
        let automatic = ["drop ", "flip ", "double "]
            .iter()
            .any(|k| what.starts_with(k));
        (!automatic).then_some(what)
    }
}

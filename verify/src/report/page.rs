//! One Markdown page for each claim, and an index.

use super::chain::chain;
use super::coverage::coverage;
use super::data::Report;
use super::exactly::{EXACTLY, degrees, proofs};
use super::markdown::cell;
use super::summary::{Row, margin};
use crate::harness::{Entry, Forgery, Record, Verdict};
use crate::paper::statements;
use std::fmt::Write;

/// A file of the report.
#[derive(Clone, Debug)]
pub struct Page {
    /// Its name.
    pub name: String,
    /// What is in it.
    pub content: String,
}

/// The index, a page for each claim that was run, and how they hang together.
pub fn pages(report: &Report, records: &[&Record]) -> Vec<Page> {
    let rows = report.rows();
    let mut pages = vec![index(report, &rows, records)];
    for row in &rows {
        if let Some(record) = records.iter().find(|r| r.label == row.label) {
            pages.push(Page {
                name: format!("{}.md", row.label),
                content: page(row, record),
            });
        }
    }
    pages.push(Page {
        name: "chain.md".to_owned(),
        content: chain(report),
    });
    pages
}

pub(super) fn verdict(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Pass => "holds",
        Verdict::Fail => "**fails**",
    }
}

pub(super) fn residual(entry: &Entry) -> String {
    if entry.tolerance > 0.0 {
        format!("{:.1e}", entry.worst_residual)
    } else {
        "0, exactly".to_owned()
    }
}

/// The tolerance, or the chance that a false identity was taken for a true one.
pub(super) fn allowed(entry: &Entry) -> String {
    match entry.false_accept_log2 {
        Some(log2) => format!("chance < 2^{log2:.0}"),
        None if entry.proof.is_some() => "proved".to_owned(),
        None => format!("{:.1e}", entry.tolerance),
    }
}

/// What the reader of a claim should know of all of them.
pub(super) const SHARED: &str = "\
Each page says what keeps the two sides of a claim apart. Points, meshes, quadrature, jets and polynomials (floors 0 to 2 \
of the library) serve both sides. Of what lies above, both sides may use the connection, normals and volume forms of a \
metric; where one formula of the paper is on both sides, the page says so, and which claim pins it down against a value \
from elsewhere.";

fn index(report: &Report, rows: &[Row<'_>], records: &[&Record]) -> Page {
    let mut text = format!(
        "# Verification report\n\nregge {}. {}\n{SHARED}\n\n| claim | | N | by | cases | worst residual | weakest forgery | verdict |\n|---|---|---|---|---|---|---|---|\n",
        report.version,
        report.conclusion(),
    );
    for row in rows {
        let title = records
            .iter()
            .find(|r| r.label == row.label)
            .map_or("", |r| r.title);
        let _ = writeln!(
            text,
            "| [{0}]({0}.md) | {title} | {1} | {2} | {3} | {4} | {5} | {6} |",
            row.label,
            row.dimensions_listed(),
            row.methods().join(", "),
            row.cases(),
            row.worst_residual()
                .map_or("exact".to_owned(), |(r, _)| format!("{r:.1e}")),
            row.weakest_forgery()
                .map_or("exact".to_owned(), |f| margin(f.margin)),
            row.standing(),
        );
    }
    text += "\n## Forgeries made by hand, and the claims that caught them\n\n| what is wrong | caught by |\n|---|---|\n";
    for (name, labels) in report.caught_by() {
        let _ = writeln!(text, "| {} | {} |", cell(name), labels.join(", "));
    }
    text += EXACTLY;
    text += &coverage(&statements());
    Page {
        name: "index.md".to_owned(),
        content: text,
    }
}

/// Of two rows for one dimension and method.
const STRETCHED: &str = "\nOf two rows for one N by one method the second is for cells that are stretched 1 : 30, whose metrics have \
components as of one with eigenvalues 1 and 1/900: their inverses have fewer digits.\n";

fn page(row: &Row<'_>, record: &Record) -> String {
    let statement = record
        .statement
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ");
    let mut text = format!(
        "# {}. {}\n\n$$\n{statement}\n$$\n\n",
        record.label, record.title
    );
    if record.paper.is_empty() {
        text += "Not in the paper.\n\n";
    } else {
        let labels: Vec<String> = record.paper.iter().map(|l| format!("`{l}`")).collect();
        let _ = write!(text, "In the paper: {}.\n\n", labels.join(", "));
    }
    let _ = write!(text, "{}\n\n", record.sides);
    for excuse in row.excuses() {
        let _ = write!(text, "{excuse}\n\n");
    }
    text += "| N | by | scalar | cases | worst residual | allowed | verdict |\n|---|---|---|---|---|---|---|\n";
    for e in &row.entries {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} | {} |",
            e.dimension,
            e.method,
            e.scalar,
            e.cases,
            residual(e),
            allowed(e),
            verdict(e.verdict)
        );
    }
    if row.has_stretched() {
        text += STRETCHED;
    }
    proofs(&mut text, row);
    degrees(&mut text, row);
    forgeries(&mut text, row);
    text
}

/// Every forgery with the dimensions where it was caught, and where it changes nothing.
fn forgeries(text: &mut String, row: &Row<'_>) {
    text.push_str("\n## Forgeries\n\n| forgery | caught | weakest margin | changes nothing | refuted by |\n|---|---|---|---|---|\n");
    for name in names(row) {
        let at = |e: &Entry| format!("N = {} {}", e.dimension, e.method);
        let found: Vec<_> = row
            .entries
            .iter()
            .flat_map(|e| {
                e.forgeries
                    .iter()
                    .filter(|f| f.name == name)
                    .map(move |f| (e, f))
            })
            .collect();
        let missed: Vec<String> = found
            .iter()
            .filter(|(_, f)| !f.caught)
            .map(|(e, _)| at(e))
            .collect();
        let weakest = row.weakest_of(&name);
        let reason = row.entries.iter().find_map(|e| {
            let v = e.vacuous.iter().find(|v| v.name == name)?;
            Some(format!("N = {}: {}", e.dimension, v.reason))
        });
        let caught = match (found.is_empty(), missed.is_empty()) {
            (true, _) => "–".to_owned(),
            (_, true) => format!("in all {} entries", found.len()),
            _ => format!("**missed: {}**", missed.join(", ")),
        };
        let _ = writeln!(
            text,
            "| {} | {caught} | {} | {} | {} |",
            cell(&name),
            if found.is_empty() {
                "–".to_owned()
            } else {
                margin(weakest)
            },
            cell(&reason.unwrap_or_default()),
            cell(&refuted_by(&found))
        );
    }
}

/// The point that refutes a forgery, in the lowest dimension.
fn refuted_by(found: &[(&&Entry, &Forgery)]) -> String {
    let points = found
        .iter()
        .filter_map(|(e, f)| Some((e.dimension, f.refuted_at.as_ref()?)));
    let lowest = points.min_by_key(|(dimension, _)| *dimension);
    lowest.map_or(String::new(), |(n, point)| format!("N = {n}: {point}"))
}

/// The names of all forgeries of a claim, each once.
pub(super) fn names(row: &Row<'_>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for entry in &row.entries {
        let caught = entry.forgeries.iter().map(|f| &f.name);
        for name in caught.chain(entry.vacuous.iter().map(|v| &v.name)) {
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
    }
    names
}

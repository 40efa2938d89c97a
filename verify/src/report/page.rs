//! One Markdown page for each claim, and an index.

use super::coverage::coverage;
use super::data::Report;
use super::markdown::cell;
use super::summary::{Row, margin};
use crate::harness::{Bound, Entry, Record, Verdict};
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

/// The index and a page for each claim that was run.
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
        None => format!("{:.1e}", entry.tolerance),
    }
}

/// What the reader of a claim should know of all of them.
pub(super) const SHARED: &str = "\
Each page says what keeps the two sides of a claim apart. Points, meshes, quadrature, jets and polynomials (floors 0 to 2 \
of the library) serve both sides. Of what lies above, both sides may use the connection, normals and volume forms of a \
metric; where one formula of the paper is on both sides, the page says so, and which claim pins it down against a value \
from elsewhere.

An exact run records the program that the library's code executes and runs it at random elements of two fields, with \
2⁶¹ − 1 and 2⁶² − 57 elements. The degrees on the pages are counted along that program, cleared of denominators, a root \
counting half of what is under it; g = AAᵀ + ½δ is of degree two in what is drawn. Of k roots 2ᵏ choices of signs make a \
polynomial of 2ᵏ times the degree, and one draw in 2ᵏ has all roots that are asked for (the second number). The chance \
is that of the draws from one field alone, since a false identity may hold modulo the other prime.";

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
            verdict(row.verdict()),
        );
    }
    text += "\n## Forgeries made by hand, and the claims that caught them\n\n| what is wrong | caught by |\n|---|---|\n";
    for (name, labels) in report.caught_by() {
        let _ = writeln!(text, "| {} | {} |", cell(name), labels.join(", "));
    }
    text += &coverage(&statements());
    Page {
        name: "index.md".to_owned(),
        content: text,
    }
}

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
    degrees(&mut text, row);
    forgeries(&mut text, row);
    text
}

/// What the chances of the exact runs are computed from.
fn degrees(text: &mut String, row: &Row<'_>) {
    let bounds: Vec<(usize, &Bound)> = (row.entries.iter())
        .filter_map(|e| Some((e.dimension, e.bound.as_ref()?)))
        .collect();
    if bounds.is_empty() {
        return;
    }
    text.push_str(
        "\n## Degrees\n\n| N | degree | roots | degrees by what is drawn |\n|---|---|---|---|\n",
    );
    for (dimension, bound) in bounds {
        let by: Vec<String> = (bound.by_group.iter())
            .map(|(name, degree)| format!("{name}: {degree}"))
            .collect();
        let _ = writeln!(
            text,
            "| {dimension} | {} | {} of {} | {} |",
            bound.degree,
            bound.roots,
            bound.roots_drawn,
            by.join(", ")
        );
    }
}

/// Every forgery with the dimensions where it was caught, and where it changes nothing.
fn forgeries(text: &mut String, row: &Row<'_>) {
    text.push_str("\n## Forgeries\n\n| forgery | caught | weakest margin | changes nothing |\n|---|---|---|---|\n");
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
            "| {} | {caught} | {} | {} |",
            cell(&name),
            if found.is_empty() {
                "–".to_owned()
            } else {
                margin(weakest)
            },
            cell(&reason.unwrap_or_default())
        );
    }
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

//! A page for each claim, its picture, and an index.

use super::chart::chart;
use super::{Measured, Report};
use crate::finding::Entry;
use std::fmt::Write;

/// A file of the report.
#[derive(Clone, Debug)]
pub struct Page {
    /// Its name.
    pub name: String,
    /// What is in it.
    pub content: String,
}

/// The index `analysis.md`, and for each claim a page and a picture.
pub fn pages(report: &Report) -> Vec<Page> {
    let mut pages = vec![index(report)];
    for claim in &report.claims {
        pages.push(Page {
            name: format!("{}.md", claim.label),
            content: page(claim),
        });
        pages.push(Page {
            name: format!("{}.svg", claim.label),
            content: chart(claim),
        });
    }
    pages
}

const READING: &str = "\
An upper bound is judged from one side. *Bound*: the best constant is at most the claimed one, or grows by no power of 1/h \
(or of the degree) over the last three levels; an order that is fitted to three levels may miss what is claimed by 0.2. \
*Sharp*: the constant is not passed, and a share of it that is named is reached. *Rate*: the fitted order is at least the \
claimed one, less 0.2. *Observation*: nothing is claimed. What is seen is the greatest constant, or the mean order over \
three runs of random meshes and fields, ± the difference of the greatest and the least. A *forgery* is a wrong version of the \
statement, which the same rule must refuse.";

fn index(report: &Report) -> Page {
    let mut text = format!(
        "# The analysis, measured\n\nregge {}. {}\n\n`cargo run --release -p regge-verify -- --analysis`\n\n{READING}\n\n\
         | claim | | in the paper | kinds | cases | verdict |\n|---|---|---|---|---|---|\n",
        report.version,
        report.conclusion()
    );
    for claim in &report.claims {
        let mut kinds: Vec<&str> = claim.findings.iter().map(|f| f.kind).collect();
        kinds.sort_unstable();
        kinds.dedup();
        let _ = writeln!(
            text,
            "| [{0}]({0}.md) | {1} | {2} | {3} | {4} | {5} |",
            claim.label,
            claim.title,
            labels(claim),
            kinds.join(", "),
            claim.findings.len(),
            claim.verdict()
        );
    }
    Page {
        name: "analysis.md".to_owned(),
        content: text,
    }
}

fn labels(claim: &Measured) -> String {
    let all: Vec<String> = claim
        .paper
        .iter()
        .map(|label| format!("`{label}`"))
        .collect();
    if all.is_empty() {
        "no label".to_owned()
    } else {
        all.join(", ")
    }
}

fn page(claim: &Measured) -> String {
    let mut text = format!(
        "# {0}. {1}\n\n$$\n{2}\n$$\n\nIn the paper: {3}.\n\n{4}\n\n![{1}]({0}.svg)\n\n\
         | case | kind | claimed | seen | ± | verdict |\n|---|---|---|---|---|---|\n",
        claim.label,
        claim.title,
        claim.statement,
        labels(claim),
        claim.how
    );
    for finding in &claim.findings {
        let Entry {
            case,
            kind,
            claim,
            seen,
            spread,
            verdict,
            ..
        } = finding;
        let _ = writeln!(
            text,
            "| {} | {kind} | {claim} | {seen:.4} | {spread:.3} | {verdict} |",
            cell(case)
        );
    }
    text += "\n## What was measured\n\n| case | levels | values, run by run |\n|---|---|---|\n";
    for finding in &claim.findings {
        let runs: Vec<String> = finding.values.iter().map(|run| numbers(run)).collect();
        let levels = format!("{}: {}", finding.axis, numbers(&finding.levels));
        let _ = writeln!(
            text,
            "| {} | {levels} | {} |",
            cell(&finding.case),
            runs.join("; ")
        );
    }
    text += "\n## Forgeries\n\n| case | forgery | seen | caught |\n|---|---|---|---|\n";
    for finding in &claim.findings {
        for forgery in &finding.forgeries {
            let caught = if forgery.caught { "yes" } else { "**no**" };
            let _ = writeln!(
                text,
                "| {} | {} | {:.4} | {caught} |",
                cell(&finding.case),
                forgery.name,
                forgery.seen
            );
        }
    }
    text
}

/// A bar would end a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

fn numbers(list: &[f64]) -> String {
    let one = |x: &f64| match x.abs() {
        size if size != 0.0 && !(1e-3..1e4).contains(&size) => format!("{x:.3e}"),
        _ => format!("{x:.4}"),
    };
    list.iter().map(one).collect::<Vec<_>>().join(", ")
}

//! `--analysis`: what the analysis of the paper asserts about constants and convergence.

use super::by_label::Document;
use regge_analysis::claims::ALL;
use regge_analysis::report::{Measured, Report, pages};
use regge_analysis::{Effort, is_called};
use regge_terminal::{Bar, Out, Stop, output};
use std::io::Write;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::Instant;

/// Is this the name of a claim of the analysis, its row or a label of the paper that it has?
pub fn knows(name: &str) -> bool {
    ALL.iter().any(|claim| is_called(claim, name))
}

/// Measures, writes the pages and the report, prints the table.
pub fn run(
    effort: &Effort,
    only: &[String],
    folder: &Path,
    json: Option<&Path>,
) -> Result<(), Stop> {
    if let Some(unknown) = only.iter().find(|name| !knows(name)) {
        return Err(Stop::Usage(format!(
            "no claim of the analysis is called {unknown:?}"
        )));
    }
    let report = with_progress(effort, only);
    let report = report.map_err(|error| Stop::Failed(error.to_string()))?;
    std::fs::create_dir_all(folder)
        .map_err(|error| Stop::Failed(format!("{}: {error}", folder.display())))?;
    for page in pages(&report) {
        output::write(&folder.join(page.name), &page.content)?;
    }
    let document = Document::new(&report);
    output::json(&folder.join("analysis.json"), &document)?;
    if let Some(path) = json {
        output::json(path, &document)?;
    }
    let mut out = Out::new();
    write!(out, "{}", report.table())?;
    writeln!(out, "pages: {}", folder.display())?;
    verdict(&report)
}

/// A bar where standard error is a terminal, a line for each claim where it is a file.
fn with_progress(effort: &Effort, only: &[String]) -> Result<Report, regge_curvature::Error> {
    let (bar, start) = (Bar::new(0), Instant::now());
    let begun = AtomicUsize::new(0);
    regge_analysis::run(effort, only, &|claim, total| {
        let what = format!("{} {}", claim.label, claim.title);
        let number = begun.fetch_add(1, Relaxed) + 1;
        if !bar.is_drawn() {
            eprintln!(
                "{number}/{total} {what} (after {} s)",
                start.elapsed().as_secs()
            );
        }
        bar.advance(total as u64, what);
    })
}

fn verdict(report: &Report) -> Result<(), Stop> {
    let failures: Vec<&Measured> = report.failures();
    if failures.is_empty() {
        return Ok(());
    }
    let lines: Vec<String> = failures
        .iter()
        .map(|claim| format!("{} {}: {}", claim.label, claim.title, claim.verdict()))
        .collect();
    Err(Stop::Failed(lines.join("\n")))
}

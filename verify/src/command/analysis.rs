//! `--analysis`: what the analysis of the paper asserts about constants and convergence.

use regge_analysis::claims::ALL;
use regge_analysis::report::{Measured, Report, pages};
use regge_analysis::{Effort, is_called};
use regge_terminal::{Bar, Out, Stop, output};
use std::io::Write;
use std::path::Path;

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
    let bar = Bar::new(0);
    let report = regge_analysis::run(effort, only, &|claim, total| {
        bar.advance(total as u64, format!("{} {}", claim.label, claim.title));
    });
    drop(bar);
    let report = report.map_err(|error| Stop::Failed(error.to_string()))?;
    std::fs::create_dir_all(folder)
        .map_err(|error| Stop::Failed(format!("{}: {error}", folder.display())))?;
    for page in pages(&report) {
        output::write(&folder.join(page.name), &page.content)?;
    }
    output::json(&folder.join("analysis.json"), &report)?;
    if let Some(path) = json {
        output::json(path, &report)?;
    }
    let mut out = Out::new();
    write!(out, "{}", report.table())?;
    writeln!(out, "pages: {}", folder.display())?;
    verdict(&report)
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

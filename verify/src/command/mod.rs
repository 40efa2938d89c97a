//! The arguments, and what is done with them.

mod analysis;
mod by_label;

use regge_analysis::Effort;
use regge_terminal::{Bar, Out, Stop, output};
use regge_verify::certificates::certificates;
use regge_verify::claims::{catalogue, records};
use regge_verify::harness::Budget;
use regge_verify::report::{Report, document, pages};
use regge_verify::{Options, errata, paper, run};
use std::io::Write;
use std::path::{Path, PathBuf};

const DETAILS: &str = "\
Labels are rows of the catalogue (P13) or labels of the paper's source (thm:distcurvdot).
Claims of the analysis (A01: bounds, rates, constants) are measured with --analysis, or where --only names them alone.
A claim passes if it holds at every random instance and every forgery of it is caught.
A run of everything also writes the errata: over an errata.md beside the folder of pages, as in docs, or else into it.

Examples:
  regge-verify                              everything; pages in target/verification
  regge-verify --only P20 --dimension 3     one claim in one dimension
  regge-verify --seed 7 --json report.json  other random instances, the report as data
  regge-verify --certificates certificates  what is proved as theorems for Coq, with a script
  regge-verify --analysis                   the constants and orders of convergence that the paper asserts

Exit codes: 0 all hold, 1 a claim fails, a forgery was not caught or a file could not be written, 2 bad arguments.";

/// How this program is run from the sources.
const COMMAND: &str = "cargo run --release -p regge-verify --";

/// Checks every statement of the paper, and that wrong versions of it are caught.
#[derive(clap::Parser)]
#[command(name = "regge-verify", version, after_help = DETAILS)]
pub struct Args {
    /// Only this claim; may be given more than once
    #[arg(long, value_name = "LABEL")]
    only: Vec<String>,
    /// Only this dimension
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(2..=5))]
    dimension: Option<u8>,
    /// Where all random instances come from
    #[arg(long, default_value_t = Options::default().seed)]
    seed: u64,
    /// Fewer instances
    #[arg(long)]
    quick: bool,
    /// Measures constants and orders of convergence instead
    #[arg(long, conflicts_with = "dimension")]
    analysis: bool,
    /// Writes what is proved for N = 2 and 3 as theorems for Coq into this folder instead; check.sh there has coqc check them
    #[arg(long, value_name = "DIR", conflicts_with_all = ["only", "dimension", "quick", "analysis", "json"])]
    certificates: Option<PathBuf>,
    /// Writes the report as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Where the pages go
    #[arg(long, value_name = "DIR", default_value = "target/verification")]
    report: PathBuf,
}

impl Args {
    /// Runs the claims, writes the pages, prints the table.
    pub fn run(self) -> Result<(), Stop> {
        if let Some(path) = &self.json {
            output::check(path)?;
        }
        if let Some(folder) = &self.certificates {
            return write_certificates(folder, self.seed);
        }
        if self.analysis || self.names_analysis_alone() {
            let effort = Effort::new(self.seed, self.quick);
            return analysis::run(&effort, &self.only, &self.report, self.json.as_deref());
        }
        self.only.iter().try_for_each(|name| reason(name))?;
        let everything = self.only.is_empty() && self.dimension.is_none() && !self.quick;
        let options = Options {
            only: self.only,
            dimension: self.dimension.map(usize::from),
            seed: self.seed,
            quick: self.quick,
            ..Options::default()
        };
        let report = with_bar(&options)?;
        if report.claims.is_empty() {
            return Err(Stop::Usage(
                "none of these claims is made in that dimension".to_owned(),
            ));
        }
        write_pages(&report, &self.report)?;
        if everything {
            write_errata(&self.report)?;
        }
        if let Some(path) = &self.json {
            output::json(path, &report)?;
        }
        let mut out = Out::new();
        write!(out, "{}", report.table())?;
        writeln!(out, "pages: {}", self.report.display())?;
        verdict(&report)
    }
}

impl Args {
    /// Does `--only` name claims of the analysis, and nothing of the catalogue?
    fn names_analysis_alone(&self) -> bool {
        let catalogued = |name: &String| {
            let is = |r: &&regge_verify::harness::Record| {
                r.label.eq_ignore_ascii_case(name) || r.paper.contains(&&**name)
            };
            records().iter().any(is)
        };
        let mut names = self.only.iter();
        !self.only.is_empty() && names.all(|name| analysis::knows(name) && !catalogued(name))
    }
}

/// A label of the paper without a claim: why there is none.
fn reason(name: &str) -> Result<(), Stop> {
    match paper::labels().remove(name).and_then(|label| label.reason) {
        Some(reason) => Err(Stop::Usage(format!("{name} has no claim: {reason}"))),
        None => Ok(()),
    }
}

fn with_bar(options: &Options) -> Result<Report, Stop> {
    let bar = Bar::new(0);
    let report = run(options, &|progress| {
        let (label, n) = (&progress.entry.label, progress.entry.dimension);
        bar.advance(progress.total as u64, format!("{label} (N = {n})"));
    });
    drop(bar);
    let mut report = report.map_err(|unknown| Stop::Usage(unknown.to_string()))?;
    report.revision = revision();
    Ok(report)
}

/// The revision of the checkout that the command runs in. Not known at build time: a build that depended on it would
/// compile the whole catalogue anew at each commit.
fn revision() -> String {
    let git = std::process::Command::new("git")
        .args(["rev-parse", "--short=12", "HEAD"])
        .output();
    let text = git
        .ok()
        .filter(|o| o.status.success())
        .and_then(|o| String::from_utf8(o.stdout).ok());
    text.map_or_else(|| "unknown".to_owned(), |t| t.trim().to_owned())
}

fn write_pages(report: &Report, folder: &Path) -> Result<(), Stop> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Stop::Failed(format!("{}: {error}", folder.display())))?;
    let records = records();
    for page in pages(report, &records) {
        output::write(&folder.join(page.name), &page.content)?;
    }
    output::write(&folder.join("index.html"), &document(report, &records))?;
    output::json(&folder.join("report.json"), report)
}

fn write_certificates(folder: &Path, seed: u64) -> Result<(), Stop> {
    let files = certificates(&catalogue(), &Budget::full(seed));
    std::fs::create_dir_all(folder.join("forged"))
        .map_err(|error| Stop::Failed(format!("{}: {error}", folder.display())))?;
    for file in &files {
        output::write(&folder.join(&file.path), &file.content)?;
    }
    let mut out = Out::new();
    let forged = files
        .iter()
        .filter(|f| f.path.starts_with("forged/"))
        .count();
    writeln!(
        out,
        "{} files, {forged} of them forged; to be checked by: sh {}",
        files.len(),
        folder.join("check.sh").display()
    )?;
    Ok(())
}

/// The errata, with the numbers that show them.
fn write_errata(folder: &Path) -> Result<(), Stop> {
    const NAME: &str = "errata.md";
    let page = errata::page().map_err(|error| Stop::Failed(format!("the errata: {error}")))?;
    let beside = folder.join("..").join(NAME);
    let path = if beside.is_file() {
        beside
    } else {
        folder.join(NAME)
    };
    output::write(&path, &page)
}

/// A failed claim ends the program with the instance that shows it.
fn verdict(report: &Report) -> Result<(), Stop> {
    let failures = report.failures();
    let Some(first) = failures.first() else {
        return Ok(());
    };
    let mut text = String::new();
    for entry in &failures {
        text += &format!("{}\n", entry.describe_failure());
    }
    Err(Stop::Failed(format!(
        "{text}replay the first: {COMMAND} {}",
        first.replay(report.seed)
    )))
}

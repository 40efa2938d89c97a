//! Break one formula of the library, and the catalogue names the claims that it broke.
//!
//! The claims run through the library's own code with one number of `Formulas` changed.

mod faults;
mod mesh;
mod pointwise;

use regge_curvature::formulas::Formulas;
use regge_verify::claims::Catalogue;
use regge_verify::report::Report;
use regge_verify::{Options, run_catalogue};

/// The quick catalogue in a dimension with these formulas; of these claims only those that are named, or all if none is.
fn report(claims: Catalogue, dimension: usize, formulas: Formulas, only: &[&str]) -> Report {
    let options = Options {
        only: only.iter().map(|&label| label.to_owned()).collect(),
        quick: true,
        dimension: Some(dimension),
        formulas,
        ..Options::default()
    };
    run_catalogue(claims, &options, &|_| ()).unwrap_or_else(|e| panic!("{e}"))
}

/// The labels that fail, each once, in the order of the catalogue.
fn broken(report: &Report) -> Vec<String> {
    let mut labels: Vec<String> = report.failures().iter().map(|e| e.label.clone()).collect();
    labels.dedup();
    labels
}

/// What is wrong with the labels that fail: some that must fail hold, or some that must hold fail.
fn complaints(found: &[String], broken: &[&str], sound: &[&str]) -> Vec<String> {
    let fails = |label: &&&str| found.iter().any(|l| l == **label);
    let holding = broken.iter().filter(|l| !fails(l));
    let failing = sound.iter().filter(fails);
    let (holding, failing) = (
        holding.map(|l| format!("{l} holds; broken: {found:?}")),
        failing.map(|l| format!("{l} fails; broken: {found:?}")),
    );
    holding.chain(failing).collect()
}

//! The catalogue holds, by a quicker draw than that of the command.

use regge_verify::{Options, run};

#[test]
fn every_claim_holds_and_every_forgery_is_caught() {
    let options = Options {
        quick: true,
        ..Options::default()
    };
    let report = run(&options, &|_| ()).unwrap_or_else(|e| panic!("{e}"));
    let failed: Vec<String> = report
        .failures()
        .iter()
        .map(|e| e.describe_failure())
        .collect();
    assert!(failed.is_empty(), "\n{}", failed.join("\n"));
}

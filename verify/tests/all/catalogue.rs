//! The catalogue holds, by a quicker draw than that of the command.

use regge_verify::claims::records;
use regge_verify::report::{document, pages};
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

    // The statements are readable LaTeX: none of the formulas is left as source or marked as an error.
    let records = records();
    for record in &records {
        let html = document(&report, &[record]);
        assert!(
            html.contains("<math") && !html.contains("merror"),
            "{}",
            record.label
        );
    }
    assert_eq!(
        pages(&report, &records).len(),
        records.len() + 2,
        "a page each, the index and the chain"
    );

    // The issue asks for 150 forgeries over the whole catalogue; the claims at a point alone have more.
    assert!(
        report.distinct_forgeries() >= 150,
        "{}",
        report.conclusion()
    );
}

#[test]
fn the_same_seed_gives_the_same_report_and_another_seed_another() {
    let report = |seed| {
        let only = vec!["P20".to_owned(), "thm:distcurvdot".to_owned()];
        let options = Options {
            only,
            dimension: Some(3),
            seed,
            quick: true,
            ..Options::default()
        };
        let report = run(&options, &|_| ()).unwrap_or_else(|e| panic!("{e}"));
        assert!(report.passed(), "{}", report.table());
        serde_json::to_string(&report).unwrap_or_else(|e| panic!("{e}"))
    };
    assert_eq!(report(1), report(1));
    assert_ne!(report(1), report(2));
}

#[test]
fn an_unknown_label_is_met_with_the_nearest() {
    let options = Options {
        only: vec!["P2O".to_owned()],
        ..Options::default()
    };
    let unknown = run(&options, &|_| ()).expect_err("there is no such claim");
    assert!(unknown.nearest.iter().any(|l| l == "P20"), "{unknown}");
    let options = Options {
        only: vec!["prop:Homegado".to_owned()],
        ..Options::default()
    };
    let unknown = run(&options, &|_| ()).expect_err("there is no such claim");
    assert!(unknown.to_string().contains("prop:Homegadot"), "{unknown}");
}

//! `regge-verify` as a program.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn regge(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_regge-verify"))
        .args(arguments)
        .output()
        .expect("the program runs")
}

/// An empty folder of this test.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    path
}

#[test]
fn one_claim_in_one_dimension() {
    let pages = folder("one-claim");
    let json = pages.with_extension("json");
    let output = regge(&[
        "--only",
        "prop:Homegadot",
        "--dimension",
        "3",
        "--seed",
        "7",
        "--quick",
        "--report",
        pages.to_str().expect("a path"),
        "--json",
        json.to_str().expect("a path"),
    ]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let text = String::from_utf8(output.stdout).expect("text");
    assert!(text.contains("P20") && text.contains("seed 7"), "{text}");

    let written = std::fs::read_to_string(&json).expect("the report");
    let report: Value = serde_json::from_str(&written).expect("JSON");
    for key in ["version", "revision", "seed", "claims"] {
        assert!(!report[key].is_null(), "{key}");
    }
    let entry = &report["claims"][0];
    for key in [
        "label",
        "paper",
        "dimension",
        "scalar",
        "method",
        "cases",
        "worst_residual",
        "tolerance",
        "verdict",
        "forgeries",
        "vacuous",
    ] {
        assert!(!entry[key].is_null(), "{key}");
    }
    for page in ["index.md", "P20.md", "index.html", "report.json"] {
        assert!(pages.join(page).is_file(), "{page}");
    }
    let errata = pages.join("errata.md");
    assert!(!errata.exists(), "they belong to a run of everything");
}

#[test]
fn an_unknown_label_is_one_line_and_exit_2() {
    let output = regge(&["--only", "thm:distcurvdott"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let text = String::from_utf8(output.stderr).expect("text");
    assert_eq!(text.trim_end().lines().count(), 1, "{text}");
    assert!(text.contains("thm:distcurvdot,"), "{text}");
}

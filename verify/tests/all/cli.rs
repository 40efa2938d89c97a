//! `regge-verify` as a program.

use crate::schema::faults;
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

/// Measures some claims of the analysis, quickly: what `--json` wrote.
fn measured(only: &[&str]) -> Value {
    let pages = folder(&only.join("-"));
    let json = pages.with_extension("json");
    let path = |path: &PathBuf| path.to_str().expect("a path").to_owned();
    let (pages, file) = (path(&pages), path(&json));
    let mut arguments = vec!["--analysis", "--quick", "--report", &pages, "--json", &file];
    arguments.extend(only.iter().flat_map(|name| ["--only", name]));
    let output = regge(&arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    serde_json::from_str(&std::fs::read_to_string(&json).expect("a file")).expect("JSON")
}

/// `--analysis --json` is what docs/schema says, by claim and by label.
#[test]
fn the_analysis_by_label() {
    let schema = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/schema/regge-1.json");
    let schema = std::fs::read_to_string(schema).expect("the schema");
    let schema: Value = serde_json::from_str(&schema).expect("JSON");
    let report = measured(&["A04", "A24", "A36"]);
    let form = &schema["$defs"]["analysis"];
    assert_eq!(faults(&schema, form, &report, "analysis"), [""; 0]);
    // The test itself: another word for a kind is seen, and so is a field less.
    let mut wrong = report.clone();
    wrong["labels"]["gtbound"]["kind"] = Value::from("identity");
    assert_eq!(faults(&schema, form, &wrong, "analysis").len(), 1);
    wrong["labels"]["cor:conv"]["findings"][0]
        .as_object_mut()
        .expect("a finding")
        .remove("spread");
    assert_eq!(faults(&schema, form, &wrong, "analysis").len(), 2);

    // Every label of the paper is there; those of the three claims with what was seen, the others with their homes alone.
    let labels = report["labels"].as_object().expect("an object");
    assert_eq!(labels.len(), regge_verify::paper::labels().len());
    let seen = |name: &str| labels[name].get("kind").is_some();
    for name in [
        "gtbound",
        "eigbound",
        "Lpequiv1",
        "remark:suboptimal",
        "cor:conv",
    ] {
        assert!(seen(name), "{name}");
    }
    assert!(!seen("angledot") && labels["angledot"]["home"][0] == "P22");
    assert!(!seen("einO") && labels["remark:israel"]["reason"].is_string());
    // |X|² in two metrics is not what the eigenvalues' bounds are about, and Hölder's inequality is sharp.
    let rows = |name: &str| labels[name]["findings"].as_array().expect("a list").len();
    assert_eq!(
        (rows("Lpequiv1"), rows("eigbound"), rows("gtbound")),
        (1, 2, 4)
    );
    let hoelder = &labels["cor:conv"];
    assert_eq!(
        (&hoelder["kind"], &hoelder["verdict"]),
        (&"sharp".into(), &"holds".into())
    );
    assert!(hoelder["seen"].as_f64() > Some(0.999) && hoelder["claimed"] == 1.0);
}

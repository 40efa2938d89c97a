//! The program as its users meet it: arguments, exit codes, files.

use regge_study::Report;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A folder of its own for each test.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    path
}

fn regge(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_regge"));
    command
        .current_dir(folder)
        .args(arguments.split_whitespace());
    command.output().expect("the program runs")
}

fn files(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("a folder");
    let name = |e: fs::DirEntry| e.file_name().to_string_lossy().into_owned();
    let mut names: Vec<String> = entries.map(|e| name(e.expect("an entry"))).collect();
    names.sort();
    names
}

#[test]
fn bad_arguments_are_one_line_and_code_2() {
    let folder = folder("bad");
    for (arguments, expected) in [
        ("foo", "foo"),
        ("reproduce", "<TARGET>"),
        ("reproduce table9", "table1, table2, figure2"),
        ("reproduce table1 --levels x", "0..=7"),
        ("reproduce table1 --levels 3..=2", "no level"),
        ("reproduce table1 --levels 0..=99", "too fine"),
        ("reproduce table1 --levels 0..=4000000000", "out of reach"),
        ("reproduce table1 --degrees 1,a", "invalid digit"),
        ("reproduce table1 --degrees 99", "too high"),
        ("reproduce table1 --seed -1", "--seed"),
        (
            "reproduce table1 --interpolant best",
            "average-hierarchical",
        ),
        ("reproduce table1 --interpolant geodesic", "degree 0"),
        (
            "reproduce table1 --as-printed --quadrature 4",
            "--quadrature",
        ),
        ("reproduce table1 --quadrature 1000", "0..=60"),
        ("reproduce table1 --json a.svg --plot a.svg", "--json too"),
        ("converge", "--metric"),
        ("converge --metric euclid", "graph-quartic"),
        ("converge --metric flat --quantity size", "curvature-error"),
        ("converge --metric flat --dimension 4", "dimension 4"),
        (
            "converge --metric flat --json missing/x.json",
            "no such folder",
        ),
        ("converge --metric flat --json .", "is a folder"),
    ] {
        let output = regge(&folder, arguments);
        let said = String::from_utf8(output.stderr).expect("text");
        assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
        assert_eq!(said.lines().count(), 1, "{arguments}: {said}");
        assert!(
            said.starts_with("regge: ") && said.contains(expected),
            "{arguments}: {said}"
        );
        assert!(output.stdout.is_empty(), "{arguments}");
    }
    assert!(
        files(&folder).iter().all(|name| name == "results"),
        "nothing is written"
    );
}

#[test]
fn verify_says_where_the_claims_are_checked_now() {
    let folder = folder("verify");
    let output = regge(&folder, "verify --only P20 --quick");
    let said = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    let now = "cargo run --release -p regge-verify -- --only P20 --quick\n";
    assert!(said.ends_with(now), "{said}");
    assert!(output.stdout.is_empty());
}

#[test]
fn help_is_no_error() {
    let folder = folder("help");
    for arguments in ["--help", "reproduce --help", "converge --help", "--version"] {
        let output = regge(&folder, arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments}");
        assert!(!output.stdout.is_empty());
    }
}

#[test]
fn a_failed_computation_is_one_line_and_code_1_and_keeps_old_files() {
    let folder = folder("failed");
    fs::write(folder.join("old.json"), "old").expect("a file");
    // On two triangles the canonical interpolant of the sphere is no metric.
    let arguments =
        "converge --metric conformal-sphere --interpolant canonical --levels 0 --json old.json";
    let output = regge(&folder, arguments);
    let said = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(
        said.contains("degree 0, level 0") && said.contains("cell 0"),
        "{said}"
    );
    assert_eq!(files(&folder), ["old.json"]);
    assert_eq!(
        fs::read_to_string(folder.join("old.json")).expect("a file"),
        "old"
    );
}

#[test]
fn the_json_is_one_object_with_rows() {
    let folder = folder("json");
    let output = regge(
        &folder,
        "converge --metric trig --degree 0,1 --levels 0..=1 --json s.json --seed 11",
    );
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty(), "no bar where no terminal is");
    let text = fs::read_to_string(folder.join("s.json")).expect("a file");
    let json: Value = serde_json::from_str(&text).expect("JSON");
    for key in [
        "metric",
        "quantity",
        "quadrature",
        "version",
        "seed",
        "command",
        "rows",
    ] {
        assert!(!json[key].is_null(), "{key}");
    }
    assert_eq!(json["metric"], "trig");
    assert_eq!(json["seed"], 11);
    let rows = json["rows"].as_array().expect("rows");
    assert_eq!(rows.len(), 4);
    let keys = [
        "dimension",
        "degree",
        "level",
        "interpolant",
        "seed",
        "cells",
        "ndof",
        "mesh_size",
        "error",
        "order",
        "printed",
        "seconds",
        "solver",
        "steps",
    ];
    for row in rows {
        let row = row.as_object().expect("an object");
        assert!(keys.iter().all(|key| row.contains_key(*key)) && row.len() == keys.len());
        assert!(row["printed"].is_null(), "the paper has no such metric");
        assert_eq!(row["order"].is_null(), row["level"] == 0);
    }
    serde_json::from_str::<Report>(&text).expect("what was written can be read");
}

#[test]
fn reproduce_shows_and_writes_both_files() {
    let folder = folder("reproduce");
    let output = regge(&folder, "reproduce table1 --levels 0..=1 --as-printed");
    assert_eq!(output.status.code(), Some(0));
    let said = String::from_utf8(output.stdout).expect("text");
    // The printed error of r = 1, k = 0 beside ours, which is the same.
    let line = said
        .lines()
        .find(|line| line.starts_with(" 1  0"))
        .expect("a row");
    assert_eq!(line.matches("8.6127e-2").count(), 2, "{line}");
    assert_eq!(files(&folder), ["results"]);
    assert_eq!(
        files(&folder.join("results")),
        ["table1.json", "table1.svg"]
    );
    let svg = fs::read_to_string(folder.join("results/table1.svg")).expect("a file");
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    assert!(svg.contains("printed in the paper") && svg.contains("r = 2"));
    let said =
        String::from_utf8(regge(&folder, "reproduce table1 --levels 0").stdout).expect("text");
    assert!(
        said.contains("about 2.4 times"),
        "it says how and why it differs: {said}"
    );
}

#[test]
fn existing_files_are_replaced_whole() {
    let folder = folder("replace");
    let long = "x".repeat(1 << 20);
    fs::write(folder.join("s.json"), long).expect("a file");
    let output = regge(
        &folder,
        "converge --metric flat --levels 0 --json s.json --plot s.svg",
    );
    assert_eq!(output.status.code(), Some(0));
    let text = fs::read_to_string(folder.join("s.json")).expect("a file");
    serde_json::from_str::<Report>(&text).expect("nothing of the old file is left");
    assert_eq!(files(&folder), ["s.json", "s.svg"]);
}

//! Long runs: rows that are on disk at once, going on after a kill, limits of memory.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("resume-{name}"));
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    path
}

fn regge(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_regge"));
    let command = command
        .current_dir(folder)
        .args(arguments.split_whitespace());
    command.output().expect("the program runs")
}

fn refused(folder: &Path, arguments: &str, code: i32, expected: &str) {
    let output = regge(folder, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments}: {said}");
    assert!(
        said.lines().count() == 1 && said.contains(expected),
        "{arguments}: {said}"
    );
}

const RUN: &str = "reproduce table1 --levels 0..=2 --degrees 0,1 --rows t.jsonl";

/// Everything but the time that a row took.
fn lines(folder: &Path) -> Vec<Value> {
    let text = fs::read_to_string(folder.join("t.jsonl")).expect("a file");
    let parse = |line: &str| {
        let mut value: Value = serde_json::from_str(line).expect("JSON");
        if let Some(row) = value.as_object_mut() {
            row.remove("seconds");
        }
        value
    };
    text.lines().map(parse).collect()
}

#[test]
fn a_run_goes_on_after_a_kill() {
    let folder = folder("kill");
    assert!(regge(&folder, RUN).status.success());
    let whole = lines(&folder);
    // One line for the make of the rows, six rows.
    assert_eq!(whole.len(), 7);
    refused(&folder, RUN, 2, "--resume");
    // As a kill leaves it: three rows, and a fourth that is cut short.
    let path = folder.join("t.jsonl");
    let text = fs::read_to_string(&path).expect("a file");
    let end = text.match_indices('\n').nth(3).expect("four lines").0;
    fs::write(&path, &text[..end + 40]).expect("a file");
    let resumed = regge(&folder, &format!("{RUN} --resume"));
    assert!(resumed.status.success());
    assert_eq!(lines(&folder), whole);
    let shown = String::from_utf8_lossy(&resumed.stdout).into_owned();
    let table = shown
        .lines()
        .filter(|line| line.contains("average-hierarchical"));
    assert!(table.count() >= 6, "{shown}");
    // Nothing is left to do.
    assert!(regge(&folder, &format!("{RUN} --resume")).status.success());
    assert_eq!(lines(&folder), whole);
}

#[test]
fn rows_of_another_study_are_refused() {
    let folder = folder("other");
    assert!(regge(&folder, RUN).status.success());
    refused(
        &folder,
        &format!("{RUN} --resume --seed 4"),
        2,
        "another study",
    );
    fs::write(folder.join("t.jsonl"), "no rows\n").expect("a file");
    refused(&folder, &format!("{RUN} --resume"), 2, "t.jsonl:1");
    refused(&folder, "reproduce table1 --resume", 2, "--rows");
    refused(
        &folder,
        "reproduce table1 --rows nowhere/t.jsonl",
        2,
        "nowhere",
    );
}

#[test]
fn what_does_not_fit_into_memory_is_refused() {
    let folder = folder("memory");
    refused(
        &folder,
        "reproduce table2 --levels 0..=6 --degrees 2 --memory-limit 0.5",
        2,
        "degree 2, level 5 needs about",
    );
    refused(&folder, "reproduce table2 --memory-limit -1", 2, "GiB");
    assert!(!folder.join("results/table2.json").exists());
}

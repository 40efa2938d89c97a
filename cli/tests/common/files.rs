//! Files and runs of `regge curvature`.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A square of four triangles.
pub const SQUARE: &str = r#"{"dimension": 2, "vertices": [[0,0],[1,0],[1,1],[0,1],[0.5,0.5]],
 "cells": [[0,1,4],[1,2,4],[2,3,4],[3,0,4]]}"#;

/// A square of n × n squares, cut in two each, as JSON.
pub fn grid(n: usize) -> String {
    let line = |i: usize| (0..=n).map(move |j| format!("[{i},{j}]"));
    let vertices: Vec<String> = (0..=n).flat_map(line).collect();
    let pair = |i: usize, j: usize| {
        let a = i * (n + 1) + j;
        let [b, c, d] = [a + 1, a + n + 1, a + n + 2];
        format!("[{a},{b},{c}],[{b},{c},{d}]")
    };
    let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    let cells: Vec<String> = cells.map(|(i, j)| pair(i, j)).collect();
    format!(
        r#"{{"dimension": 2, "vertices": [{}], "cells": [{}]}}"#,
        vertices.join(","),
        cells.join(",")
    )
}

/// A folder of its own for each test.
pub fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("curvature-{name}"));
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    path
}

/// Writes a file.
pub fn write(folder: &Path, name: &str, text: &str) {
    fs::write(folder.join(name), text).expect("a file");
}

/// Runs `regge curvature`.
pub fn regge(folder: &Path, arguments: &str) -> Output {
    run(folder, "curvature", arguments)
}

/// Runs a command.
pub fn run(folder: &Path, name: &str, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_regge"));
    let arguments = arguments.split_whitespace();
    let command = command.current_dir(folder).arg(name).args(arguments);
    command.output().expect("the program runs")
}

/// The JSON that the command writes.
pub fn curvature(folder: &Path, arguments: &str) -> Value {
    let output = regge(folder, &format!("{arguments} --json out.json"));
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments}: {said}");
    let text = fs::read_to_string(folder.join("out.json")).expect("a file");
    serde_json::from_str(&text).expect("JSON")
}

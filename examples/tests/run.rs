//! The examples run, and the last lines of what they print are what their heads say.

use std::process::Command;

/// The numbers in the last lines of what a program prints.
fn printed(program: &str, lines: usize) -> Vec<Vec<f64>> {
    let output = Command::new(program).output().expect("it was built");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    let text = String::from_utf8(output.stdout).expect("text");
    let words = |line: &str| -> Vec<f64> {
        let words = line.split([' ', ',', ':']);
        words.filter_map(|word| word.parse().ok()).collect()
    };
    let all: Vec<&str> = text.lines().collect();
    all[all.len() - lines..]
        .iter()
        .map(|line| words(line))
        .collect()
}

/// The left and the right side are the same at the last order, up to some roundings of numbers of size 10.
#[test]
fn derivative() {
    let last = &printed(env!("CARGO_BIN_EXE_derivative"), 1)[0];
    assert!(last.len() == 4 && last[3] < 1e-12, "{last:?}");
}

/// Gauss and Bonnet up to the rounding of sums over thousands of cells; and R_h comes nearer to 2: the last two meshes differ by a half in
/// width, at third order and better that is a tenth of the distance.
#[test]
fn gauss_bonnet() {
    let rows = printed(env!("CARGO_BIN_EXE_gauss_bonnet"), 2);
    for row in &rows {
        assert!(row.len() == 5 && row[3].abs() < 1e-11, "{row:?}");
    }
    assert!(rows[1][4] < 0.1 * rows[0][4], "{rows:?}");
}

/// Order r + 1 at r = 2; it is not yet asymptotic.
#[test]
fn graph() {
    let last = &printed(env!("CARGO_BIN_EXE_graph"), 1)[0];
    assert!(last.len() == 4 && (last[3] - 3.0).abs() < 0.1, "{last:?}");
}

/// N kernel directions for each inner vertex.
#[test]
fn relax() {
    let rows = printed(env!("CARGO_BIN_EXE_relax"), 2);
    let below = rows[0].iter().rev().nth(1).expect("how many there are");
    assert_eq!(Some(below), rows[1].last(), "{rows:?}");
}

/// The total is 8π up to the rounding of 16 386 vertices' angles.
#[test]
fn sphere() {
    let last = &printed(env!("CARGO_BIN_EXE_sphere"), 1)[0];
    assert!(last.len() == 3 && last[2].abs() < 1e-10, "{last:?}");
}

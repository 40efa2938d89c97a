//! What is wrong is said as it is: stated curvatures, thin cells, studies of nothing, limits.

use crate::common::files::{SQUARE, curvature, folder, grid, regge, run, write};
use std::fs;
use std::path::Path;

const SPHERE: &str = "dimension = 2\nconformal = \"4/(1 + x^2 + y^2)^2\"\n";

/// One line, of this code.
fn refused(folder: &Path, command: &str, arguments: &str, code: i32, expected: &[&str]) {
    let output = run(folder, command, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(code), "{arguments}: {said}");
    assert_eq!(said.lines().count(), 1, "{arguments}: {said}");
    for part in expected {
        assert!(said.contains(part), "{arguments}: {said}");
    }
}

#[test]
fn a_stated_curvature_is_compared_with_the_metrics_own() {
    let folder = folder("stated");
    write(&folder, "m.json", SQUARE);
    let command = "--mesh m.json --degree 1 --norm hm2 --metric g.toml";
    for (stated, value) in [
        ("2.001", "is 2.001 at x = ["),
        ("1/x", "own scalar curvature is "),
    ] {
        write(
            &folder,
            "g.toml",
            &format!("{SPHERE}exact_scalar_curvature = \"{stated}\"\n"),
        );
        refused(
            &folder,
            "curvature",
            command,
            2,
            &[value, "--trust-exact-curvature"],
        );
    }
    // Those who insist have it; without a norm it is not used.
    write(
        &folder,
        "g.toml",
        &format!("{SPHERE}exact_scalar_curvature = \"2.001\"\n"),
    );
    let insisted = curvature(&folder, &format!("{command} --trust-exact-curvature"));
    assert!(insisted["hm2"]["error"].as_f64().is_some());
    curvature(&folder, "--mesh m.json --metric g.toml");
    // What is right to rounding is taken, in other words too, and 0 where terms cancel.
    let flat = "dimension = 2\ng = [[\"1 + x^2/25\", \"x/5\"], [\"x/5\", \"1\"]]\nexact_scalar_curvature = \"0\"\n";
    let sphere = format!("{SPHERE}exact_scalar_curvature = \"1.9999999999 + 1e-10\"\n");
    for metric in [flat, &sphere] {
        write(&folder, "g.toml", metric);
        curvature(&folder, command);
    }
}

/// A square cut into strips of this width: 2n thin triangles.
fn strips(width: f64, n: usize) -> String {
    let (mut vertices, mut cells) = (Vec::new(), Vec::new());
    for i in 0..=n {
        let x = width * i as f64;
        vertices.extend([format!("[{x:e},0]"), format!("[{x:e},1]")]);
    }
    for i in 0..n {
        let a = 2 * i;
        cells.extend([
            format!("[{},{},{}]", a, a + 1, a + 2),
            format!("[{},{},{}]", a + 1, a + 2, a + 3),
        ]);
    }
    format!(
        r#"{{"dimension": 2, "vertices": [{}], "cells": [{}]}}"#,
        vertices.join(","),
        cells.join(",")
    )
}

/// Neither a programmer's message nor a wrong reason: the identity is a metric, whatever the cells.
#[test]
fn thin_cells_are_blamed_for_what_they_do() {
    let folder = folder("thin");
    write(&folder, "g.toml", "dimension = 2\nconformal = \"1\"\n");
    for width in [1e-3, 1e-6, 1e-9] {
        write(&folder, "m.json", &strips(width, 40));
        for arguments in [
            "",
            "--norm hm2 --degree 2",
            "--norm hm2 --degree 4",
            "--degree 1 --json o.json",
        ] {
            let output = regge(
                &folder,
                &format!("--mesh m.json --metric g.toml {arguments}"),
            );
            let said = String::from_utf8_lossy(&output.stderr);
            if output.status.code() == Some(0) {
                continue;
            }
            assert_eq!(output.status.code(), Some(1), "{width} {arguments}: {said}");
            assert_eq!(said.lines().count(), 1, "{said}");
            for wrong in [
                "check the formula",
                "NonPositivePivot",
                "{",
                "refine the mesh or",
            ] {
                assert!(!said.contains(wrong), "{width} {arguments}: {said}");
            }
        }
    }
}

/// Where the cell is too large or too thin for degree 0, every way out that is named is one, and one that is none is not named.
#[test]
fn a_degree_that_is_too_low_is_told_what_does() {
    let folder = folder("low");
    write(&folder, "g.toml", SPHERE);
    let geodesic = "--interpolant geodesic";
    for (triangle, works, fails) in [
        (
            "[[-0.88,-0.4],[0.94,0.75],[-0.39,0.72]]",
            &["--degree 1", geodesic][..],
            &[][..],
        ),
        (
            "[[0.68,0.11],[0.28,-0.63],[0.99,0.72]]",
            &[geodesic],
            &["--degree 1"],
        ),
    ] {
        let mesh = format!(r#"{{"dimension": 2, "vertices": {triangle}, "cells": [[0,1,2]]}}"#);
        write(&folder, "m.json", &mesh);
        let command = "--mesh m.json --metric g.toml";
        let expected = ["interpolant of degree 0", "though the metric is"];
        refused(&folder, "curvature", command, 1, &expected);
        let said = regge(&folder, command).stderr;
        let said = String::from_utf8_lossy(&said);
        for (ways, code) in [(works, 0), (fails, 1)] {
            for way in ways {
                assert_eq!(said.contains(way), code == 0, "{way}: {said}");
                let output = regge(&folder, &format!("{command} {way}"));
                assert_eq!(output.status.code(), Some(code), "{way}");
            }
        }
    }
}

#[test]
fn what_is_asked_for_twice_is_computed_once() {
    let folder = folder("once");
    let count = |text: &[u8]| {
        String::from_utf8_lossy(text)
            .lines()
            .filter(|l| l.contains("canonical  "))
            .count()
    };
    let studies = [
        (
            "converge",
            "--metric trig --degree 0,0,0 --interpolant canonical,canonical --levels 0..=1",
        ),
        (
            "reproduce",
            "table1 --degrees 0,0,0 --interpolant canonical,canonical --levels 0..=1",
        ),
    ];
    for (command, arguments) in studies {
        let output = run(&folder, command, arguments);
        assert_eq!(
            count(&output.stdout),
            2,
            "{}",
            String::from_utf8_lossy(&output.stdout)
        );
    }
    // The first level has no order.
    let text = fs::read_to_string(folder.join("results/table1.json")).expect("a file");
    let report: regge_study::Report = serde_json::from_str(&text).expect("a report");
    assert!(
        report
            .rows
            .iter()
            .all(|row| row.order.is_none() == (row.level == 0))
    );
}

#[test]
fn a_picture_of_nothing_says_so() {
    let folder = folder("nothing-to-see");
    let output = run(
        &folder,
        "converge",
        "--metric flat --levels 0..=2 --plot p.svg",
    );
    assert!(output.status.success());
    let svg = fs::read_to_string(folder.join("p.svg")).expect("a picture");
    assert!(svg.contains("zero up to rounding"), "{svg}");
    let output = run(
        &folder,
        "converge",
        "--metric trig --levels 0..=2 --plot p.svg",
    );
    assert!(output.status.success());
    let svg = fs::read_to_string(folder.join("p.svg")).expect("a picture");
    assert!(!svg.contains("zero up to rounding"));
}

/// Before the metric is even read: it makes no sense.
#[test]
fn a_mesh_that_is_too_large_for_a_picture_is_refused_first() {
    let folder = folder("large");
    write(&folder, "m.json", &grid(225));
    write(&folder, "g.toml", "no metric");
    let command = "--mesh m.json --metric g.toml --plot p.svg";
    refused(
        &folder,
        "curvature",
        command,
        2,
        &["101250 cells", "ParaView"],
    );
}

/// The limits of the shell and of --memory-limit: a line, in numbers that say something.
#[test]
fn what_does_not_fit_is_refused_with_numbers() {
    let folder = folder("memory");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", SPHERE);
    let files = "--mesh m.json --metric g.toml --memory-limit 0.001";
    for command in ["curvature", "action"] {
        refused(
            &folder,
            command,
            files,
            2,
            &["4 cells needs about 19 MiB", "of 1 MiB"],
        );
    }
    // What is listed function by function counts, and the factor by which it is projected.
    write(&folder, "l.json", &grid(100));
    for (degree, expected) in [
        (2, "MiB of memory, of 10 MiB"),
        (8, "GiB of memory, of 10 MiB"),
    ] {
        let command = "--mesh l.json --metric g.toml --memory-limit 0.01 --test-degree";
        refused(
            &folder,
            "curvature",
            &format!("{command} {degree}"),
            2,
            &[expected],
        );
    }
    refused(
        &folder,
        "converge",
        "--metric flat --levels 0 --memory-limit 0.001",
        2,
        &["needs about", "MiB", "--levels"],
    );
    #[cfg(target_os = "linux")]
    {
        let script = format!(
            "ulimit -v 400000; exec \"{}\" reproduce table2 --levels 5 --degrees 2 -q",
            env!("CARGO_BIN_EXE_regge")
        );
        let mut shell = std::process::Command::new("sh");
        let output = shell.current_dir(&folder).args(["-c", &script]).output();
        let output = output.expect("a shell");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.lines().count() == 1 && said.contains("MiB"), "{said}");
    }
}

/// Codes as the help has them.
#[test]
fn a_file_that_cannot_be_read_is_code_2_as_the_help_says() {
    let folder = folder("codes");
    write(&folder, "g.toml", SPHERE);
    refused(
        &folder,
        "curvature",
        "--mesh none.msh --metric g.toml",
        2,
        &["none.msh"],
    );
    refused(&folder, "curvature", "--mesh . --metric g.toml", 2, &["."]);
    let help = std::process::Command::new(env!("CARGO_BIN_EXE_regge"))
        .arg("--help")
        .output();
    let help = String::from_utf8_lossy(&help.expect("help").stdout).into_owned();
    let help: Vec<&str> = help.split_whitespace().collect();
    let expected = "2 the arguments make no sense, or a file that was given cannot be read";
    assert!(help.join(" ").contains(expected), "{help:?}");
}

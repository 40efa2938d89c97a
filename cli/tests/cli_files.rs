//! Which files may be named: none is lost, none is written twice, standard output is one of them.

use crate::common::files::{SQUARE, folder, run, write};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const METRIC: &str = "dimension = 2\nconformal = \"1 + x^2/4\"\n";

/// Runs the program with any arguments.
fn regge(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_regge"));
    let arguments = arguments.split_whitespace();
    let command = command.current_dir(folder).args(arguments);
    command.output().expect("the program runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// One line that names what is wrong, code 2, before any work: a mesh that is no mesh is not even read.
fn refused(folder: &Path, arguments: &str, expected: &str) {
    let output = regge(folder, arguments);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
    assert_eq!(said.lines().count(), 1, "{arguments}: {said}");
    assert!(said.contains(expected), "{arguments}: {said}");
    assert!(output.stdout.is_empty(), "{arguments}");
}

/// A folder with inputs of whatever content, links to them, and what they hold.
fn inputs(name: &str) -> std::path::PathBuf {
    let folder = folder(name);
    for name in ["m.json", "g.toml", "l.csv"] {
        write(&folder, name, "what stood here");
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("m.json", folder.join("soft")).expect("a link");
        fs::hard_link(folder.join("g.toml"), folder.join("hard")).expect("a link");
    }
    fs::create_dir(folder.join("inside")).expect("a folder");
    folder
}

#[test]
fn no_input_is_overwritten_whatever_it_is_called() {
    let folder = inputs("lost");
    let mut cases = vec![];
    for option in ["--json", "--csv"] {
        for command in ["curvature", "einstein", "action"] {
            cases.push((
                format!("{command} --mesh m.json --metric g.toml {option} m.json"),
                "--mesh",
            ));
            cases.push((
                format!("{command} --mesh m.json --metric g.toml {option} ./g.toml"),
                "--metric",
            ));
            cases.push((
                format!("{command} --mesh m.json --lengths l.csv {option} inside/../l.csv"),
                "--lengths",
            ));
        }
    }
    let curvature = "curvature --mesh m.json --metric g.toml";
    cases.push((format!("{curvature} --npz m.json"), "--mesh"));
    if cfg!(unix) {
        cases.push((format!("{curvature} --json soft"), "--mesh"));
        cases.push((format!("{curvature} --json hard"), "--metric"));
    }
    for (arguments, expected) in cases {
        refused(&folder, &arguments, expected);
    }
    // Those that have an ending of their own can only be an input of that ending.
    fs::rename(folder.join("m.json"), folder.join("m.svg")).expect("a file");
    fs::copy(folder.join("m.svg"), folder.join("m.vtu")).expect("a file");
    refused(
        &folder,
        "curvature --mesh m.svg --metric g.toml --plot m.svg",
        "--mesh",
    );
    refused(
        &folder,
        "curvature --mesh m.vtu --metric g.toml --vtu m.vtu",
        "--mesh",
    );
    for name in ["m.svg", "m.vtu", "g.toml", "l.csv"] {
        let found = fs::read_to_string(folder.join(name)).expect("a file");
        assert_eq!(found, "what stood here", "{name}");
    }
}

#[test]
fn no_file_is_written_twice() {
    let folder = inputs("twice");
    for (arguments, expected) in [
        (
            "curvature --mesh m.json --metric g.toml --json f --csv f",
            "--json too",
        ),
        (
            "curvature --mesh m.json --metric g.toml --json f --csv inside/../f",
            "--json too",
        ),
        (
            "curvature --mesh m.json --metric g.toml --csv f.vtu --vtu ./f.vtu",
            "--csv too",
        ),
        (
            "curvature --mesh m.json --metric g.toml --json - --csv -",
            "standard output",
        ),
        (
            "converge --metric flat --json f.svg --plot f.svg",
            "--json too",
        ),
        ("converge --metric flat --json f --rows f", "--json too"),
        (
            "converge --metric flat --plot f.svg --rows inside/../f.svg",
            "--plot too",
        ),
        ("reproduce table1 --json f --rows f", "--json too"),
    ] {
        refused(&folder, arguments, expected);
        assert!(
            !folder.join("f").exists() && !folder.join("results").exists(),
            "{arguments}"
        );
    }
}

#[test]
fn pictures_have_the_endings_of_pictures() {
    let folder = inputs("endings");
    for arguments in [
        "converge --metric flat --levels 0 --plot x.pdf",
        "converge --metric flat --levels 0 --plot x",
        "reproduce table1 --levels 0 --plot x.eps",
        "curvature --mesh m.json --metric g.toml --plot x.pdf",
    ] {
        refused(&folder, arguments, "a picture ends in .svg or .png");
    }
    refused(
        &folder,
        "curvature --mesh m.json --metric g.toml --vtu x.vtk",
        ".vtu",
    );
    if cfg!(not(feature = "png")) {
        let png = "converge --metric flat --levels 0 --plot x.png";
        refused(&folder, png, "--features png");
    }
}

/// A minus is standard output: nothing else is written there, and no file of that name is made.
#[test]
fn standard_output_takes_any_text() {
    let folder = folder("standard");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", METRIC);
    let command = "--mesh m.json --metric g.toml --degree 1";
    for (option, begins) in [
        ("--json", "{\n"),
        ("--csv", "vertex,"),
        ("--plot", "<svg"),
        ("--vtu", "<?xml"),
    ] {
        let output = run(&folder, "curvature", &format!("{command} {option} -"));
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert!(text(&output.stdout).starts_with(begins), "{option}");
        assert!(text(&output.stderr).contains("total curvature"), "{option}");
    }
    let output = run(&folder, "curvature", &format!("{command} --json -"));
    serde_json::from_slice::<serde_json::Value>(&output.stdout).expect("nothing but JSON");
    let output = regge(&folder, "converge --metric flat --levels 0..=1 --json -");
    serde_json::from_slice::<regge_study::Report>(&output.stdout).expect("nothing but JSON");
    assert!(
        text(&output.stderr).contains("canonical"),
        "the table is on standard error"
    );
    let output = regge(&folder, &format!("curvature -q {command} --json -"));
    assert!(output.status.success() && output.stderr.is_empty());
    assert_eq!(
        fs::read_dir(&folder).expect("a folder").count(),
        2,
        "no file is made"
    );
}

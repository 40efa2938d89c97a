//! What the program says and does not say: quiet, verbose, threads, help, no arguments, completions.

use crate::common::files::{SQUARE, folder, grid, write};
use std::path::Path;
use std::process::{Command, Output};

fn regge(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_regge"));
    let arguments = arguments.split_whitespace();
    let command = command.current_dir(folder).args(arguments);
    command.output().expect("the program runs")
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

const COMMANDS: [&str; 5] = ["reproduce", "converge", "curvature", "einstein", "action"];

#[test]
fn without_arguments_there_is_the_short_help() {
    let output = regge(&folder("nothing"), "");
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(COMMANDS.iter().all(|name| said.contains(name)), "{said}");
    assert!(
        said.lines().count() < 40 && output.stdout.is_empty(),
        "{said}"
    );
}

#[test]
fn every_help_has_an_example_and_the_common_options() {
    let folder = folder("helps");
    for command in COMMANDS {
        let said = text(&regge(&folder, &format!("{command} --help")).stdout);
        assert!(
            said.contains(&format!("  regge {command} ")),
            "{command}: {said}"
        );
        for option in ["--quiet", "--verbose", "--threads", "--memory-limit"] {
            assert!(said.contains(option), "{command}: {option}");
        }
    }
    for command in ["curvature", "einstein", "action"] {
        let said = text(&regge(&folder, &format!("{command} --help")).stdout);
        for (what, expected) in [
            ("dimensions", "dimension"),
            ("degrees", "up to 8"),
            ("functions", "atan2(a, b)"),
            ("functions", "max(a, b, ...)"),
            ("kinks", "kink"),
        ] {
            assert!(said.contains(expected), "{command}: {what}");
        }
    }
    let said = text(&regge(&folder, "--help").stdout);
    assert!(said.contains("cannot be read"), "what code 2 is: {said}");
    // One default where there is no table to be met.
    for command in ["converge", "curvature", "einstein", "action"] {
        let said = text(&regge(&folder, &format!("{command} --help")).stdout);
        assert!(said.contains("[default: canonical]"), "{command}: {said}");
    }
    let said = text(&regge(&folder, "reproduce --help").stdout);
    assert!(
        said.contains("[default: average-hierarchical, which the printed tables used"),
        "{said}"
    );
}

/// Files and numbers are the same whatever is said.
#[test]
fn quiet_says_nothing_and_verbose_says_what_is_done() {
    let folder = folder("words");
    write(&folder, "m.json", SQUARE);
    write(
        &folder,
        "g.toml",
        "dimension = 2\ngraph = \"abs(x - 0.2) + y^2\"\n",
    );
    write(
        &folder,
        "l.csv",
        "0,1,1\n1,2,1\n2,3,1\n0,3,1\n0,4,0.8\n1,4,0.8\n2,4,0.8\n3,4,0.8\n",
    );
    let metric = "--mesh m.json --metric g.toml --quadrature 4";
    for command in [
        format!("curvature {metric}"),
        "action --mesh m.json --lengths l.csv".into(),
    ] {
        let plain = regge(&folder, &command);
        assert!(plain.status.success(), "{}", text(&plain.stderr));
        for quiet in ["-q", "--quiet"] {
            let output = regge(&folder, &format!("{command} {quiet}"));
            assert!(
                output.status.success() && output.stdout.is_empty() && output.stderr.is_empty()
            );
        }
        let verbose = regge(&folder, &format!("-v {command}"));
        assert_eq!(verbose.stdout, plain.stdout);
        let said = text(&verbose.stderr);
        assert!(said.contains(" s  building the mesh\n"), "{said}");
        for threads in [1, 3] {
            let output = regge(&folder, &format!("{command} --threads {threads}"));
            assert_eq!(
                output.stdout, plain.stdout,
                "numbers do not depend on threads"
            );
        }
    }
    let noted = text(&regge(&folder, &format!("curvature {metric}")).stderr);
    assert!(noted.contains("note: the metric uses abs"), "{noted}");
    for (arguments, expected) in [
        ("converge --metric flat -q -v", "--verbose"),
        ("converge --metric flat --threads 0", "1..=1024"),
        (
            "curvature --mesh m.json --metric g.toml --memory-limit 1e-9",
            "memory",
        ),
    ] {
        let output = regge(&folder, arguments);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(
            said.contains(expected) && said.lines().count() == 1,
            "{said}"
        );
        assert!(!said.contains(" 0.0 "), "{said}");
    }
}

/// A bar is drawn on a terminal, and not where one cannot go back in a line.
#[cfg(target_os = "linux")]
#[test]
fn the_commands_for_files_have_a_bar() {
    let folder = folder("bar");
    write(&folder, "m.json", &grid(80));
    write(
        &folder,
        "g.toml",
        "dimension = 2\nconformal = \"1 + x^2/1e5\"\n",
    );
    let good = [("TERM", "xterm"), ("NO_COLOR", "1")];
    for (environment, drawn) in [(&good[..], true), (&[("TERM", "dumb")][..], false)] {
        let mut command = Command::new("script");
        let run = format!(
            "{} curvature --mesh m.json --metric g.toml --degree 3 --norm hm2",
            env!("CARGO_BIN_EXE_regge")
        );
        command
            .current_dir(&folder)
            .args(["-qec", &run, "/dev/null"]);
        command.envs(environment.iter().copied());
        let Ok(output) = command.output() else {
            return;
        };
        let said = text(&output.stdout);
        assert_eq!(said.contains("[>") || said.contains("[="), drawn, "{said}");
        // Colours would be ESC [ digits m.
        let colours = said.split("\x1b[").skip(1).any(|part| {
            part.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';')
                .starts_with('m')
        });
        assert!(!colours, "{said}");
    }
}

/// In a build for packages: completions name every command, and every command has its page.
#[cfg(feature = "shell")]
#[test]
fn shells_and_man_know_every_command() {
    let folder = folder("shell");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let output = regge(&folder, &format!("completions {shell}"));
        let said = text(&output.stdout);
        assert!(output.status.success() && output.stderr.is_empty());
        assert!(COMMANDS.iter().all(|name| said.contains(name)), "{shell}");
        assert!(said.contains("threads"), "{shell}");
    }
    assert!(regge(&folder, "man pages").status.success());
    for command in COMMANDS {
        let page = folder.join(format!("pages/regge-{command}.1"));
        let page = std::fs::read_to_string(page).expect("a page");
        assert!(
            page.contains("Example") && page.contains("memory\\-limit"),
            "{command}"
        );
    }
}

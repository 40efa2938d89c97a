//! Certificates without coqc: what is written is well-formed, the same each time, and what is forged states something else.

use regge_verify::certificates::{File, certificates};
use regge_verify::claims::{Catalogue, at_a_point};
use regge_verify::harness::Budget;
use std::collections::{BTreeMap, BTreeSet};

/// Of some claims; those that docs/verification/certificates.md must have.
const LABELS: [&str; 7] = ["P01", "P03", "P05", "P17", "I01", "I09", "I12"];

fn some() -> Catalogue {
    let mut all = at_a_point();
    all.retain(|c| LABELS.contains(&c.record.label));
    all
}

fn written() -> BTreeMap<String, String> {
    let files = certificates(&some(), &Budget::quick(1));
    files
        .into_iter()
        .map(|File { path, content }| (path, content))
        .collect()
}

/// The theorems of a file: name, statement, proof.
fn theorems(text: &str) -> Vec<[&str; 3]> {
    let all = text.split("Theorem ").skip(1);
    all.map(|theorem| {
        let (name, rest) = theorem.split_once(" :").expect("a name");
        let (statement, proof) = rest.split_once("\nProof.\n").expect("a proof");
        let proof = proof.split_once("Qed.\n").expect("an end").0;
        [name, statement, proof]
    })
    .collect()
}

/// Every name is a variable or was defined in a line before.
fn assert_defined(statement: &str) {
    let (quantified, body) = statement.split_once("R,").unwrap_or(("", statement));
    let mut known: BTreeSet<&str> = quantified.split_whitespace().collect();
    for line in body.lines() {
        let defined = line.strip_prefix("let ").and_then(|l| l.split_once(" := "));
        let (name, used) = defined.map_or((None, line), |(name, used)| (Some(name), used));
        let words = used.split(|c: char| !c.is_alphanumeric() && c != '_');
        let names = words.filter(|w| w.starts_with(char::is_alphabetic));
        for word in names.filter(|w| !["in", "IZR"].contains(w)) {
            assert!(known.contains(word), "{word} in {line}");
        }
        known.extend(name);
    }
}

#[test]
fn certificates_are_well_formed() {
    let files = written();
    let mut seen = 0;
    for (path, text) in files.iter().filter(|(path, _)| path.ends_with(".v")) {
        assert_eq!(
            text.matches('(').count(),
            text.matches(')').count(),
            "{path}"
        );
        let names: BTreeSet<&str> = theorems(text).iter().map(|[name, ..]| *name).collect();
        if path == "Straight.v" {
            continue;
        }
        assert_eq!(
            names.len(),
            theorems(text).len(),
            "{path}: names occur once"
        );
        for [name, statement, proof] in theorems(text) {
            let equation = statement.lines().last().expect("lines");
            let (left, right) = equation
                .trim_end_matches('.')
                .split_once(" = ")
                .expect("two sides");
            assert_ne!(left, right, "{path}: {name} says that something is itself");
            assert_defined(statement);
            assert!(
                proof.contains("by_field.") || proof.contains("agree left right"),
                "{name}"
            );
            // Nothing is taken for granted.
            assert!(
                !text.contains("Admitted") && !text.contains("Axiom"),
                "{path}"
            );
            seen += 1;
        }
    }
    assert!(seen > 40, "{seen} theorems");
}

#[test]
fn what_must_be_certified_is_there_and_has_a_forgery() {
    let files = written();
    for label in LABELS {
        for dimension in [2, 3] {
            let path = format!("{label}_{dimension}.v");
            let (text, forged) = (&files[&path], &files[&format!("forged/{path}")]);
            let forged = theorems(forged);
            assert_eq!(forged.len(), 1, "{path}");
            let states = |statement: &str| theorems(text).iter().any(|t| t[1] == statement);
            assert!(
                !states(forged[0][1]),
                "{path}: what is forged is stated as well"
            );
        }
    }
}

#[test]
fn certificates_are_the_same_each_time() {
    assert_eq!(written(), written());
}

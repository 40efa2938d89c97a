//! Every label of the paper has a home in the catalogue or a reason to have none.

use regge_verify::claims::records;
use std::collections::{BTreeMap, BTreeSet};

const LABELS: &str = include_str!("../../../docs/verification/labels.toml");
const KINDS: [&str; 8] = [
    "claim",
    "definition",
    "bound",
    "rate",
    "remark",
    "figure",
    "table",
    "section",
];

/// Of one label: its keys with their values, quotes and brackets taken off.
type Label = BTreeMap<String, Vec<String>>;

/// The file, which is simple TOML: a table for each label, one key a line.
fn labels() -> BTreeMap<String, Label> {
    let mut all = BTreeMap::new();
    let mut current = String::new();
    for line in LABELS
        .lines()
        .filter(|l| !l.is_empty() && !l.starts_with('#'))
    {
        if let Some(name) = line.strip_prefix("[\"").and_then(|l| l.strip_suffix("\"]")) {
            current = name.to_owned();
            let before = all.insert(current.clone(), Label::new());
            assert!(before.is_none(), "{name} is there twice");
            continue;
        }
        let (key, value) = line
            .split_once(" = ")
            .unwrap_or_else(|| panic!("not a key: {line}"));
        let values = value
            .split('"')
            .skip(1)
            .step_by(2)
            .map(str::to_owned)
            .collect();
        let label: &mut Label = all.get_mut(&current).expect("a key belongs to a label");
        label.insert(key.to_owned(), values);
    }
    all
}

/// The number of different labels in scalar-curvature.tex (one of them is there twice).
#[test]
fn no_label_is_missing() {
    assert_eq!(labels().len(), 88);
}

#[test]
fn every_label_has_a_kind_and_either_a_home_or_a_reason() {
    let rows: BTreeSet<&str> = records().iter().map(|r| r.label).collect();
    for (name, label) in labels() {
        let kind = label
            .get("kind")
            .and_then(|k| k.first())
            .unwrap_or_else(|| panic!("{name}: no kind"));
        assert!(KINDS.contains(&kind.as_str()), "{name}: {kind}");
        let (home, reason) = (label.get("home"), label.get("reason"));
        assert!(
            home.is_some() != reason.is_some(),
            "{name}: a home or a reason"
        );
        for row in home.into_iter().flatten() {
            assert!(
                rows.contains(row.as_str()),
                "{name}: the catalogue has no {row}"
            );
        }
        assert!(
            reason.is_none_or(|r| !r[0].is_empty()),
            "{name}: an empty reason"
        );
        assert!(
            kind != "claim" || home.is_some(),
            "{name} is a claim without a home"
        );
    }
}

#[test]
fn the_catalogue_cites_labels_that_exist() {
    let known = labels();
    for record in records() {
        for label in record.paper {
            assert!(known.contains_key(*label), "{} cites {label}", record.label);
        }
    }
}

//! Every label of the paper has a home in the catalogue or a reason to have none, and so has every statement.

use regge_verify::claims::records;
use regge_verify::paper::{Status, labels, statements};
use std::collections::BTreeMap;
use std::path::Path;

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

/// The claims that can be homes: what each cites of the paper.
fn rows() -> BTreeMap<&'static str, &'static [&'static str]> {
    let measured = regge_analysis::claims::ALL
        .iter()
        .map(|c| (c.label, c.paper));
    records()
        .iter()
        .map(|r| (r.label, r.paper))
        .chain(measured)
        .collect()
}

/// The number of different labels in scalar-curvature.tex (one of them is there twice).
#[test]
fn no_label_is_missing() {
    assert_eq!(labels().len(), 88);
}

#[test]
fn every_label_has_a_kind_and_either_a_home_or_a_reason() {
    for (name, label) in labels() {
        assert!(KINDS.contains(&&*label.kind), "{name}: {}", label.kind);
        let has_home = !label.home.is_empty();
        assert!(
            has_home != label.reason.is_some(),
            "{name}: a home or a reason"
        );
        assert!(
            label.reason != Some(String::new()),
            "{name}: an empty reason"
        );
        assert!(
            label.kind != "claim" || has_home,
            "{name} is a claim without a home"
        );
    }
}

/// Of what the paper asserts, at most five labels are nobody's business, and a referee must accept why.
#[test]
fn hardly_a_bound_rate_or_remark_is_without_a_home() {
    let asserted = ["claim", "bound", "rate", "remark"];
    let homeless = labels()
        .into_iter()
        .filter(|(_, label)| asserted.contains(&&*label.kind) && label.home.is_empty());
    let names: Vec<_> = homeless.map(|(name, _)| name).collect();
    assert!(names.len() <= 5, "{names:?}");
}

/// A home that does not speak of a label does not verify it. Sections are there as a whole.
#[test]
fn every_home_cites_its_label() {
    let rows = rows();
    for (name, label) in labels() {
        for home in &label.home {
            let paper = rows.get(&**home);
            let paper = paper.unwrap_or_else(|| panic!("{name}: there is no claim {home}"));
            assert!(
                label.kind == "section" || paper.contains(&&*name),
                "{home} is a home of {name} and does not mention it"
            );
        }
    }
}

#[test]
fn the_catalogue_cites_labels_that_exist() {
    let known = labels();
    for (row, paper) in rows() {
        for label in paper {
            assert!(known.contains_key(*label), "{row} cites {label}");
        }
    }
}

/// The claims and files that the statements name are there, and the numbers run from 1.
#[test]
fn every_statement_has_homes_and_files_that_exist() {
    let (rows, root) = (rows(), Path::new(env!("CARGO_MANIFEST_DIR")).join(".."));
    for (i, statement) in statements().iter().enumerate() {
        let number = statement.number;
        assert_eq!(number, i + 1);
        for home in &statement.homes {
            assert!(rows.contains_key(&**home), "{number}: no claim is {home}");
        }
        for file in &statement.seen_in {
            assert!(root.join(file).is_file(), "{number}: there is no {file}");
        }
        let verified = matches!(statement.status(), Status::Verified | Status::Nothing);
        assert!(
            !verified || statement.missing.is_empty(),
            "{number}: verified, and something is missing"
        );
    }
}

/// What the audit of 24 November 2026 found, by which the index measures what was done since.
#[test]
fn the_audit_is_kept() {
    let all = statements();
    let before = |status| all.iter().filter(|s| s.before == status).count();
    assert_eq!(Status::COMPUTED.map(before), [83, 15, 17, 56]);
}

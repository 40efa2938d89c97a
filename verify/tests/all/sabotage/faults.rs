//! Each number of `Formulas`, wrong: the claim that names the formula fails, and what does not use it goes on holding.

use super::{broken, complaints, report};
use regge_curvature::formulas::{Formulas, PAPER};
use regge_verify::claims::{catalogue, records};

/// A wrong number.
struct Fault {
    /// Which.
    field: &'static str,
    formulas: Formulas,
    /// A claim that fails, and what its page says of the formula.
    by: (&'static str, &'static str),
    /// Others that fail.
    broken: &'static [&'static str],
    /// Some that hold.
    sound: &'static [&'static str],
    /// N.
    dimension: usize,
}

/// `field: value, (claim, its words), [others that fail], [some that hold]`, when N = 3.
macro_rules! faults {
    ($($field:ident: $value:expr, $by:expr, $broken:expr, $sound:expr;)*) => {
        vec![$(Fault {
            field: stringify!($field),
            formulas: Formulas { $field: $value, ..PAPER },
            by: $by,
            broken: &$broken,
            sound: &$sound,
            dimension: 3,
        }),*]
    };
}

fn all() -> Vec<Fault> {
    faults! {}
}

/// The texts of a claim's page.
fn page(label: &str) -> String {
    let records = records();
    let record = records.iter().find(|r| r.label == label);
    let record = record.unwrap_or_else(|| panic!("no claim {label}"));
    let texts = [record.title, record.statement, record.sides];
    // Lines of a statement are broken anywhere.
    let all = texts.join(" ");
    all.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn every_fault_is_found_by_a_claim_that_names_it() {
    let mut wrong = Vec::new();
    for fault in all() {
        let (label, words) = fault.by;
        if !page(label).contains(words) {
            wrong.push(format!("{}: {label} does not say {words:?}", fault.field));
        }
        let failing = [&[label], fault.broken].concat();
        let only = [failing.as_slice(), fault.sound].concat();
        let found = report(catalogue(), fault.dimension, fault.formulas, &only);
        let of_fault = complaints(&broken(&found), &failing, fault.sound);
        wrong.extend(of_fault.iter().map(|c| format!("{}: {c}", fault.field)));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A new number of `Formulas` needs a fault here.
#[test]
fn there_is_a_fault_for_every_formula() {
    let faults: Vec<&str> = all().iter().map(|f| f.field).collect();
    let text = format!("{PAPER:?}");
    let fields: Vec<&str> = (text.split([' ', '{', ','].as_slice()))
        .filter_map(|word| word.strip_suffix(':'))
        .collect();
    assert_eq!(faults, fields);
    assert!(faults.len() >= 20);
}

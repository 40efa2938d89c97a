//! The claims that hold at a point.

use super::{broken, complaints, report};
use regge_curvature::formulas::{Formulas, PAPER};
use regge_verify::claims::at_a_point;

/// The labels that fail with these formulas.
fn failing(formulas: Formulas) -> Vec<String> {
    broken(&report(at_a_point(), 3, formulas, &[]))
}

/// All of these fail, and none of those.
fn finds(formulas: Formulas, failing_ones: &[&str], sound: &[&str]) {
    let wrong = complaints(&failing(formulas), failing_ones, sound);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn nothing_fails_unbroken() {
    assert!(report(at_a_point(), 3, PAPER, &[]).passed());
}

#[test]
fn a_wrong_sign_of_the_second_fundamental_form_is_found() {
    finds(
        Formulas {
            second_form: -1,
            ..PAPER
        },
        &["D03", "D04", "P10", "P13", "P14", "P18", "P20"],
        // What has no II in it goes on holding.
        &["P03", "P22"],
    );
}

#[test]
fn a_dihedral_angle_with_the_wrong_cosine_is_found() {
    let formulas = Formulas {
        dihedral_cos: -1,
        ..PAPER
    };
    assert_eq!(failing(formulas), ["D09", "I20", "P22", "P23", "P24"]);
}

#[test]
fn the_other_trace_reversal_is_found() {
    finds(
        Formulas {
            reverse_trace_halves: 1,
            ..PAPER
        },
        &["D02", "D13", "I09", "P03", "P15", "P17", "P20"],
        &["D03", "P10"],
    );
}

#[test]
fn the_second_form_in_the_place_of_its_trace_reversal_is_found() {
    let formulas = Formulas {
        trace_reversed: 0,
        ..PAPER
    };
    assert_eq!(failing(formulas), ["D07", "M11", "M19", "P19", "P20"]);
}

#[test]
fn the_message_names_the_claim_and_replays_it() {
    let formulas = Formulas {
        second_form: -1,
        ..PAPER
    };
    let report = report(at_a_point(), 3, formulas, &["P20"]);
    let failures = report.failures();
    let entry = failures.first().expect("P20 fails");
    assert!(
        entry
            .describe_failure()
            .starts_with("P20 (N = 3, AD) fails at case 0")
    );
    assert!(
        entry
            .replay(7)
            .ends_with("--only P20 --dimension 3 --seed 7")
    );
    let smallest = &entry.failure.as_ref().expect("a failure").instance;
    assert!(!smallest.is_empty(), "the instance that shows it is given");
}

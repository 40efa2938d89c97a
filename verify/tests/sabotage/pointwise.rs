//! The claims that hold at a point.

use crate::broken::{Broken, Fault, broken_claims, report};
use regge_verify::claims::{Catalogue, at_a_point};

fn claims(all: &mut Catalogue) {
    at_a_point::<Broken, 3>(all);
}

#[test]
fn nothing_fails_unbroken() {
    assert!(report(Fault::None, claims, &[]).passed());
}

#[test]
fn a_wrong_sign_of_the_second_fundamental_form_is_found() {
    let broken = broken_claims(Fault::SignOfII, claims, &[]);
    for label in ["D03", "D04", "P10", "P13", "P14", "P18", "P20"] {
        assert!(
            broken.iter().any(|l| l == label),
            "{label} holds, of {broken:?}"
        );
    }
    // What has no II in it goes on holding.
    assert!(
        !broken.iter().any(|l| l == "P03" || l == "P22"),
        "{broken:?}"
    );
}

#[test]
fn a_dihedral_angle_with_the_wrong_cosine_is_found() {
    assert_eq!(
        broken_claims(Fault::PlusG, claims, &[]),
        ["D09", "I20", "P22", "P23", "P24"]
    );
}

#[test]
fn the_other_trace_reversal_is_found() {
    let broken = broken_claims(Fault::HalfS, claims, &[]);
    for label in ["D02", "D13", "I09", "P03", "P15", "P17", "P20"] {
        assert!(
            broken.iter().any(|l| l == label),
            "{label} holds, of {broken:?}"
        );
    }
}

#[test]
fn the_second_form_in_the_place_of_its_trace_reversal_is_found() {
    assert_eq!(
        broken_claims(Fault::IIForIIBar, claims, &[]),
        ["D07", "M11", "M19", "P19", "P20"]
    );
}

#[test]
fn the_message_names_the_claim_and_replays_it() {
    let report = report(Fault::SignOfII, claims, &[]);
    let failures = report.failures();
    let entry = failures
        .iter()
        .find(|e| e.label == "P20")
        .expect("P20 fails");
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

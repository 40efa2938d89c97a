//! The claims on meshes.

use super::{broken, complaints, report};
use regge_curvature::formulas::{Formulas, PAPER};
use regge_verify::claims::on_meshes;

/// All of these fail, and none of those.
fn finds(formulas: Formulas, failing: &[&str], sound: &[&str]) {
    let only = [failing, sound].concat();
    let found = broken(&report(on_meshes(), 3, formulas, &only));
    let wrong = complaints(&found, failing, sound);
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn nothing_fails_unbroken() {
    assert_eq!(
        broken(&report(on_meshes(), 3, PAPER, &[])),
        Vec::<String>::new()
    );
}

#[test]
fn a_wrong_sign_of_the_second_fundamental_form_is_found() {
    finds(
        Formulas {
            second_form: -1,
            ..PAPER
        },
        &["D11", "M01", "M05", "M06", "M17", "T01"],
        // M16: −0 is 0.
        &["M02", "M14", "M16", "T03"],
    );
}

#[test]
fn a_dihedral_angle_with_the_wrong_cosine_is_found() {
    finds(
        Formulas {
            dihedral_cos: -1,
            ..PAPER
        },
        &["D10", "D11", "M02", "M03", "M05", "M12", "M14"],
        &["M01", "M04", "T04"],
    );
}

#[test]
fn the_other_trace_reversal_is_found() {
    finds(
        Formulas {
            reverse_trace_halves: 1,
            ..PAPER
        },
        &["M01", "M03", "M05", "M06"],
        &["M02", "M14"],
    );
}

#[test]
fn the_second_form_in_the_place_of_its_trace_reversal_is_found() {
    finds(
        Formulas {
            trace_reversed: 0,
            ..PAPER
        },
        &["M01", "M05", "M17", "M19"],
        &["M02", "M04"],
    );
}

#[test]
fn a_factor_dropped_from_the_hinge_sum_is_found() {
    finds(
        Formulas { hinges: 1, ..PAPER },
        &["D11", "M02", "M03", "M05", "M06", "M14"],
        &["M01", "M04", "M12"],
    );
}

#[test]
fn a_factor_dropped_from_the_face_sum_is_found() {
    finds(
        Formulas { faces: 1, ..PAPER },
        &["D11", "M01", "M05", "M06"],
        &["M02", "M04", "M14"],
    );
}

#[test]
fn a_form_b_h_without_the_boundary_is_found() {
    finds(
        Formulas {
            b_on_boundary: false,
            ..PAPER
        },
        &["M04", "M05", "T04", "M17"],
        &["M01", "M02", "M03"],
    );
}

#[test]
fn the_message_has_the_simplest_case_and_few_numbers() {
    let formulas = Formulas {
        second_form: -1,
        ..PAPER
    };
    let report = report(on_meshes(), 3, formulas, &["M05"]);
    let failures = report.failures();
    let m05 = |method: &str| {
        let mut entries = failures.iter();
        *entries
            .find(|e| e.label == "M05" && e.method == method)
            .expect("it fails")
    };
    for method in ["AD", "homotopy"] {
        let entry = m05(method);
        // There is no II where g is constant on cells.
        let failure = entry.failure.as_ref().expect("a failure");
        assert!(failure.detail.starts_with("Alfeld, r = 1"), "{failure:?}");
        // Of more than a hundred numbers (22 functions of two fields, 11 of v) most are not needed.
        assert!((1..60).contains(&failure.instance.len()), "{failure:?}");
        assert!(
            entry
                .replay(7)
                .ends_with("--only M05 --dimension 3 --seed 7")
        );
    }
}

//! Tried as a referee would: the library is broken so that a bound is false, mostly by a factor of two, and a verdict turns.
//!
//! The formulas are data (`Formulas`); what is measured is the code in use. Every claim here holds by the paper's formulas
//! (`a_quick_run_holds`), so that it is the broken one that turns the verdict.

use regge_analysis::{Effort, run};
use regge_curvature::formulas::{Formulas, PAPER};

/// The verdicts of a claim's findings by these formulas.
fn verdicts(label: &str, formulas: Formulas) -> Vec<(String, &'static str)> {
    let effort = Effort::new(20_261_128, true).with_formulas(formulas);
    let report = run(&effort, &[label.to_owned()], &|_, _| ()).expect("it can be measured");
    let findings = report.claims.iter().flat_map(|claim| &claim.findings);
    findings.map(|f| (f.case.clone(), f.verdict)).collect()
}

/// Some finding of the claim fails.
fn turns(label: &str, what: &str, formulas: Formulas) {
    let all = verdicts(label, formulas);
    assert!(
        all.iter().any(|(_, verdict)| *verdict == "fails"),
        "{label} does not see it: {what}: {all:?}"
    );
}

#[test]
fn the_constant_of_b_h() {
    let twice = Formulas {
        b_faces: -2,
        ..PAPER
    };
    turns("A01", "the faces of b_h twice", twice);
}

#[test]
fn a_lost_cell_term_of_b_h() {
    let lost = Formulas {
        b_cells: 0,
        ..PAPER
    };
    turns("A31", "no cells in b_h", lost);
    turns(
        "A31",
        "the faces of b_h twice",
        Formulas {
            b_faces: -2,
            ..PAPER
        },
    );
}

#[test]
fn the_orders_of_the_error() {
    turns("A20", "no jumps of H", Formulas { faces: 0, ..PAPER });
    turns(
        "A20",
        "angle defects twice",
        Formulas { hinges: 4, ..PAPER },
    );
}

#[test]
fn what_smooth_metrics_converge_to() {
    turns("A32", "jumps of H twice", Formulas { faces: 4, ..PAPER });
    turns(
        "A32",
        "half of the angle defects",
        Formulas { hinges: 1, ..PAPER },
    );
}

#[test]
fn the_linearised_einstein_tensor() {
    turns(
        "A33",
        "angle defects twice",
        Formulas {
            a_hinges: -2,
            ..PAPER
        },
    );
}

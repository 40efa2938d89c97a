//! Break one formula of the library, and the catalogue names the claims that it broke.
//!
//! The claims run through the library's own generic code with one method of [`Formulas`] overridden.

use regge::formulas::{Formulas, Paper};
use regge::hinge::Hinge;
use regge::hypersurface::Normal;
use regge::jet::Jet;
use regge::linalg::{Mat, Vector};
use regge::riemann::Connection;
use regge::scalar::{Algebraic, Field};
use regge_catalogue::claims::{Catalogue, pointwise};
use regge_catalogue::report::Report;
use regge_catalogue::{Options, run_catalogue};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU8, Ordering};

const NONE: u8 = 0;
const SIGN_OF_II: u8 = 1;
const PLUS_G: u8 = 2;
const HALF_S: u8 = 3;
const II_FOR_II_BAR: u8 = 4;

/// Which formula is wrong. One type for all of them: the catalogue is compiled once.
static FAULT: AtomicU8 = AtomicU8::new(NONE);
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

fn faulty(fault: u8) -> bool {
    FAULT.load(Ordering::Relaxed) == fault
}

struct Broken;

impl Formulas for Broken {
    fn second_form<J: Jet<N>, const N: usize>(
        connection: &Connection<J::Lower, N>,
        nu: &Vector<J, N>,
        normal: &Normal<J::Lower, N>,
    ) -> Mat<J::Lower, N> {
        let right = Paper::second_form(connection, nu, normal);
        if faulty(SIGN_OF_II) {
            right.map(|x| -x)
        } else {
            right
        }
    }

    fn dihedral<F: Algebraic, const N: usize>(hinge: &Hinge<F, N>) -> (F, F) {
        let (sin, cos) = Paper::dihedral(hinge);
        if faulty(PLUS_G) {
            (sin, -cos)
        } else {
            (sin, cos)
        }
    }

    fn trace_reversed<F: Field, const N: usize>(
        g: &Mat<F, N>,
        second_form: &Mat<F, N>,
        mean_curvature: F,
    ) -> Mat<F, N> {
        if faulty(II_FOR_II_BAR) {
            return *second_form;
        }
        Paper::trace_reversed(g, second_form, mean_curvature)
    }

    fn reverse_trace<F: Field, const N: usize>(
        g: &Mat<F, N>,
        inverse: &Mat<F, N>,
        sigma: &Mat<F, N>,
    ) -> Mat<F, N> {
        let right = Paper::reverse_trace(g, inverse, sigma);
        if faulty(HALF_S) {
            (right + sigma).map(|x| x * F::half())
        } else {
            right
        }
    }
}

/// The quick catalogue with this fault, in dimension 3, where nothing vanishes.
fn report(fault: u8) -> Report {
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(|e| e.into_inner());
    FAULT.store(fault, Ordering::Relaxed);
    let mut catalogue = Catalogue::new();
    pointwise::<Broken, 3>(&mut catalogue);
    let options = Options {
        quick: true,
        ..Options::default()
    };
    let report = run_catalogue(catalogue, &options, &|_| ());
    report.unwrap_or_else(|e| panic!("{e}"))
}

/// The claims that fail by both methods.
fn broken_claims(fault: u8) -> Vec<String> {
    let report = report(fault);
    let mut labels: Vec<String> = report.failures().iter().map(|e| e.label.clone()).collect();
    labels.dedup();
    labels
}

#[test]
fn nothing_fails_unbroken() {
    assert!(report(NONE).passed());
}

#[test]
fn a_wrong_sign_of_the_second_fundamental_form_is_found() {
    let broken = broken_claims(SIGN_OF_II);
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
    assert_eq!(broken_claims(PLUS_G), ["D09", "I20", "P22", "P23", "P24"]);
}

#[test]
fn the_other_trace_reversal_is_found() {
    let broken = broken_claims(HALF_S);
    for label in ["D02", "D13", "I09", "P03", "P15", "P17", "P20"] {
        assert!(
            broken.iter().any(|l| l == label),
            "{label} holds, of {broken:?}"
        );
    }
}

#[test]
fn the_second_form_in_the_place_of_its_trace_reversal_is_found() {
    assert_eq!(broken_claims(II_FOR_II_BAR), ["D07", "M11", "P19", "P20"]);
}

#[test]
fn the_message_names_the_claim_and_replays_it() {
    let report = report(SIGN_OF_II);
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

//! Break one formula of the library, and the catalogue's claims on meshes name what it broke.
//!
//! The claims run through the library's own generic code with one method of [`Formulas`] overridden.

use regge::formulas::{Formulas, Paper};
use regge::hinge::Hinge;
use regge::hypersurface::Normal;
use regge::jet::Jet;
use regge::linalg::{Mat, Vector};
use regge::riemann::Connection;
use regge::scalar::{Algebraic, Field};
use regge_catalogue::claims::{Catalogue, mesh};
use regge_catalogue::report::Verdict;
use regge_catalogue::{Options, run_catalogue};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU8, Ordering};

const NONE: u8 = 0;
const SIGN_OF_II: u8 = 1;
const PLUS_G: u8 = 2;
const HALF_S: u8 = 3;
const II_FOR_II_BAR: u8 = 4;
const ONE_HINGE: u8 = 5;
const ONE_FACE: u8 = 6;
const INTERIOR_FACES: u8 = 7;

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
    fn trace_reversed<F: Field, const N: usize>(g: &Mat<F, N>, ii: &Mat<F, N>, h: F) -> Mat<F, N> {
        if faulty(II_FOR_II_BAR) {
            *ii
        } else {
            Paper::trace_reversed(g, ii, h)
        }
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
    fn face_factor<F: Field>() -> F {
        F::from_int(if faulty(ONE_FACE) { 1 } else { 2 })
    }
    fn hinge_factor<F: Field>() -> F {
        F::from_int(if faulty(ONE_HINGE) { 1 } else { 2 })
    }
    fn face_in_b(interior: bool) -> bool {
        interior || !faulty(INTERIOR_FACES)
    }
}

/// The labels that fail with this fault, in dimension 3 (where nothing vanishes), by the quick catalogue.
fn broken_claims(fault: u8) -> Vec<String> {
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(|e| e.into_inner());
    FAULT.store(fault, Ordering::Relaxed);
    let mut catalogue = Catalogue::new();
    mesh::checks_in::<Broken, 3>(&mut catalogue);
    let options = Options {
        quick: true,
        dimension: Some(3),
        ..Options::default()
    };
    let report = run_catalogue(catalogue, &options, &|_| ()).unwrap_or_else(|e| panic!("{e}"));
    let failed = report.claims.iter().filter(|e| e.verdict == Verdict::Fail);
    failed.map(|e| e.label.clone()).collect()
}

/// All of these fail, and none of those.
fn finds(fault: u8, broken: &[&str], sound: &[&str]) {
    let found = broken_claims(fault);
    for label in broken {
        assert!(
            found.iter().any(|l| l == label),
            "{label} holds; broken: {found:?}"
        );
    }
    for label in sound {
        assert!(
            found.iter().all(|l| l != label),
            "{label} fails; broken: {found:?}"
        );
    }
}

#[test]
fn nothing_fails_unbroken() {
    assert_eq!(broken_claims(NONE), Vec::<String>::new());
}

#[test]
fn a_wrong_sign_of_the_second_fundamental_form_is_found() {
    finds(
        SIGN_OF_II,
        &["D11", "M01", "M05", "M06", "M17", "T01"],
        // M16: −0 is 0.
        &["M02", "M14", "M16", "T03"],
    );
}

#[test]
fn a_dihedral_angle_with_the_wrong_cosine_is_found() {
    finds(
        PLUS_G,
        &["D10", "D11", "M02", "M03", "M05", "M12", "M14"],
        &["M01", "M04", "T04"],
    );
}

#[test]
fn the_other_trace_reversal_is_found() {
    finds(
        HALF_S,
        &["M01", "M03", "M05", "M06"],
        &["M02", "M14", "D11"],
    );
}

#[test]
fn the_second_form_in_the_place_of_its_trace_reversal_is_found() {
    finds(
        II_FOR_II_BAR,
        &["M01", "M05", "M17", "M19"],
        &["M02", "D11", "M04"],
    );
}

#[test]
fn a_factor_dropped_from_the_hinge_sum_is_found() {
    finds(
        ONE_HINGE,
        &["D11", "M02", "M03", "M05", "M06", "M14"],
        &["M01", "M04", "M12"],
    );
}

#[test]
fn a_factor_dropped_from_the_face_sum_is_found() {
    finds(
        ONE_FACE,
        &["D11", "M01", "M05", "M06"],
        &["M02", "M04", "M14"],
    );
}

#[test]
fn a_form_b_h_without_the_boundary_is_found() {
    finds(
        INTERIOR_FACES,
        &["M04", "M05", "T04", "M17"],
        &["M01", "M02", "M03"],
    );
}

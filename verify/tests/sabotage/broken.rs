//! The formulas, one of them wrong.

use regge_curvature::formulas::{Formulas, Paper};
use regge_curvature::hinge::Hinge;
use regge_curvature::hypersurface::Normal;
use regge_curvature::jet::Jet;
use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::{Algebraic, Field};
use regge_verify::claims::Catalogue;
use regge_verify::report::Report;
use regge_verify::{Options, run_catalogue};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU8, Ordering};

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Fault {
    /// Nothing.
    None,
    /// −II.
    SignOfII,
    /// cos θ = +g(n⁺, n⁻).
    PlusG,
    /// 𝕊σ = σ − ½ g Tr σ.
    HalfS,
    /// II for II‾.
    IIForIIBar,
    /// Factor 1 before the sum over hinges.
    OneHinge,
    /// Factor 1 before the sum over faces.
    OneFace,
    /// b_h without the boundary.
    InteriorFaces,
}

/// Which formula is wrong. One type for all of them: the catalogue is compiled once.
static FAULT: AtomicU8 = AtomicU8::new(Fault::None as u8);
static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());

fn is(fault: Fault) -> bool {
    FAULT.load(Ordering::Relaxed) == fault as u8
}

/// The quick catalogue in dimension 3, where nothing vanishes, with this fault; of the claims that `fill` names, only
/// these, or all if there are none.
pub fn report(fault: Fault, fill: fn(&mut Catalogue), only: &[&str]) -> Report {
    let _guard = ONE_AT_A_TIME.lock().unwrap_or_else(|e| e.into_inner());
    FAULT.store(fault as u8, Ordering::Relaxed);
    let mut catalogue = Catalogue::new();
    fill(&mut catalogue);
    let options = Options {
        only: only.iter().map(|&label| label.to_owned()).collect(),
        quick: true,
        dimension: Some(3),
        ..Options::default()
    };
    run_catalogue(catalogue, &options, &|_| ()).unwrap_or_else(|e| panic!("{e}"))
}

/// The labels that fail, each once, in the order of the catalogue.
pub fn broken_claims(fault: Fault, fill: fn(&mut Catalogue), only: &[&str]) -> Vec<String> {
    let report = report(fault, fill, only);
    let mut labels: Vec<String> = report.failures().iter().map(|e| e.label.clone()).collect();
    labels.dedup();
    labels
}

pub struct Broken;

impl Formulas for Broken {
    fn second_form<J: Jet<N>, const N: usize>(
        connection: &Connection<J::Lower, N>,
        nu: &Vector<J, N>,
        normal: &Normal<J::Lower, N>,
    ) -> Mat<J::Lower, N> {
        let right = Paper::second_form(connection, nu, normal);
        if is(Fault::SignOfII) {
            right.map(|x| -x)
        } else {
            right
        }
    }

    fn dihedral<F: Algebraic, const N: usize>(hinge: &Hinge<F, N>) -> (F, F) {
        let (sin, cos) = Paper::dihedral(hinge);
        if is(Fault::PlusG) {
            (sin, -cos)
        } else {
            (sin, cos)
        }
    }

    fn trace_reversed<F: Field, const N: usize>(g: &Mat<F, N>, ii: &Mat<F, N>, h: F) -> Mat<F, N> {
        if is(Fault::IIForIIBar) {
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
        if is(Fault::HalfS) {
            (right + sigma).map(|x| x * F::half())
        } else {
            right
        }
    }

    fn face_factor<F: Field>() -> F {
        F::from_int(if is(Fault::OneFace) { 1 } else { 2 })
    }

    fn hinge_factor<F: Field>() -> F {
        F::from_int(if is(Fault::OneHinge) { 1 } else { 2 })
    }

    fn face_in_b(interior: bool) -> bool {
        interior || !is(Fault::InteriorFaces)
    }
}

//! Floor 4. The formulas of the paper that the functionals are made of, behind one trait.
//!
//! Production code uses [`Paper`], whose methods are the defaults. A sceptic overrides one method with something
//! wrong and sees which claims of the verification fail: the code that is tested is the code that is used.

use crate::hinge::Hinge;
use crate::hypersurface::{self, Normal};
use crate::jet::Jet;
use crate::linalg::{Mat, Vector};
use crate::riemann::Connection;
use crate::scalar::{Algebraic, Field};

/// The geometric formulas and constants of def:distcurv and thm:distcurvdot.
pub trait Formulas: Sync + 'static {
    /// II. See [`hypersurface::second_form`].
    #[inline]
    fn second_form<J: Jet<N>, const N: usize>(
        connection: &Connection<J::Lower, N>,
        nu: &Vector<J, N>,
        normal: &Normal<J::Lower, N>,
    ) -> Mat<J::Lower, N> {
        hypersurface::second_form(connection, nu, normal)
    }

    /// (sin θ, cos θ) of the dihedral angle, up to a positive factor. See [`Hinge::dihedral`].
    #[inline]
    fn dihedral<F: Algebraic, const N: usize>(hinge: &Hinge<F, N>) -> (F, F) {
        hinge.dihedral()
    }

    /// II‾. See [`hypersurface::trace_reversed`].
    #[inline]
    fn trace_reversed<F: Field, const N: usize>(
        g: &Mat<F, N>,
        second_form: &Mat<F, N>,
        mean_curvature: F,
    ) -> Mat<F, N> {
        hypersurface::trace_reversed(g, second_form, mean_curvature)
    }

    /// 𝕊σ. See [`crate::riemann::reverse_trace`].
    #[inline]
    fn reverse_trace<F: Field, const N: usize>(
        g: &Mat<F, N>,
        inverse: &Mat<F, N>,
        sigma: &Mat<F, N>,
    ) -> Mat<F, N> {
        crate::riemann::reverse_trace(g, inverse, sigma)
    }

    /// The factor of the face sum in def:distcurv.
    #[inline]
    fn face_factor<F: Field>() -> F {
        F::from_int(2)
    }

    /// The factor of the hinge sum in def:distcurv.
    #[inline]
    fn hinge_factor<F: Field>() -> F {
        F::from_int(2)
    }

    /// Does a face belong to the face sum of b_h? All do, those of the boundary too.
    #[inline]
    fn face_in_b(_interior: bool) -> bool {
        true
    }
}

/// The formulas as the paper has them (with the corrected conormal).
#[derive(Clone, Copy, Debug)]
pub struct Paper;

impl Formulas for Paper {}

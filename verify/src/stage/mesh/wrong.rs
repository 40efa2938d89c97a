//! Formulas that are wrong on purpose, for forgeries.

use regge_curvature::formulas::Formulas;
use regge_curvature::linalg::Mat;
use regge_curvature::riemann;
use regge_curvature::scalar::Field;

/// Wrong on purpose: b_h without the faces of the boundary.
pub struct InteriorFaces;

impl Formulas for InteriorFaces {
    fn face_in_b(interior: bool) -> bool {
        interior
    }
}

/// Wrong on purpose: II for II‾.
pub struct PlainSecondForm;

impl Formulas for PlainSecondForm {
    fn trace_reversed<F: Field, const N: usize>(
        _g: &Mat<F, N>,
        second_form: &Mat<F, N>,
        _h: F,
    ) -> Mat<F, N> {
        *second_form
    }
}

/// Wrong on purpose: 𝕊σ = σ − ½ g Tr σ.
pub struct HalfTrace;

impl Formulas for HalfTrace {
    fn reverse_trace<F: Field, const N: usize>(
        g: &Mat<F, N>,
        inverse: &Mat<F, N>,
        sigma: &Mat<F, N>,
    ) -> Mat<F, N> {
        let s = riemann::reverse_trace(g, inverse, sigma);
        s.zip_map(sigma, |s, x| (s + x) * F::half())
    }
}

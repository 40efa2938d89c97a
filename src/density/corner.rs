//! The corner of a cell at its hinge S, between two faces F_a and F_b: dihedral angle, conormals, trace on S, volume of S.
//!
//! The faces are given by their outward covectors ν_a = −dλ_a and ν_b = −dλ_b; all quantities follow from the three
//! products g^aa = ν_a·g⁻¹ν_a, g^ab, g^bb. The metric's derivatives do not enter.

use super::Volume;
use crate::formulas::{Formulas, times};
use crate::linalg::{Mat, Vector, apply, contract, form, vector};
use crate::riemann::trace;
use crate::scalar::{Algebraic, Field, Real};

/// Two faces of a cell and the metric at a point of their hinge.
#[derive(Clone, Copy, Debug)]
pub struct Corner<'c, F: Field, const N: usize> {
    formulas: &'c Formulas,
    inverse: &'c Mat<F, N>,
    det: F,
    /// g⁻¹ν_a and g⁻¹ν_b.
    pub raised: [Vector<F, N>; 2],
    /// g^aa, g^bb.
    pub squares: [F; 2],
    /// g^ab.
    pub product: F,
    /// g^aa g^bb − (g^ab)² > 0.
    pub gram: F,
}

impl<'c, F: Field, const N: usize> Corner<'c, F, N> {
    /// From g⁻¹ and det g at the point and the two outward covectors.
    #[inline]
    pub fn new(
        formulas: &'c Formulas,
        inverse: &'c Mat<F, N>,
        det: F,
        nu: [&Vector<F, N>; 2],
    ) -> Self {
        let raised = [apply(inverse, nu[0]), apply(inverse, nu[1])];
        let squares = [contract(nu[0], &raised[0]), contract(nu[1], &raised[1])];
        let product = contract(nu[0], &raised[1]);
        Self {
            formulas,
            inverse,
            det,
            raised,
            squares,
            product,
            gram: squares[0] * squares[1] - product * product,
        }
    }

    /// Tr(σ|_S) = Tr σ − [g^bb σ(ν_a,ν_a) − 2 g^ab σ(ν_a,ν_b) + g^aa σ(ν_b,ν_b)]/gram, the ν raised.
    #[inline]
    pub fn trace(&self, sigma: &Mat<F, N>) -> F {
        let [a, b] = &self.raised;
        let mixed = times(self.formulas.trace_on_s, self.product * form(sigma, a, b));
        let normal = self.squares[1] * form(sigma, a, a) + self.squares[0] * form(sigma, b, b);
        trace(self.inverse, sigma) - (normal - mixed - mixed) / self.gram
    }
}

impl<F: Algebraic, const N: usize> Corner<'_, F, N> {
    /// (sin θ, cos θ) of the dihedral angle θ_ST ∈ (0, π), times √(g^aa g^bb): cos θ = −g(n_a, n_b).
    ///
    /// Paper: section 3.
    #[inline]
    pub fn dihedral(&self) -> (F, F) {
        (
            times(self.formulas.dihedral_sin, Volume::from_det(self.gram)),
            times(self.formulas.dihedral_cos, -self.product),
        )
    }

    /// ω_S relative to the coordinate measure of {λ_a = λ_b = 0}: √(gram · det g). It is 1 when N = 2.
    #[inline]
    pub fn omega(&self) -> F {
        times(
            self.formulas.omega_s,
            Volume::from_det(self.gram * self.det),
        )
    }

    /// The outward unit normal of face 0 (a) or 1 (b).
    #[inline]
    pub fn normal(&self, face: usize) -> Vector<F, N> {
        let scale = F::one() / Volume::length(self.squares[face]);
        vector(|i| self.raised[face][i] * scale)
    }

    /// τ: the unit vector that points from S into face 0 (a) or 1 (b), orthogonal to S and to the face's normal.
    ///
    /// The outward conormal of the face along S is ν_F = −τ. Paper: lemma:angledefectdot prints τ where −τ
    /// belongs.
    #[inline]
    pub fn conormal(&self, face: usize) -> Vector<F, N> {
        let (own, other) = (self.squares[face], 1 - face);
        let slope = times(self.formulas.conormal_slope, self.product / own);
        let scale = times(
            self.formulas.conormal,
            F::one() / Volume::length(self.gram / own),
        );
        vector(|i| (slope * self.raised[face][i] - self.raised[other][i]) * scale)
    }
}

impl<F: Real, const N: usize> Corner<'_, F, N> {
    /// θ_ST in radians.
    #[inline]
    pub fn angle(&self) -> F {
        let (sin, cos) = self.dihedral();
        F::angle(sin, cos)
    }
}

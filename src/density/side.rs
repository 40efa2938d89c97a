//! A hypersurface F through a point, seen from one side: normal, second fundamental form, mean curvature, volume.
//!
//! F is given by a covector field ν that vanishes on tangent vectors: dφ for F = {φ = 0}, or −dλ_f for the face of a
//! cell opposite to its vertex f, which points out of the cell. Forms on F are kept as N×N arrays, of which only
//! the values on tangent vectors mean anything; traces and products over F use the tangential part
//! P^ij = g^ij − nⁱnʲ of the inverse metric. n → −n with ν → −ν.

use super::Volume;
use crate::formulas::{Formulas, times};
use crate::jet::{Jet, lower_vector};
use crate::linalg::{
    Mat, Vector, apply, contract, double_contract, form, matrix, symmetric, vector,
};
use crate::riemann::{Connection, inner};
use crate::scalar::{Algebraic, Field};

/// The unit normal of a hypersurface at a point, and the volume there: what g alone determines, without derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Normal<F: Field, const N: usize> {
    /// nⁱ, of g-length 1.
    pub n: Vector<F, N>,
    /// |ν| = √(g^ij ν_i ν_j).
    pub length: F,
    /// P^ij = g^ij − nⁱnʲ.
    pub tangential: Mat<F, N>,
    /// ω_F relative to the coordinate measure of {λ_f = 0}, for ν = ∓dλ_f: √(ν·g⁻¹ν det g).
    pub omega: F,
}

impl<F: Algebraic, const N: usize> Normal<F, N> {
    /// n = g⁻¹ν/√(ν·g⁻¹ν), from g⁻¹, det g and ν. Paper: eq. (normal).
    #[inline]
    pub fn new(formulas: &Formulas, inverse: &Mat<F, N>, det: F, nu: &Vector<F, N>) -> Self {
        let raised = apply(inverse, nu);
        let square = contract(nu, &raised);
        let length = times(formulas.normal_length, Volume::length(square));
        let scale = F::one() / length;
        let n = vector(|i| raised[i] * scale);
        let projected: Vector<F, N> = vector(|i| times(formulas.tangential, n[i]));
        Self {
            n,
            length,
            tangential: symmetric(|i, j| inverse[(i, j)] - projected[i] * n[j]),
            omega: times(formulas.omega_f, Volume::from_det(square * det)),
        }
    }
}

impl<F: Field, const N: usize> Normal<F, N> {
    /// Tr(σ|_F) = P^ij σ_ij.
    #[inline]
    pub fn trace(&self, sigma: &Mat<F, N>) -> F {
        double_contract(&self.tangential, sigma)
    }

    /// ⟨α, σ|_F⟩ over F.
    #[inline]
    pub fn inner(&self, alpha: &Mat<F, N>, sigma: &Mat<F, N>) -> F {
        inner(&self.tangential, alpha, sigma)
    }

    /// σ(n, n).
    #[inline]
    pub fn normal_normal(&self, sigma: &Mat<F, N>) -> F {
        form(sigma, &self.n, &self.n)
    }
}

/// A hypersurface at a point, seen from one side, with what the first derivatives of g and ν add.
#[derive(Clone, Copy, Debug)]
pub struct Side<'c, F: Field, const N: usize> {
    formulas: &'c Formulas,
    connection: &'c Connection<F, N>,
    /// n, P and ω_F.
    pub normal: Normal<F, N>,
    /// II(X, Y) = g(∇_X n, Y) = (∇_X ν)(Y)/|ν| for X, Y tangent to F; positive on a sphere with outward normal.
    ///
    /// Paper: section 2.2.
    pub second_form: Mat<F, N>,
    /// H = Tr II; (N−1)/ρ on the sphere of radius ρ.
    pub mean_curvature: F,
}

impl<'c, F: Algebraic, const N: usize> Side<'c, F, N> {
    /// From the connection of g's jets and the jets of ν.
    #[inline]
    pub fn new<J: Jet<N, Lower = F>>(
        formulas: &'c Formulas,
        connection: &'c Connection<F, N>,
        nu: &Vector<J, N>,
    ) -> Self {
        let normal = Normal::new(
            formulas,
            &connection.inverse,
            connection.det,
            &lower_vector(nu),
        );
        // The same quotient as in n: it is computed once.
        let scale = times(formulas.second_form, F::one() / normal.length);
        let mut second_form = connection.nabla_covector(nu);
        second_form.iter_mut().for_each(|x| *x *= scale);
        let mean_curvature = times(formulas.mean_curvature, normal.trace(&second_form));
        Self {
            formulas,
            connection,
            normal,
            second_form,
            mean_curvature,
        }
    }

    /// H ω_F. Paper: def:distcurv.
    #[inline]
    pub fn densitized_mean_curvature(&self) -> F {
        self.mean_curvature * self.normal.omega
    }

    /// II‾ = II − H g. Paper: prop:Homegadot.
    #[inline]
    pub fn trace_reversed(&self) -> Mat<F, N> {
        let h = times(self.formulas.trace_reversed, self.mean_curvature);
        matrix(|i, j| self.second_form[(i, j)] - h * self.connection.g[(i, j)])
    }

    /// 𝕊σ = σ − g Tr σ. Paper: prop:curvdot.
    #[inline]
    pub fn reverse_trace(&self, sigma: &Mat<F, N>) -> Mat<F, N> {
        self.connection.reverse_trace(self.formulas, sigma)
    }
}

/// div_F α = Σ (∇_τ α)(τ) = P^ij (∇_i α)_j; needs α along F only.
#[inline]
pub fn surface_div<J: Jet<N>, const N: usize>(
    connection: &Connection<J::Lower, N>,
    normal: &Normal<J::Lower, N>,
    alpha: &Vector<J, N>,
) -> J::Lower {
    double_contract(&normal.tangential, &connection.nabla_covector(alpha))
}

//! Floor 4. A hypersurface F through a point: normal, second fundamental form, surface divergence.
//!
//! F is given by a covector field ν that vanishes on tangent vectors: dφ for F = {φ = 0}, or −dλ_f for the face of a
//! cell opposite to its vertex f, which points out of the cell. Forms on F are kept as N×N arrays, of which only
//! the values on tangent vectors mean anything; traces and products over F use the tangential part
//! P^ij = g^ij − nⁱnʲ of the inverse metric. n → −n with ν → −ν.

use crate::jet::Jet;
use crate::linalg::{Mat, Vector, apply, contract, double_contract, matrix, symmetric, vector};
use crate::riemann::{Connection, inner};
use crate::scalar::{Algebraic, Field};

/// The unit normal of a hypersurface at a point.
#[derive(Clone, Copy, Debug)]
pub struct Normal<F: Field, const N: usize> {
    /// nⁱ, of g-length 1.
    pub n: Vector<F, N>,
    /// |ν| = √(g^ij ν_i ν_j).
    pub length: F,
    /// P^ij = g^ij − nⁱnʲ.
    pub tangential: Mat<F, N>,
}

impl<F: Algebraic, const N: usize> Normal<F, N> {
    /// n = g⁻¹ν/√(ν·g⁻¹ν). Paper: eq. (normal).
    #[inline]
    pub fn new(inverse: &Mat<F, N>, nu: &Vector<F, N>) -> Self {
        let raised = apply(inverse, nu);
        let length = contract(nu, &raised).sqrt();
        let scale = F::one() / length;
        let n = vector(|i| raised[i] * scale);
        Self {
            n,
            length,
            tangential: symmetric(|i, j| inverse[(i, j)] - n[i] * n[j]),
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
        crate::linalg::form(sigma, &self.n, &self.n)
    }
}

/// II(X, Y) = g(∇_X n, Y) = (∇_X ν)(Y)/|ν| for X, Y tangent to F; positive on a sphere with outward normal.
///
/// Paper: section 2.2.
#[inline]
pub fn second_form<J: Jet<N>, const N: usize>(
    connection: &Connection<J::Lower, N>,
    nu: &Vector<J, N>,
    normal: &Normal<J::Lower, N>,
) -> Mat<J::Lower, N> {
    let scale = J::Lower::one() / normal.length;
    let mut second_form = connection.nabla_covector(nu);
    second_form.iter_mut().for_each(|x| *x *= scale);
    second_form
}

/// H = Tr II; (N−1)/ρ on the sphere of radius ρ.
#[inline]
pub fn mean_curvature<F: Field, const N: usize>(
    normal: &Normal<F, N>,
    second_form: &Mat<F, N>,
) -> F {
    normal.trace(second_form)
}

/// II‾ = II − H g. Paper: prop:Homegadot.
#[inline]
pub fn trace_reversed<F: Field, const N: usize>(
    g: &Mat<F, N>,
    second_form: &Mat<F, N>,
    mean_curvature: F,
) -> Mat<F, N> {
    matrix(|i, j| second_form[(i, j)] - mean_curvature * g[(i, j)])
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

/// ω_F relative to the coordinate measure of {λ_f = 0}, for ν = ∓dλ_f: √(ν·g⁻¹ν det g).
#[inline]
pub fn omega_f<F: Algebraic, const N: usize>(
    connection: &Connection<F, N>,
    nu: &Vector<F, N>,
) -> F {
    let raised = apply(&connection.inverse, nu);
    (contract(nu, &raised) * connection.det).sqrt()
}

/// −dλ_f in reference coordinates, which points out of the cell across the face opposite to vertex f.
#[inline]
pub fn outward<F: Field, const N: usize>(opposite: usize) -> Vector<F, N> {
    vector(|i| match opposite {
        0 => F::one(),
        f if f == i + 1 => -F::one(),
        _ => F::zero(),
    })
}

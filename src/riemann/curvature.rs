//! The curvature at a point, with all indices lowered: no derivative of Γ or g⁻¹ is needed.

use super::Connection;
use crate::formulas::Formulas;
use crate::jet::Jet2;
use crate::linalg::{Mat, symmetric};
use crate::scalar::Field;

/// The curvature of g at a point, from its second-order jets.
#[derive(Clone, Copy, Debug)]
pub struct Curvature<'g, T: Field, const N: usize> {
    g: &'g Mat<Jet2<T, N>, N>,
    connection: &'g Connection<T, N>,
}

impl<'g, T: Field, const N: usize> Curvature<'g, T, N> {
    /// From jets of g and their connection.
    #[inline]
    pub fn new(g: &'g Mat<Jet2<T, N>, N>, connection: &'g Connection<T, N>) -> Self {
        Self { g, connection }
    }

    /// R_ijkl = ½ (∂_j∂_k g_il + ∂_i∂_l g_jk − ∂_i∂_k g_jl − ∂_j∂_l g_ik) + Γ_mjk Γ^m_il − Γ_mjl Γ^m_ik, which is
    /// g_ik g_jl − g_il g_jk on the unit sphere.
    #[inline]
    pub fn riemann(&self, [i, j, k, l]: [usize; 4]) -> T {
        let dd = |a: usize, b: usize, m: usize, n: usize| self.g[(a, b)].dd[m][n];
        let second = dd(i, l, j, k) + dd(j, k, i, l) - dd(j, l, i, k) - dd(i, k, j, l);
        let (low, up) = (&self.connection.lowered, &self.connection.gamma);
        let mut sum = second * T::half();
        for m in 0..N {
            sum.add_product(low[m][(j, k)], up[m][(i, l)]);
            sum.sub_product(low[m][(j, l)], up[m][(i, k)]);
        }
        sum
    }

    /// Ric_jl = g^ik R_ijkl; positive on a sphere.
    #[inline]
    pub fn ricci(&self) -> Mat<T, N> {
        symmetric(|j, l| {
            let mut sum = T::zero();
            for i in (0..N).filter(|&i| i != j) {
                for k in (0..N).filter(|&k| k != l) {
                    sum.add_product(self.connection.inverse[(i, k)], self.riemann([i, j, k, l]));
                }
            }
            sum
        })
    }

    /// R = g^jl Ric_jl = 2 Σ_{i<j, k<l} (g^ik g^jl − g^il g^jk) R_ijkl, by the symmetries of R_ijkl.
    #[inline]
    pub fn scalar(&self) -> T {
        let inverse = &self.connection.inverse;
        let term = |i: usize, j: usize, k: usize, l: usize| {
            let minor = inverse[(i, k)] * inverse[(j, l)] - inverse[(i, l)] * inverse[(j, k)];
            minor * self.riemann([i, j, k, l])
        };
        // R_ijkl = R_klij: of two different pairs, each order has the same.
        let (mut equal, mut different) = (T::zero(), T::zero());
        for j in 0..N {
            for i in 0..j {
                equal += term(i, j, i, j);
                for k in 0..i {
                    different += term(k, j, i, j);
                }
                for l in 0..j {
                    for k in 0..l {
                        different += term(k, l, i, j);
                    }
                }
            }
        }
        let once = equal + different + different;
        once + once
    }

    /// G = Ric − ½ R g.
    #[inline]
    pub fn einstein(&self, formulas: &Formulas) -> Mat<T, N> {
        let ricci = self.ricci();
        let half_r = self.connection.trace(&ricci) * T::ratio(formulas.einstein, 2);
        symmetric(|i, j| ricci[(i, j)] - half_r * self.connection.g[(i, j)])
    }
}

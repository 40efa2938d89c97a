//! Floor 3. Riemannian geometry at a point, from jets of the metric.
//!
//! A [`Connection`] made from second-order jets of g carries first-order jets of Γ, and with them the curvature;
//! made from first-order jets it carries Γ alone. Nothing here needs more than a field.

use crate::jet::{Jet, Jet1, Jet2, lower};
use crate::linalg::{Mat, Vector, double_contract, inverse_and_det, sandwich, symmetric};
use crate::scalar::Field;

/// g, g⁻¹, det g and the Levi-Civita connection at a point.
#[derive(Clone, Copy, Debug)]
pub struct Connection<F: Field, const N: usize> {
    /// g_ij.
    pub g: Mat<F, N>,
    /// g^ij.
    pub inverse: Mat<F, N>,
    /// det g in these coordinates.
    pub det: F,
    /// `gamma[k][(i, j)]` is Γ^k_ij, symmetric in i, j.
    pub gamma: [Mat<F, N>; N],
}

/// df: `[m]` is ∂_m f.
#[inline]
pub fn differential<J: Jet<N>, const N: usize>(f: &J) -> Vector<J::Lower, N> {
    Vector::from_fn(|m, _| f.d(m))
}

/// Tr σ = g^ij σ_ij.
#[inline]
pub fn trace<F: Field, const N: usize>(inverse: &Mat<F, N>, sigma: &Mat<F, N>) -> F {
    double_contract(inverse, sigma)
}

/// ⟨σ, ρ⟩ = g^ik g^jl σ_ij ρ_kl. With P^ij for g^ij: the inner product of the tangential parts.
#[inline]
pub fn inner<F: Field, const N: usize>(inverse: &Mat<F, N>, a: &Mat<F, N>, b: &Mat<F, N>) -> F {
    double_contract(&sandwich(inverse, a), b)
}

/// 𝕊σ = σ − g Tr σ. Paper: prop:curvdot.
#[inline]
pub fn reverse_trace<F: Field, const N: usize>(
    g: &Mat<F, N>,
    inverse: &Mat<F, N>,
    sigma: &Mat<F, N>,
) -> Mat<F, N> {
    let tr = trace(inverse, sigma);
    symmetric(|i, j| sigma[(i, j)] - g[(i, j)] * tr)
}

impl<F: Field, const N: usize> Connection<F, N> {
    /// From jets of g: Γ^k_ij = ½ g^kl (∂_i g_jl + ∂_j g_il − ∂_l g_ij).
    pub fn new<J: Jet<N, Lower = F>>(g: &Mat<J, N>) -> Self {
        let value = lower(g);
        let (inverse, det) = inverse_and_det(&value);
        let half = F::half();
        // Γ_lij, the first index lowered.
        let first: [Mat<F, N>; N] = std::array::from_fn(|l| {
            symmetric(|i, j| (g[(j, l)].d(i) + g[(i, l)].d(j) - g[(i, j)].d(l)) * half)
        });
        let gamma = std::array::from_fn(|k| {
            symmetric(|i, j| {
                let mut sum = F::zero();
                for l in 0..N {
                    sum += inverse[(k, l)] * first[l][(i, j)];
                }
                sum
            })
        });
        Self {
            g: value,
            inverse,
            det,
            gamma,
        }
    }

    /// Tr σ.
    pub fn trace(&self, sigma: &Mat<F, N>) -> F {
        trace(&self.inverse, sigma)
    }

    /// ⟨σ, ρ⟩.
    pub fn inner(&self, sigma: &Mat<F, N>, rho: &Mat<F, N>) -> F {
        inner(&self.inverse, sigma, rho)
    }

    /// 𝕊σ = σ − g Tr σ.
    pub fn reverse_trace(&self, sigma: &Mat<F, N>) -> Mat<F, N> {
        reverse_trace(&self.g, &self.inverse, sigma)
    }

    /// α^♯: the index of a one-form raised.
    pub fn sharp(&self, alpha: &Vector<F, N>) -> Vector<F, N> {
        crate::linalg::apply(&self.inverse, alpha)
    }

    /// `[(m, j)]` = (∇_m α)_j = ∂_m α_j − Γ^k_mj α_k.
    pub fn nabla_covector<J: Jet<N, Lower = F>>(&self, alpha: &Vector<J, N>) -> Mat<F, N> {
        Mat::from_fn(|m, j| {
            let mut value = alpha[j].d(m);
            for k in 0..N {
                value -= self.gamma[k][(m, j)] * alpha[k].lower();
            }
            value
        })
    }

    /// `[(m, k)]` = (∇_m X)^k = ∂_m X^k + Γ^k_mj X^j.
    pub fn nabla_vector<J: Jet<N, Lower = F>>(&self, x: &Vector<J, N>) -> Mat<F, N> {
        Mat::from_fn(|m, k| {
            let mut value = x[k].d(m);
            for j in 0..N {
                value += self.gamma[k][(m, j)] * x[j].lower();
            }
            value
        })
    }

    /// `[m][(i, j)]` = (∇_m σ)_ij = ∂_m σ_ij − Γ^k_mi σ_kj − Γ^k_mj σ_ik, symmetric in i, j.
    pub fn nabla_tensor<J: Jet<N, Lower = F>>(&self, sigma: &Mat<J, N>) -> [Mat<F, N>; N] {
        let value = lower(sigma);
        std::array::from_fn(|m| {
            symmetric(|i, j| {
                let mut sum = sigma[(i, j)].d(m);
                for k in 0..N {
                    sum -= self.gamma[k][(m, i)] * value[(k, j)];
                    sum -= self.gamma[k][(m, j)] * value[(i, k)];
                }
                sum
            })
        })
    }

    /// div α = g^mj (∇_m α)_j.
    pub fn div_covector<J: Jet<N, Lower = F>>(&self, alpha: &Vector<J, N>) -> F {
        double_contract(&self.inverse, &self.nabla_covector(alpha))
    }

    /// (div σ)_j = g^mi (∇_m σ)_ij.
    pub fn div_tensor<J: Jet<N, Lower = F>>(&self, sigma: &Mat<J, N>) -> Vector<F, N> {
        let nabla = self.nabla_tensor(sigma);
        Vector::from_fn(|j, _| {
            let mut sum = F::zero();
            for m in 0..N {
                for i in 0..N {
                    sum += self.inverse[(m, i)] * nabla[m][(i, j)];
                }
            }
            sum
        })
    }

    /// (∇∇v)_ij = ∂_i∂_j v − Γ^k_ij ∂_k v, from the jets of dv.
    pub fn hessian<J: Jet<N>>(&self, v: &J) -> Mat<F, N>
    where
        J::Lower: Jet<N, Lower = F>,
    {
        self.nabla_covector(&differential(v))
    }
}

impl<T: Field, const N: usize> Connection<Jet1<T, N>, N> {
    /// The same connection, its derivatives forgotten.
    pub fn lower(&self) -> Connection<T, N> {
        Connection {
            g: lower(&self.g),
            inverse: lower(&self.inverse),
            det: self.det.value,
            gamma: self.gamma.map(|g| lower(&g)),
        }
    }

    /// Ric_jk = ∂_l Γ^l_jk − ∂_j Γ^l_lk + Γ^l_lm Γ^m_jk − Γ^l_jm Γ^m_lk; positive on a sphere.
    pub fn ricci(&self) -> Mat<T, N> {
        let gamma = self.gamma.map(|g| lower(&g));
        // Γ^l_lk with its derivatives.
        let mut traced = [Jet1::<T, N>::constant(T::zero()); N];
        for k in 0..N {
            for l in 0..N {
                traced[k] += self.gamma[l][(l, k)];
            }
        }
        symmetric(|j, k| {
            let mut sum = -traced[k].d[j];
            for l in 0..N {
                sum += self.gamma[l][(j, k)].d[l] + traced[l].value * gamma[l][(j, k)];
                for m in 0..N {
                    sum -= gamma[l][(j, m)] * gamma[m][(l, k)];
                }
            }
            sum
        })
    }

    /// R = Tr Ric.
    pub fn scalar(&self) -> T {
        trace(&lower(&self.inverse), &self.ricci())
    }

    /// G = Ric − ½ R g.
    pub fn einstein(&self) -> Mat<T, N> {
        let ricci = self.ricci();
        let half_r = trace(&lower(&self.inverse), &ricci) * T::half();
        symmetric(|i, j| ricci[(i, j)] - half_r * self.g[(i, j)].value)
    }

    /// div div σ = g^jm ∇_m (div σ)_j.
    pub fn div_div(&self, sigma: &Mat<Jet2<T, N>, N>) -> T {
        self.lower().div_covector(&self.div_tensor(sigma))
    }

    /// Δf = div ∇f.
    pub fn laplacian(&self, f: &Jet2<T, N>) -> T {
        self.lower().div_covector(&differential(f))
    }
}

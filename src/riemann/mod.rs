//! Floor 3. Riemannian geometry at a point, from jets of the metric.
//!
//! A [`Connection`] made from second-order jets of g carries first-order jets of Γ; made from first-order jets it
//! carries Γ alone. [`Curvature`] needs no derivative of Γ or g⁻¹. Nothing here needs more than a field.

mod curvature;

pub use curvature::Curvature;

use crate::formulas::{Formulas, times};
use crate::jet::{Jet, Jet1, Jet2, lower, lower_vector};
use crate::linalg::{
    Mat, Vector, double_contract, fill_symmetric, inverse_and_det, matrix, sandwich, symmetric,
    vector, zeros,
};
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
    /// `lowered[k][(i, j)]` is Γ_kij = g_kl Γ^l_ij, symmetric in i, j.
    pub lowered: [Mat<F, N>; N],
    /// `gamma[k][(i, j)]` is Γ^k_ij, symmetric in i, j.
    pub gamma: [Mat<F, N>; N],
}

/// df: `[m]` is ∂_m f.
#[inline]
pub fn differential<J: Jet<N>, const N: usize>(f: &J) -> Vector<J::Lower, N> {
    vector(|m| f.d(m))
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
    formulas: &Formulas,
    g: &Mat<F, N>,
    inverse: &Mat<F, N>,
    sigma: &Mat<F, N>,
) -> Mat<F, N> {
    let half_tr = trace(inverse, sigma) * F::half();
    let tr = times(formulas.reverse_trace_halves, half_tr);
    symmetric(|i, j| sigma[(i, j)] - g[(i, j)] * tr)
}

impl<F: Field, const N: usize> Connection<F, N> {
    /// From jets of g: Γ_kij = ½ (∂_i g_jk + ∂_j g_ik − ∂_k g_ij), Γ^k_ij = g^kl Γ_lij.
    #[inline]
    pub fn new<J: Jet<N, Lower = F>>(g: &Mat<J, N>) -> Self {
        let value = lower(g);
        let (inverse, det) = inverse_and_det(&value);
        let mut connection = Self {
            g: value,
            inverse,
            det,
            lowered: [zeros(); N],
            gamma: [zeros(); N],
        };
        let half = F::half();
        for k in 0..N {
            fill_symmetric(&mut connection.lowered[k], |i, j| {
                (g[(j, k)].d(i) + g[(i, k)].d(j) - g[(i, j)].d(k)) * half
            });
        }
        for k in 0..N {
            fill_symmetric(&mut connection.gamma[k], |i, j| {
                let mut sum = inverse[(k, 0)] * connection.lowered[0][(i, j)];
                for l in 1..N {
                    sum.add_product(inverse[(k, l)], connection.lowered[l][(i, j)]);
                }
                sum
            });
        }
        connection
    }

    /// Tr σ.
    #[inline]
    pub fn trace(&self, sigma: &Mat<F, N>) -> F {
        trace(&self.inverse, sigma)
    }

    /// ⟨σ, ρ⟩.
    #[inline]
    pub fn inner(&self, sigma: &Mat<F, N>, rho: &Mat<F, N>) -> F {
        inner(&self.inverse, sigma, rho)
    }

    /// 𝕊σ = σ − g Tr σ.
    #[inline]
    pub fn reverse_trace(&self, formulas: &Formulas, sigma: &Mat<F, N>) -> Mat<F, N> {
        reverse_trace(formulas, &self.g, &self.inverse, sigma)
    }

    /// α^♯: the index of a one-form raised.
    #[inline]
    pub fn sharp(&self, alpha: &Vector<F, N>) -> Vector<F, N> {
        crate::linalg::apply(&self.inverse, alpha)
    }

    /// `[(m, j)]` = (∇_m α)_j = ∂_m α_j − Γ_kmj α^k.
    #[inline]
    pub fn nabla_covector<J: Jet<N, Lower = F>>(&self, alpha: &Vector<J, N>) -> Mat<F, N> {
        let raised = self.sharp(&lower_vector(alpha));
        let turned: Mat<F, N> = symmetric(|m, j| {
            let mut sum = self.lowered[0][(m, j)] * raised[0];
            for k in 1..N {
                sum.add_product(self.lowered[k][(m, j)], raised[k]);
            }
            sum
        });
        matrix(|m, j| alpha[j].d(m) - turned[(m, j)])
    }

    /// `[(m, k)]` = (∇_m X)^k = ∂_m X^k + Γ^k_mj X^j.
    #[inline]
    pub fn nabla_vector<J: Jet<N, Lower = F>>(&self, x: &Vector<J, N>) -> Mat<F, N> {
        matrix(|m, k| {
            let mut value = x[k].d(m);
            for j in 0..N {
                value.add_product(self.gamma[k][(m, j)], x[j].lower());
            }
            value
        })
    }

    /// `[m][(i, j)]` = (∇_m σ)_ij = ∂_m σ_ij − Γ^k_mi σ_kj − Γ^k_mj σ_ik, symmetric in i, j.
    #[inline]
    pub fn nabla_tensor<J: Jet<N, Lower = F>>(&self, sigma: &Mat<J, N>) -> [Mat<F, N>; N] {
        let (value, mut nabla) = (lower(sigma), [zeros(); N]);
        for m in 0..N {
            fill_symmetric(&mut nabla[m], |i, j| {
                let mut sum = sigma[(i, j)].d(m);
                for k in 0..N {
                    sum.sub_product(self.gamma[k][(m, i)], value[(k, j)]);
                    sum.sub_product(self.gamma[k][(m, j)], value[(i, k)]);
                }
                sum
            });
        }
        nabla
    }

    /// div α = g^mj (∇_m α)_j.
    #[inline]
    pub fn div_covector<J: Jet<N, Lower = F>>(&self, alpha: &Vector<J, N>) -> F {
        double_contract(&self.inverse, &self.nabla_covector(alpha))
    }

    /// (div σ)_j = g^mi (∇_m σ)_ij.
    #[inline]
    pub fn div_tensor<J: Jet<N, Lower = F>>(&self, sigma: &Mat<J, N>) -> Vector<F, N> {
        let nabla = self.nabla_tensor(sigma);
        vector(|j| {
            let mut sum = F::zero();
            for m in 0..N {
                for i in 0..N {
                    sum.add_product(self.inverse[(m, i)], nabla[m][(i, j)]);
                }
            }
            sum
        })
    }

    /// (∇∇v)_ij = ∂_i∂_j v − Γ^k_ij ∂_k v, from the jets of dv.
    #[inline]
    pub fn hessian<J: Jet<N>>(&self, v: &J) -> Mat<F, N>
    where
        J::Lower: Jet<N, Lower = F>,
    {
        self.nabla_covector(&differential(v))
    }
}

impl<T: Field, const N: usize> Connection<Jet1<T, N>, N> {
    /// The same connection, its derivatives forgotten.
    #[inline]
    pub fn lower(&self) -> Connection<T, N> {
        let mut connection = Connection {
            g: lower(&self.g),
            inverse: lower(&self.inverse),
            det: self.det.value,
            lowered: [zeros(); N],
            gamma: [zeros(); N],
        };
        for k in 0..N {
            connection.lowered[k] = lower(&self.lowered[k]);
            connection.gamma[k] = lower(&self.gamma[k]);
        }
        connection
    }

    /// The second-order jets of g that it was made from: ∂_m∂_n g_ij = ∂_n (Γ_imj + Γ_jmi).
    #[inline]
    fn metric(&self) -> Mat<Jet2<T, N>, N> {
        symmetric(|i, j| {
            let mut jet = Jet2::constant(self.g[(i, j)].value);
            jet.d = self.g[(i, j)].d;
            for m in 0..N {
                jet.dd[m] = (self.lowered[i][(m, j)] + self.lowered[j][(m, i)]).d;
            }
            jet
        })
    }

    /// [`Curvature::ricci`].
    #[inline]
    pub fn ricci(&self) -> Mat<T, N> {
        Curvature::new(&self.metric(), &self.lower()).ricci()
    }

    /// [`Curvature::scalar`].
    #[inline]
    pub fn scalar(&self) -> T {
        Curvature::new(&self.metric(), &self.lower()).scalar()
    }

    /// [`Curvature::einstein`].
    #[inline]
    pub fn einstein(&self, formulas: &Formulas) -> Mat<T, N> {
        Curvature::new(&self.metric(), &self.lower()).einstein(formulas)
    }

    /// div div σ = g^jm ∇_m (div σ)_j.
    #[inline]
    pub fn div_div(&self, sigma: &Mat<Jet2<T, N>, N>) -> T {
        self.lower().div_covector(&self.div_tensor(sigma))
    }

    /// Δf = div ∇f.
    #[inline]
    pub fn laplacian(&self, f: &Jet2<T, N>) -> T {
        self.lower().div_covector(&differential(f))
    }
}

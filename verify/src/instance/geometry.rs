//! What several claims compute in the same way from the library's kernels.

use super::Instance;
use crate::claim::{Ground, Timed};
use regge::formulas::Formulas;
use regge::hypersurface::{Normal, mean_curvature};
use regge::jet::Jet1;
use regge::linalg::{Mat, Vector, apply, form};
use regge::riemann::Connection;
use regge::scalar::Algebraic;

/// A hypersurface through the point: n, II, H and ω_F.
#[derive(Clone, Debug)]
pub struct Face<F: Algebraic, const N: usize> {
    /// n, |ν| and the tangential part of g⁻¹.
    pub normal: Normal<F, N>,
    /// II.
    pub second_form: Mat<F, N>,
    /// H.
    pub h: F,
    /// ω_F relative to the coordinate measure, up to a constant.
    pub omega: F,
}

impl<F: Algebraic, const N: usize> Face<F, N> {
    /// By the formulas K.
    #[inline(never)]
    pub fn new<K: Formulas>(connection: &Connection<F, N>, nu: &Vector<Jet1<F, N>, N>) -> Self {
        let normal = Normal::new(&connection.inverse, &nu.map(|x| x.value));
        let second_form = K::second_form(connection, nu, &normal);
        let h = mean_curvature(&normal, &second_form);
        Self {
            normal,
            second_form,
            h,
            omega: normal.length * connection.det.sqrt(),
        }
    }

    /// II‾.
    pub fn trace_reversed<K: Formulas>(&self, connection: &Connection<F, N>) -> Mat<F, N> {
        K::trace_reversed(&connection.g, &self.second_form, self.h)
    }
}

/// H ω_F of the hypersurface with covector ν in the metric g + t σ.
pub fn mean_curvature_density<K: Formulas, S: Timed, const N: usize>(
    i: &Instance<S, N>,
    nu: &Vector<Jet1<S::Base, N>, N>,
) -> S {
    let face = Face::<S, N>::new::<K>(&i.moving0(), &nu.map(super::still_jet::<S, N>));
    face.h * face.omega
}

/// 𝕊σ with first derivatives.
pub fn reversed<K: Formulas, B: Ground, const N: usize>(
    still: &Connection<Jet1<B, N>, N>,
    sigma: &Mat<Jet1<B, N>, N>,
) -> Mat<Jet1<B, N>, N> {
    K::reverse_trace(&still.g, &still.inverse, sigma)
}

/// div_F(σ(n,·)) with the normal n of the level sets of φ.
pub fn divergence_terms<B: Ground, const N: usize>(
    still: &Connection<Jet1<B, N>, N>,
    nu: &Vector<Jet1<B, N>, N>,
    sigma: &Mat<Jet1<B, N>, N>,
) -> B {
    let around = Normal::new(&still.inverse, nu);
    let flux = apply(sigma, &around.n);
    let normal = Normal::new(&still.inverse.map(|x| x.value), &nu.map(|x| x.value));
    regge::hypersurface::surface_div(&still.lower(), &normal, &flux)
}

/// The g-orthonormal frame of n^⊥ made of the seeds.
pub fn gram_schmidt<F: Algebraic, const N: usize>(
    g: &Mat<F, N>,
    n: &Vector<F, N>,
    seeds: &[Vector<F, N>],
) -> Vec<Vector<F, N>> {
    let mut frame = vec![*n];
    for seed in seeds {
        let mut tau = *seed;
        for e in &frame {
            let along = form(g, e, seed);
            tau = Vector::from_fn(|k, _| tau[k] - along * e[k]);
        }
        let scale = F::one() / form(g, &tau, &tau).sqrt();
        frame.push(tau.map(|x| x * scale));
    }
    frame.remove(0);
    frame
}

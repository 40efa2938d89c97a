//! Orthonormal frames along the level sets of φ.

use super::instance::{Instance, still_jet};
use crate::harness::{Timed, each};
use regge_curvature::jet::Jet1;
use regge_curvature::linalg::{Mat, Vector, form};
use regge_curvature::scalar::Algebraic;

/// n, τ_1…τ_{N−1}: orthonormal at all times, as fields around the point.
#[derive(Clone, Debug)]
pub struct Frame<S: Timed, const N: usize> {
    /// The unit normal of the level sets.
    pub n: Vector<Jet1<S, N>, N>,
    /// An orthonormal frame of their tangent spaces.
    pub tau: Vec<Vector<Jet1<S, N>, N>>,
}

impl<S: Timed, const N: usize> Frame<S, N> {
    /// n at this time, with x-derivatives.
    pub fn n1(&self) -> Vector<Jet1<S::Base, N>, N> {
        self.n.map(|x| x.map(S::value))
    }

    /// n at this time and point.
    pub fn n0(&self) -> Vector<S::Base, N> {
        self.n.map(|x| x.value.value())
    }

    /// The τ_i at this time, with x-derivatives.
    pub fn tau1(&self) -> Vec<Vector<Jet1<S::Base, N>, N>> {
        each(&self.tau, |t| t.map(|x| x.map(S::value)))
    }

    /// The τ_i at this time and point.
    pub fn tau0(&self) -> Vec<Vector<S::Base, N>> {
        each(&self.tau, |t| t.map(|x| x.value.value()))
    }

    /// τ̇_i at the point.
    pub fn tau_rate(&self) -> Vec<Vector<S::Base, N>> {
        each(&self.tau, |t| t.map(|x| x.value.rate()))
    }
}

impl<S: Timed, const N: usize> Instance<S, N> {
    /// The g(t)-orthonormal frame of the tangent spaces of the level sets of φ that Gram and Schmidt make of
    /// the seeds; it turns and stretches in space and time.
    #[inline(never)]
    pub fn frame(&self) -> Frame<S, N> {
        let moving = self.moving();
        let nu = self.nu().map(still_jet::<S, N>);
        let normal = self.normal(&moving, &nu);
        let mut vectors = vec![normal.n];
        vectors.extend(self.seeds.iter().copied());
        let tau = orthonormal(&moving.g, &vectors).split_off(1);
        Frame { n: normal.n, tau }
    }
}

/// The g-orthonormal vectors that Gram and Schmidt make of these.
pub fn orthonormal<F: Algebraic, const N: usize>(
    g: &Mat<F, N>,
    vectors: &[Vector<F, N>],
) -> Vec<Vector<F, N>> {
    let mut frame: Vec<Vector<F, N>> = Vec::new();
    for seed in vectors {
        let mut tau = *seed;
        for e in &frame {
            let along = form(g, e, seed);
            tau = Vector::from_fn(|k, _| tau[k] - along * e[k]);
        }
        let scale = F::one() / form(g, &tau, &tau).sqrt();
        frame.push(tau.map(|x| x * scale));
    }
    frame
}

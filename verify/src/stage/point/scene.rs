//! What several claims compute in the same way from the library's kernels.

use super::instance::{Instance, still_jet};
use crate::harness::{Ground, Timed};
use regge_curvature::density::{Normal, Side, surface_div};
use regge_curvature::formulas::Formulas;
use regge_curvature::jet::Jet1;
use regge_curvature::linalg::{Mat, Vector, apply, contract, form};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::Algebraic;

/// A hypersurface through the point: n, II, H, II‾ and ω_F, as the library's [`Side`] has them.
#[derive(Clone, Debug)]
pub struct Face<F: Algebraic, const N: usize> {
    /// n, |ν|, the tangential part of g⁻¹, and ω_F relative to the coordinate measure, up to a constant.
    pub normal: Normal<F, N>,
    /// II.
    pub second_form: Mat<F, N>,
    /// H.
    pub h: F,
    /// II‾.
    pub trace_reversed: Mat<F, N>,
    /// H ω_F.
    pub density: F,
}

impl<F: Algebraic, const N: usize> Face<F, N> {
    /// From the connection of g and the jets of ν.
    #[inline(never)]
    pub fn new(
        formulas: &Formulas,
        connection: &Connection<F, N>,
        nu: &Vector<Jet1<F, N>, N>,
    ) -> Self {
        let side = Side::new(formulas, connection, nu);
        Self {
            normal: side.normal,
            second_form: side.second_form,
            h: side.mean_curvature,
            trace_reversed: side.trace_reversed(),
            density: side.densitized_mean_curvature(),
        }
    }
}

/// H ω_F of the hypersurface with covector ν in the metric g + t σ.
pub fn mean_curvature_density<S: Timed, const N: usize>(
    i: &Instance<S, N>,
    nu: &Vector<Jet1<S::Base, N>, N>,
) -> S {
    Face::<S, N>::new(&i.formulas, &i.moving0(), &nu.map(still_jet::<S, N>)).density
}

/// div_F(σ(n,·)) with the normal n of the level sets of φ.
pub fn divergence_terms<B: Ground, const N: usize>(
    formulas: &Formulas,
    still: &Connection<Jet1<B, N>, N>,
    nu: &Vector<Jet1<B, N>, N>,
    sigma: &Mat<Jet1<B, N>, N>,
) -> B {
    let around = Normal::new(formulas, &still.inverse, still.det, nu);
    let (at, flux) = (still.lower(), apply(sigma, &around.n));
    let normal = Normal::new(formulas, &at.inverse, at.det, &nu.map(|x| x.value));
    surface_div(&at, &normal, &flux)
}

/// What the claims on hypersurfaces need at this time: the face F = {φ = 0} and the derivatives of σ.
#[derive(Clone, Debug)]
pub struct Scene<B: Ground, const N: usize> {
    /// The connection, with its derivatives.
    pub still: Connection<Jet1<B, N>, N>,
    /// The connection.
    pub base: Connection<B, N>,
    /// n, II, H, ω_F.
    pub face: Face<B, N>,
    /// σ with first derivatives.
    pub sigma1: Mat<Jet1<B, N>, N>,
    /// σ.
    pub sigma: Mat<B, N>,
    /// `[m]` is ∇_m σ.
    pub nabla: [Mat<B, N>; N],
    /// (div 𝕊σ)(n).
    pub div_s_n: B,
    /// div_F(σ(n,·)).
    pub div_f: B,
    /// σ(n, n).
    pub s_nn: B,
    /// ⟨II, σ|_F⟩.
    pub ii_sigma: B,
}

impl<B: Ground, const N: usize> Scene<B, N> {
    /// On the hypersurface with covector ν.
    #[inline(never)]
    pub fn new<S: Timed<Base = B>>(i: &Instance<S, N>, nu: &Vector<Jet1<B, N>, N>) -> Self {
        let still = i.still();
        let base = still.lower();
        let face = Face::new(&i.formulas, &base, nu);
        let (sigma1, sigma) = (i.sigma1(), i.sigma0());
        let div_s = base.div_tensor(&still.reverse_trace(&i.formulas, &sigma1));
        Self {
            div_s_n: contract(&div_s, &face.normal.n),
            div_f: divergence_terms(&i.formulas, &still, nu, &sigma1),
            s_nn: face.normal.normal_normal(&sigma),
            ii_sigma: face.normal.inner(&face.second_form, &sigma),
            nabla: base.nabla_tensor(&sigma1),
            still,
            base,
            face,
            sigma1,
            sigma,
        }
    }

    /// (∇_x σ)(y, z).
    pub fn nabla_sigma(&self, x: &Vector<B, N>, y: &Vector<B, N>, z: &Vector<B, N>) -> B {
        let mut sum = B::zero();
        for m in 0..N {
            sum += x[m] * form(&self.nabla[m], y, z);
        }
        sum
    }

    /// (div σ)(n), which is not (div 𝕊σ)(n).
    pub fn div_n(&self) -> B {
        contract(&self.base.div_tensor(&self.sigma1), &self.face.normal.n)
    }

    /// (div(σ − ½ g Tr σ))(n): another convention of the trace reversal.
    pub fn div_half_n(&self) -> B {
        (self.div_s_n + self.div_n()) * B::half()
    }
}

impl<S: Timed, const N: usize> Instance<S, N> {
    /// The face F = {φ = 0} and what is on it.
    pub fn scene(&self) -> Scene<S::Base, N> {
        Scene::new::<S>(self, &self.nu())
    }

    /// H of F = {φ = 0} in the metric g + t σ.
    #[inline(never)]
    pub fn moving_h(&self) -> S {
        Face::new(
            &self.formulas,
            &self.moving0(),
            &self.nu().map(still_jet::<S, N>),
        )
        .h
    }
}

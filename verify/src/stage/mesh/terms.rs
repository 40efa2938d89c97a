//! The densities of the variation at one point of a cell: what the three right sides of the paper's section 3.1 are
//! made of, from covariant derivatives of σ.

use crate::harness::{each, others};
use crate::stage::point::{Face, divergence_terms};
use regge_curvature::density::{Corner, omega, outward};
use regge_curvature::formulas::Formulas;
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, contract, form, inverse_and_det};
use regge_curvature::riemann::{Connection, reverse_trace};
use regge_curvature::scalar::Real;
use regge_curvature::simplex::subsets;

/// (div div 𝕊σ) ω.
pub fn div_div<const N: usize>(
    formulas: &Formulas,
    g: &Mat<Jet2<f64, N>, N>,
    sigma: &Mat<Jet2<f64, N>, N>,
) -> f64 {
    let s_sigma = reverse_trace(formulas, g, &inverse_and_det(g).0, sigma);
    let connection = Connection::new(g);
    connection.div_div(&s_sigma) * omega(formulas, connection.det.value)
}

/// The vertices that a k-simplex of a cell at this place lacks: one for a face, two for a hinge.
pub fn opposite<const N: usize>(k: usize, place: usize) -> Vec<usize> {
    others(N + 1, &subsets(N + 1, k + 1)[place])
}

/// The outward covector −dλ of the face at this place.
pub fn outward_of_face<T: Real, const N: usize>(place: usize) -> Vector<T, N> {
    outward(opposite::<N>(N - 1, place)[0])
}

/// What prop:Homegadot needs at a point of a face, times ω_F.
#[derive(Clone, Copy, Debug)]
pub struct FaceTerms {
    /// ⟨II‾, σ|_F⟩.
    pub second_form: f64,
    /// ⟨II, σ|_F⟩.
    pub plain_second_form: f64,
    /// (div 𝕊σ)(n).
    pub div_s: f64,
    /// (div σ)(n).
    pub div: f64,
    /// div_F(σ(n,·)).
    pub div_f: f64,
    /// H σ(n,n).
    pub h_nn: f64,
    /// 𝕊σ(n,n).
    pub s_nn: f64,
    /// σ(n,n).
    pub nn: f64,
    /// Tr(σ|_F).
    pub trace: f64,
    /// ω_F itself.
    pub omega: f64,
}

impl FaceTerms {
    /// On the face at this place of the cell.
    pub fn new<const N: usize>(
        formulas: &Formulas,
        g: &Mat<Jet2<f64, N>, N>,
        sigma: &Mat<Jet1<f64, N>, N>,
        place: usize,
    ) -> Self {
        let around = Connection::new(g);
        let at = around.lower();
        let nu = outward_of_face::<f64, N>(place).map(Jet1::constant);
        let face = Face::new(formulas, &at, &nu);
        let s_sigma = around.reverse_trace(formulas, sigma);
        let (value, n, omega) = (sigma.map(|x| x.value), &face.normal.n, face.normal.omega);
        let s_value = s_sigma.map(|x| x.value);
        Self {
            second_form: face.normal.inner(&face.trace_reversed, &value) * omega,
            plain_second_form: face.normal.inner(&face.second_form, &value) * omega,
            div_s: contract(&at.div_tensor(&s_sigma), n) * omega,
            div: contract(&at.div_tensor(sigma), n) * omega,
            div_f: divergence_terms(formulas, &around, &nu, sigma) * omega,
            h_nn: face.h * form(&value, n, n) * omega,
            s_nn: form(&s_value, n, n) * omega,
            nn: form(&value, n, n) * omega,
            trace: face.normal.trace(&value) * omega,
            omega,
        }
    }

    /// (div 𝕊σ)(n) + div_F(σ(n,·)) − Hσ(n,n).
    pub fn flux(&self) -> f64 {
        self.div_s + self.div_f - self.h_nn
    }
}

/// What lemma:angledefectdot needs at a point of a hinge, from one cell.
#[derive(Clone, Copy, Debug)]
pub struct HingeTerms<T> {
    /// θ.
    pub theta: T,
    /// σ(n, τ) ω_S with τ pointing into the face, summed over the two faces of the cell.
    pub normal_conormal: T,
    /// Tr(σ|_S).
    pub trace: T,
    /// ω_S.
    pub omega: T,
}

impl<T: Real> HingeTerms<T> {
    /// On the hinge at this place of the cell.
    pub fn new<const N: usize>(
        formulas: &Formulas,
        g: &Mat<T, N>,
        sigma: &Mat<T, N>,
        place: usize,
    ) -> Self {
        let (inverse, det) = inverse_and_det(g);
        let nu: Vec<Vector<T, N>> = each(&opposite::<N>(N - 2, place), |&v| outward(v));
        let corner = Corner::new(formulas, &inverse, det, [&nu[0], &nu[1]]);
        let omega = corner.omega();
        let side = |f: usize| form(sigma, &corner.normal(f), &corner.conormal(f));
        Self {
            theta: corner.angle(),
            normal_conormal: (side(0) + side(1)) * omega,
            trace: corner.trace(sigma),
            omega,
        }
    }
}

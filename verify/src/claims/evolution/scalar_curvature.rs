//! P01, P03: how the scalar curvature changes.

use crate::harness::{Equation, Record, Timed};
use crate::stage::point::{Instance, Pointwise};
use regge_curvature::density::Inside;
use regge_curvature::formulas::PAPER;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, inverse_and_det, symmetric};
use regge_curvature::riemann::{reverse_trace, trace};
use regge_curvature::scalar::Field;

/// Ṙ.
pub struct P01;

impl Pointwise for P01 {
    const RECORD: Record = Record {
        label: "P01",
        paper: &["prop:curvdot"],
        title: "The rate of change of the scalar curvature",
        statement: r"\dot R = \operatorname{div}\operatorname{div}\sigma - \Delta\operatorname{Tr}\sigma
            - \langle\operatorname{Ric},\sigma\rangle",
        sides: "Left: R(g + tσ) from the lowered curvature tensor R_ijkl, whose second derivatives of g stand for \
            themselves, differentiated in t. Right: covariant derivatives of σ, and Ric at t = 0. Both use R_ijkl, the \
            left its change and the right its value, which O03 pins down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let still = i.still();
        let inverse = inverse_and_det(&i.g).0;
        let ricci = still.lower().inner(&still.ricci(), &i.sigma0());
        vec![
            Equation::new("Ṙ")
                .left("Ṙ", i.moving().scalar().rate())
                .right("div div σ", still.div_div(&i.sigma))
                .right("−Δ Tr σ", -still.laplacian(&trace(&inverse, &i.sigma)))
                .right("−⟨Ric,σ⟩", -ricci),
        ]
    }
}

/// ∂_t(Rω).
pub struct P03;

impl Pointwise for P03 {
    const RECORD: Record = Record {
        label: "P03",
        paper: &["prop:curvdot", "curvdotintro", "intcurvdot"],
        title: "The rate of change of the densitized scalar curvature",
        statement: r"\frac{\partial}{\partial t}(R\omega) = (\operatorname{div}\operatorname{div}\mathbb{S}\sigma)\,\omega
            - \langle G,\sigma\rangle\,\omega, \qquad \mathbb{S}\sigma = \sigma - g\operatorname{Tr}\sigma",
        sides: "Left: the density Rω of g + tσ that the functionals integrate, differentiated in t. Right: covariant \
            derivatives of 𝕊σ, and Gω at t = 0. Both use R, the left its change and the right its value, which O03 pins down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (moving, still) = (i.moving0(), i.still());
        let base = still.lower();
        let density = Inside::new(&i.formulas, &i.moving_g, &moving).scalar();
        let (einstein, omega) = Inside::new(&i.formulas, &i.g, &base).einstein();
        let inverse = inverse_and_det(&i.g).0;
        let s_sigma = reverse_trace(&i.formulas, &i.g, &inverse, &i.sigma);
        let against = |a: &Mat<S::Base, N>| base.inner(a, &i.sigma0()) * omega;
        vec![
            Equation::new("∂_t(Rω)")
                .left("∂_t(Rω)", density.rate())
                .right("(div div 𝕊σ)ω", still.div_div(&s_sigma) * omega)
                .right("−⟨G,σ⟩ω", -against(&einstein))
                .vanishes(N == 2, "G = 0 when N = 2")
                .magnitude(against(&still.ricci()))
                .forge("Ric for G", "−⟨G,σ⟩ω", -against(&still.ricci()))
                .forge("no 𝕊", "(div div 𝕊σ)ω", still.div_div(&i.sigma) * omega)
                .forge(
                    "𝕊 with ½",
                    "(div div 𝕊σ)ω",
                    still.div_div(&halved(i)) * omega,
                ),
        ]
    }
}

/// σ − ½ g Tr σ: another convention of the trace reversal, which is not the paper's.
fn halved<S: Timed, const N: usize>(i: &Instance<S, N>) -> Mat<Jet2<S::Base, N>, N> {
    let inverse = inverse_and_det(&i.g).0;
    let s = reverse_trace(&PAPER, &i.g, &inverse, &i.sigma);
    symmetric(|a, b| (s[(a, b)] + i.sigma[(a, b)]) * Jet2::half())
}

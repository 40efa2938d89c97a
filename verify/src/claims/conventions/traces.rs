//! D01, D02, I09, M11: traces.

use crate::harness::{Equation, Record, Timed};
use crate::stage::point::{Instance, Pointwise};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Vector, identity, inverse_and_det, symmetric};
use regge_curvature::riemann::{differential, trace};
use regge_curvature::scalar::Field;

/// Conventions.
pub struct D01;

impl Pointwise for D01 {
    const RECORD: Record = Record {
        label: "D01",
        paper: &["sec:evolution"],
        title: "Traces and derivatives commute",
        statement: r"\nabla\operatorname{Tr}\sigma = \operatorname{Tr}\nabla\sigma,\quad
            \Delta\operatorname{Tr}\sigma = \operatorname{div}\operatorname{div}(g\operatorname{Tr}\sigma),\quad
            \langle g,\sigma\rangle = \operatorname{Tr}\sigma,\quad \Delta v = \operatorname{Tr}\nabla\nabla v",
        sides: "Left: derivatives of the jet of a function. Right: covariant derivatives of tensors. Both use Γ, the left only in div.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (still, sigma) = (i.still(), i.sigma0());
        let base = still.lower();
        let tr: Jet2<S::Base, N> = trace(&inverse_and_det(&i.g).0, &i.sigma);
        let nabla = base.nabla_tensor(&i.sigma1());
        let g_tr = symmetric(|a, b| i.g[(a, b)] * tr);
        let euclidean = trace(&identity(), &sigma);
        vec![
            Equation::new("∇Tr")
                .left("∇Trσ", differential(&tr).map(|d| d.value))
                .right(
                    "Tr∇σ",
                    Vector::<_, N>::from_fn(|m, _| base.trace(&nabla[m])),
                ),
            Equation::new("ΔTr")
                .left("ΔTrσ", still.laplacian(&tr))
                .right("div div(gTrσ)", still.div_div(&g_tr)),
            Equation::new("⟨g,σ⟩")
                .left("⟨g,σ⟩", base.inner(&base.g, &sigma))
                .right("Trσ", tr.value)
                .forge("Euclidean trace", "Trσ", euclidean),
            Equation::new("Δv")
                .left("Δv", still.laplacian(&i.v))
                .right("Tr∇∇v", base.trace(&base.hessian(&i.v)))
                .forge(
                    "Euclidean trace",
                    "Tr∇∇v",
                    trace(&identity(), &base.hessian(&i.v)),
                ),
        ]
    }
}

/// 𝕊.
pub struct D02;

impl Pointwise for D02 {
    const RECORD: Record = Record {
        label: "D02",
        paper: &["prop:curvdot"],
        title: "The operator 𝕊 and its inverse",
        statement: r"\operatorname{Tr}\mathbb{S}\sigma = (1-N)\operatorname{Tr}\sigma,\qquad
            \mathbb{S}^{-1}\rho = \rho - \frac{g\operatorname{Tr}\rho}{N-1}",
        sides: "Left: the library's 𝕊. Right: the trace.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, sigma) = (i.still0(), i.sigma0());
        let rho = base.reverse_trace(&i.formulas, &sigma);
        let tr = base.trace(&sigma);
        let n = N as i64;
        let half_s = (rho + sigma).map(|x| x * S::Base::half());
        let back = base.trace(&rho) * S::Base::ratio(1, n - 1);
        vec![
            Equation::new("Tr 𝕊")
                .left("Tr 𝕊σ", base.trace(&rho))
                .right("(1−N)Trσ", S::Base::from_int(1 - n) * tr)
                .forge("N for N−1", "(1−N)Trσ", S::Base::from_int(-n) * tr)
                .forge("𝕊 with ½", "Tr 𝕊σ", base.trace(&half_s)),
            Equation::new("𝕊⁻¹")
                .left("𝕊σ", rho)
                .left("−gTr(𝕊σ)/(N−1)", base.g.map(|x| -back * x))
                .right("σ", sigma),
        ]
    }
}

/// |𝕊σ|².
pub struct I09;

impl Pointwise for I09 {
    const RECORD: Record = Record {
        label: "I09",
        paper: &["normSgsigma"],
        title: "The length of 𝕊σ",
        statement: r"\langle\mathbb{S}\sigma,\mathbb{S}\sigma\rangle = \langle\sigma,\sigma\rangle
            + (N-2)\langle g,\sigma\rangle^2",
        sides: "Left: the library's 𝕊. Right: σ and its trace.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, sigma) = (i.still0(), i.sigma0());
        let rho = base.reverse_trace(&i.formulas, &sigma);
        let square = base.inner(&base.g, &sigma) * base.inner(&base.g, &sigma);
        let times = |k: usize| S::Base::from_int(k as i64) * square;
        vec![
            Equation::new("|𝕊σ|²")
                .left("⟨𝕊σ,𝕊σ⟩", base.inner(&rho, &rho))
                .right("⟨σ,σ⟩", base.inner(&sigma, &sigma))
                .right("(N−2)⟨g,σ⟩²", times(N - 2))
                .vanishes(N == 2, "N − 2 = 0")
                .forge("N−1 for N−2", "(N−2)⟨g,σ⟩²", times(N - 1)),
        ]
    }
}

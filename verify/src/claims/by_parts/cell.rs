//! T03: twice by parts over a cell.

use crate::harness::{Draw, Equation, Ground, Judgement, Record, Setting};
use crate::stage::mesh::{FLAT, FaceTerms, OnMesh, Pair, QUADRATURE, Where, minus, on_one_simplex};
use crate::stage::polynomial::{ByParts, Exactly, poison, poisoned};
use regge_curvature::formulas::Formulas;

/// The first two integrations by parts of its proof.
pub struct T03;

impl OnMesh for T03 {
    const RECORD: Record = Record {
        label: "T03",
        paper: &["IBP1"],
        title: "The two integrations by parts over a cell",
        statement: r"\int_T\langle\mathbb{S}\sigma,\nabla\nabla v\rangle\omega = \int_{\partial T}\mathbb{S}\sigma(n,\nabla v)
            - \int_T(\operatorname{div}\mathbb{S}\sigma)(\nabla v)\omega = \int_{\partial T}\mathbb{S}\sigma(n,\nabla v) -
            \int_{\partial T}(\operatorname{div}\mathbb{S}\sigma)(n)v + \int_T(\operatorname{div}\operatorname{div}\mathbb{S}\sigma)v\omega",
        sides: "Left: second derivatives of v, in the production b_h's cell term. Right: no second derivatives of v, then no \
            derivatives of v in the cell. Exactly as T04.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        on_one_simplex(dimension, quick)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let flat = at.degree == 0;
        let pair = Pair::<N>::draw(at, draw);
        let (hessian, normal) = (pair.b().t, pair.normal_gradient());
        let flux = |q: fn(&FaceTerms) -> f64| minus(&pair.faces(Where::Everywhere, q));
        vec![
            Equation::new("once")
                .left("∫⟨𝕊σ,∇∇v⟩ω", hessian.clone())
                .right("∫_∂T 𝕊σ(n,∇v)", normal.clone())
                .right("−∫(div 𝕊σ)(∇v)ω", pair.div_gradient())
                .vanishes(flat, FLAT),
            Equation::new("twice")
                .left("∫⟨𝕊σ,∇∇v⟩ω", hessian)
                .right("∫_∂T 𝕊σ(n,∇v)", normal)
                .right("−∫_∂T (div 𝕊σ)(n)v", flux(|q| q.div_s))
                .vanishes(flat, FLAT)
                .right("∫(div div 𝕊σ)vω", pair.div_div())
                .vanishes(flat, FLAT)
                .forge("div for div 𝕊", "−∫_∂T (div 𝕊σ)(n)v", flux(|q| q.div))
                .vacuous(flat, FLAT),
        ]
    }
}

/// The same two equations between integrals that are computed without error.
impl ByParts for T03 {
    const RECORD: Record = <Self as OnMesh>::RECORD;

    fn equations<F: Ground, const N: usize>(
        numbers: &[F],
        formulas: &Formulas,
    ) -> Vec<Equation<F>> {
        let at = Exactly::<F, N>::on_single(numbers, formulas);
        let faces = at.faces(|q| [q.gradient, q.div_s]);
        let [div_div, hessian, inner] = if poisoned(&faces) {
            poison()
        } else {
            at.cells()
        };
        let [normal, div] = faces;
        vec![
            Equation::new("once")
                .left("∫⟨𝕊σ,∇∇v⟩ω", hessian)
                .right("∫_∂T 𝕊σ(n,∇v)", normal)
                .right("−∫(div 𝕊σ)(∇v)ω", -inner),
            Equation::new("twice")
                .left("∫⟨𝕊σ,∇∇v⟩ω", hessian)
                .right("∫_∂T 𝕊σ(n,∇v)", normal)
                .right("−∫_∂T (div 𝕊σ)(n)v", -div)
                .right("∫(div div 𝕊σ)vω", div_div),
        ]
    }
}

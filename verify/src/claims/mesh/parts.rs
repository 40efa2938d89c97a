//! M04: lemma:IBPdivdivS on a mesh; T03, T04: on one simplex.

use super::density::FaceTerms;
use super::fields::{InteriorFaces, Tested, minus};
use super::pair::{Pair, Where, with_pair};
use super::setting::{Draw, OnMesh, QUADRATURE, Setting, Shape, grid};
use super::variation::{FLAT, everywhere, orders};
use crate::claim::{Equation, Judgement, Record};
use regge_curvature::formulas::Formulas;

/// lemma:IBPdivdivS on a mesh.
pub struct M04;

const DIV_DIV: &str = "Σ_T ∫(div div 𝕊σ)vω";
const FLUX: &str = "−Σ_F ∫⟦(div 𝕊σ)(n) + div_F(σ(n,·)) − Hσ(n,n)⟧vω_F";
const TURN: &str = "−Σ_S ∫Σ_F⟦σ(n,τ)⟧vω_S";
const HESSIAN: &str = "Σ_T ∫⟨𝕊σ,∇∇v⟩ω";
const NORMAL: &str = "−Σ_F ∫𝕊σ(n,n)⟦∇_n v⟧ω_F";

/// The cases on one simplex: nothing there is continuous, and v is free.
pub fn on_one_simplex(dimension: usize, quick: bool) -> Vec<Setting> {
    let times = if quick { 2 } else { 9 };
    match dimension {
        2 | 3 => grid(&[Shape::Single], &orders(dimension), times),
        // The reference simplex is no thin one: lower orders do.
        4 => grid(&[Shape::Single], &[2, 12, 14], times / 2),
        _ => Vec::new(),
    }
}

impl OnMesh for M04 {
    const RECORD: Record = Record {
        label: "M04",
        paper: &["lemma:IBPdivdivS"],
        title: "Integration by parts of div div 𝕊σ on a mesh, with the conormal corrected",
        statement: r"\sum_T\int_T(\operatorname{div}\operatorname{div}\mathbb{S}\sigma)v\omega - \mathring{\sum_F}\int_F
            [\![(\operatorname{div}\mathbb{S}\sigma)(n)+\operatorname{div}_F(\sigma(n,\cdot))-H\sigma(n,n)]\!]v\omega_F
            - \mathring{\sum_S}\int_S\sum_{F\supset S}[\![\sigma(n,\tau)]\!]_F v\omega_S = b_h(g;\sigma,v)\quad\forall v\in V",
        sides: "Left: derivatives of σ and none of v. Right: the production b_h, with derivatives of v and none of σ. They \
            agree in the limit of exact quadrature. Exactly as T04, on a triangle cut into three, with v a multiple of a hat \
            function and σ(n,n) discontinuous.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        everywhere(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        with_pair::<_, N>(at, draw, |pair| {
            let terms = terms::<K, N>(pair, Where::Interior);
            let on = |tested: Tested| -> Vec<(&'static str, Vec<f64>)> {
                let all = terms.iter();
                all.map(|(n, v)| (*n, tested.of(&pair.space, v))).collect()
            };
            let inner = |v: &[f64]| Tested::Inner.of(&pair.space, v);
            let (closed, open) = (at.shape.is_closed(), "there is no boundary");
            let wrong = inner(&pair.b::<InteriorFaces>().f);
            vec![
                equation(on(Tested::Inner), at.degree == 0)
                    .forge("the printed sign of τ", TURN, minus(&inner(&terms[2].1)))
                    .forge("b_h over interior faces only", NORMAL, wrong)
                    .vacuous(closed, open)
                    .forge_terms("v ≠ 0 on ∂Ω", on(Tested::Outer))
                    .vacuous(closed, open),
            ]
        })
    }
}

/// The five terms, with σ's derivatives on the interior faces and hinges, or on all.
fn terms<K: Formulas, const N: usize>(pair: &Pair<N>, on: Where) -> Vec<(&'static str, Vec<f64>)> {
    let b = pair.b::<K>();
    vec![
        (DIV_DIV, pair.div_div::<K>()),
        (FLUX, minus(&pair.faces::<K>(on, FaceTerms::flux))),
        (TURN, minus(&pair.turned::<K>(on))),
        (HESSIAN, b.t),
        (NORMAL, b.f),
    ]
}

/// Three terms on the left, two on the right.
fn equation(terms: Vec<(&'static str, Vec<f64>)>, flat: bool) -> Equation<f64> {
    let mut equation = Equation::new("div div 𝕊 by parts");
    for (i, (name, value)) in terms.into_iter().enumerate() {
        equation = if i < 3 {
            equation.left(name, value).vanishes(flat && i < 2, FLAT)
        } else {
            equation.right(name, value)
        };
    }
    equation
}

/// The lemma on one simplex, with its boundary terms, for any v.
pub struct T04;

impl OnMesh for T04 {
    const RECORD: Record = Record {
        label: "T04",
        paper: &["lemma:IBPdivdivS"],
        title: "Integration by parts of div div 𝕊σ on one simplex, for any v",
        statement: r"\int_T(\operatorname{div}\operatorname{div}\mathbb{S}\sigma)v\omega - \sum_{F\subset\partial T}\int_F
            \bigl((\operatorname{div}\mathbb{S}\sigma)(n)+\operatorname{div}_F(\sigma(n,\cdot))-H\sigma(n,n)\bigr)v\omega_F
            - \sum_{S}\int_S\sum_{F\supset S}\sigma(n,\tau)v\omega_S = \int_T\langle\mathbb{S}\sigma,\nabla\nabla v\rangle\omega
            - \sum_F\int_F\mathbb{S}\sigma(n,n)\nabla_n v\,\omega_F",
        sides: "Left: derivatives of σ and none of v, boundary included. Right: the production b_h on a mesh of one cell: \
            derivatives of v and none of σ. Exactly: g = LLᵀ with L unipotent and affine, which is curved, and v = (∏_F q_F)²w \
            with q_F = ν·g⁻¹ν, so that every integrand is a polynomial and is integrated without error. τ points into F; the \
            paper prints + for the sum over S, a forgery here.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        on_one_simplex(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        with_pair::<_, N>(at, draw, |pair| {
            let terms = terms::<K, N>(pair, Where::Everywhere);
            let turned = minus(&terms[2].1);
            let without_h = pair.faces::<K>(Where::Everywhere, |q| -q.div_s - q.div_f);
            vec![
                equation(terms, at.degree == 0)
                    .forge("the printed sign of τ", TURN, turned)
                    .forge("without Hσ(n,n)", FLUX, without_h)
                    .vacuous(at.degree == 0, FLAT),
            ]
        })
    }
}

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

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let flat = at.degree == 0;
        with_pair::<_, N>(at, draw, |pair| {
            let (hessian, normal) = (pair.b::<K>().t, pair.normal_gradient::<K>());
            let flux = |q: fn(&FaceTerms) -> f64| minus(&pair.faces::<K>(Where::Everywhere, q));
            vec![
                Equation::new("once")
                    .left("∫⟨𝕊σ,∇∇v⟩ω", hessian.clone())
                    .right("∫_∂T 𝕊σ(n,∇v)", normal.clone())
                    .right("−∫(div 𝕊σ)(∇v)ω", pair.div_gradient::<K>())
                    .vanishes(flat, FLAT),
                Equation::new("twice")
                    .left("∫⟨𝕊σ,∇∇v⟩ω", hessian)
                    .right("∫_∂T 𝕊σ(n,∇v)", normal)
                    .right("−∫_∂T (div 𝕊σ)(n)v", flux(|q| q.div_s))
                    .vanishes(flat, FLAT)
                    .right("∫(div div 𝕊σ)vω", pair.div_div::<K>())
                    .vanishes(flat, FLAT)
                    .forge("div for div 𝕊", "−∫_∂T (div 𝕊σ)(n)v", flux(|q| q.div))
                    .vacuous(flat, FLAT),
            ]
        })
    }
}

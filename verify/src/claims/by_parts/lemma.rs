//! lemma:IBPdivdivS: M04 on a mesh, T04 on one simplex; over meshes and exactly.

use crate::harness::{Draw, Equation, Ground, Judgement, Record, Setting, each};
use crate::stage::mesh::{
    FLAT, FaceTerms, OnMesh, Pair, QUADRATURE, Tested, Where, everywhere, minus, on_one_simplex,
};
use crate::stage::polynomial::{ByParts, Exactly, add_up, poison};
use regge_curvature::formulas::Formulas;
use regge_curvature::simplex::subsets;

/// lemma:IBPdivdivS on a mesh.
pub struct M04;

const DIV_DIV: &str = "Σ_T ∫(div div 𝕊σ)vω";
const FLUX: &str = "−Σ_F ∫⟦(div 𝕊σ)(n) + div_F(σ(n,·)) − Hσ(n,n)⟧vω_F";
const TURN: &str = "−Σ_S ∫Σ_F⟦σ(n,τ)⟧vω_S";
const HESSIAN: &str = "Σ_T ∫⟨𝕊σ,∇∇v⟩ω";
const NORMAL: &str = "−Σ_F ∫𝕊σ(n,n)⟦∇_n v⟧ω_F";

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

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let pair = Pair::<N>::draw(at, draw);
        let terms = terms::<N>(&pair, Where::Interior);
        let on = |tested: Tested| -> Vec<(&'static str, Vec<f64>)> {
            each(&terms, |(name, v)| (*name, tested.of(&pair.space, v)))
        };
        let inner = |v: &[f64]| Tested::Inner.of(&pair.space, v);
        let (closed, open) = (at.shape.is_closed(), "there is no boundary");
        let interior = Formulas {
            b_on_boundary: false,
            ..at.formulas
        };
        let wrong = inner(&pair.b_by(interior).f);
        vec![
            equation(on(Tested::Inner), at.degree == 0)
                .forge("the printed sign of τ", TURN, minus(&inner(&terms[2].1)))
                .forge("b_h over interior faces only", NORMAL, wrong)
                .vacuous(closed, open)
                .forge_terms("v ≠ 0 on ∂Ω", on(Tested::Outer))
                .vacuous(closed, open),
        ]
    }
}

/// The five terms, with σ's derivatives on the interior faces and hinges, or on all.
fn terms<const N: usize>(pair: &Pair<N>, on: Where) -> Vec<(&'static str, Vec<f64>)> {
    let b = pair.b();
    vec![
        (DIV_DIV, pair.div_div()),
        (FLUX, minus(&pair.faces(on, FaceTerms::flux))),
        (TURN, minus(&pair.turned(on))),
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

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let pair = Pair::<N>::draw(at, draw);
        let terms = terms::<N>(&pair, Where::Everywhere);
        let turned = minus(&terms[2].1);
        let without_h = pair.faces(Where::Everywhere, |q| -q.div_s - q.div_f);
        vec![
            equation(terms, at.degree == 0)
                .forge("the printed sign of τ", TURN, turned)
                .forge("without Hσ(n,n)", FLUX, without_h)
                .vacuous(at.degree == 0, FLAT),
        ]
    }
}

/// Σ_F: (div 𝕊σ)(n) v, div_F(σ(n,·)) v, Hσ(n,n) v, 𝕊σ(n,n)∇_n v.
struct Terms<F> {
    faces: [F; 4],
    hinges: F,
    cells: [F; 3],
}

impl<F: Ground> Terms<F> {
    fn equation(self) -> Equation<F> {
        let ([div_s, div_f, h_nn, normal], turn) = (self.faces, self.hinges);
        Equation::new("by parts")
            .left("∫(div div 𝕊σ)v", self.cells[0])
            .left("−Σ_F∫(div 𝕊σ)(n)v", -div_s)
            .left("−Σ_F∫div_F(σ(n,·))v", -div_f)
            .left("Σ_F∫Hσ(n,n)v", h_nn)
            .left("−Σ_S∫Σσ(n,τ)v", -turn)
            .right("∫⟨𝕊σ,∇∇v⟩", self.cells[1])
            .right("−Σ_F∫𝕊σ(n,n)∇_n v", -normal)
            .forge("conormal as printed", "−Σ_S∫Σσ(n,τ)v", turn)
    }
}

impl ByParts for T04 {
    const RECORD: Record = <Self as OnMesh>::RECORD;

    fn equations<F: Ground, const N: usize>(
        numbers: &[F],
        formulas: &Formulas,
    ) -> Vec<Equation<F>> {
        let at = Exactly::<F, N>::on_single(numbers, formulas);
        // The hinges first: where roots do not exist at all, the rest need not be integrated.
        let mut hinges = F::zero();
        for pair in subsets(N + 1, 2) {
            let two = at.integral(N - 2, &|l| at.hinge(0, [pair[0], pair[1]], l));
            hinges += two[0] + two[1];
        }
        let mut terms = Terms {
            hinges,
            faces: poison(),
            cells: poison(),
        };
        if !hinges.is_poison() {
            terms.faces = at.faces(|q| [q.div_s, q.div_f, q.h_nn, q.s_nn * q.along_n]);
            terms.cells = at.cells();
        }
        vec![terms.equation()]
    }
}

/// A vertex of a cell that is neither the inner one nor this one.
fn other_than<const N: usize>(place: usize) -> usize {
    let other = (1..=N).find(|v| *v != place);
    other.expect("a triangle has two corners beside the inner vertex")
}

/// On a triangle cut into three, v a multiple of the inner vertex's hat function.
impl M04 {
    /// The inner vertex.
    fn hinge<F: Ground, const N: usize>(at: &Exactly<F, N>) -> F {
        let of = |cell: usize| at.hinge(cell, [1, 2], &[F::one()]);
        let all = (0..at.cell_count()).map(of);
        all.fold(F::zero(), |sum, two| sum + two[0] + two[1])
    }

    /// The inner edges, from the inner vertex to the corner c, from both sides; 𝕊σ(n,n) of the first for both.
    fn inner_edge<F: Ground, const N: usize>(at: &Exactly<F, N>, c: usize) -> [F; 4] {
        let sides: Vec<(usize, usize)> = (0..=N)
            .filter(|cell| *cell != c)
            .map(|cell| {
                // The cell lacks one corner: its vertices are the inner one and the others in their order.
                let place = 1 + c - usize::from(cell < c);
                (cell, other_than::<N>(place))
            })
            .collect();
        at.integral(N - 1, &|lambda| {
            let [p, q] = [sides[0], sides[1]].map(|(cell, f)| at.face(cell, f, lambda));
            let normal = p.s_nn * (p.along_n + q.along_n);
            [
                p.div_s + q.div_s,
                p.div_f + q.div_f,
                p.h_nn + q.h_nn,
                normal,
            ]
        })
    }

    /// The boundary, where v vanishes and ∇v does not.
    fn boundary<F: Ground, const N: usize>(at: &Exactly<F, N>, cell: usize) -> [F; 4] {
        let normal = at.integral(N - 1, &|lambda| {
            let p = at.face(cell, 0, lambda);
            [p.s_nn * p.along_n]
        });
        [F::zero(), F::zero(), F::zero(), normal[0]]
    }
}

impl ByParts for M04 {
    const RECORD: Record = <Self as OnMesh>::RECORD;
    const CUT: bool = true;

    fn equations<F: Ground, const N: usize>(
        numbers: &[F],
        formulas: &Formulas,
    ) -> Vec<Equation<F>> {
        let at = Exactly::<F, N>::on_cut(numbers, formulas);
        let mut terms = Terms {
            hinges: Self::hinge(&at),
            faces: poison(),
            cells: poison(),
        };
        if !terms.hinges.is_poison() {
            let inner = (0..=N).map(|c| Self::inner_edge(&at, c));
            let outer = (0..=N).map(|cell| Self::boundary(&at, cell));
            terms.faces = inner.chain(outer).fold([F::zero(); 4], add_up);
            terms.cells = at.cells();
        }
        vec![terms.equation()]
    }
}

//! M07, M10, M19: the distributional Einstein tensor.

use super::evolution::{Evolution, Moving};
use super::fields::{PlainSecondForm, Three, times, values};
use super::pair::with_pair;
use super::setting::{Draw, OnMesh, QUADRATURE, ROUNDING, Setting, Shape, grid};
use super::variation::{FLAT, POINTS, everywhere};
use crate::claim::{Equation, Judgement, Record};
use regge_curvature::field::TensorField;
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{a_h_with, distributional_curvature_with};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::Mat;
use regge_curvature::simplex::{Bernstein, JetTable, Points};
use regge_curvature::spaces::Lagrange;

/// v σ for a function v of a Lagrange space.
struct Product<'a, S, const N: usize> {
    space: &'a Lagrange<N>,
    v: &'a [f64],
    sigma: &'a S,
}

impl<S: TensorField<f64, N>, const N: usize> TensorField<f64, N> for Product<'_, S, N> {
    type Table = (JetTable<f64, N>, S::Table);
    type Local = (Vec<f64>, S::Local);

    fn tabulate(&self, points: &Points) -> Self::Table {
        let basis = Bernstein::new(N + 1, self.space.degree());
        (JetTable::new(&basis, points), self.sigma.tabulate(points))
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        let v = self.space.cell_dofs(cell).map(|d| self.v[d]).collect();
        (v, self.sigma.on_cell(cell))
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let v = table.0.jet2(q, &local.0);
        self.sigma.jet2(&local.1, &table.1, q).map(|x| v * x)
    }
}

/// (Gω)_dist = 0 when N = 2.
pub struct M07;

impl OnMesh for M07 {
    const RECORD: Record = Record {
        label: "M07",
        paper: &["def:distein"],
        title: "The distributional Einstein tensor of a surface vanishes",
        statement: r"N=2:\qquad (G\omega)_{\rm dist}(g)=0,\ \text{each of its three sums for itself}",
        sides: "Left: each sum of the production a_h; exactly, what is integrated there. Right: nothing.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        if dimension == 2 {
            grid(
                &[
                    Shape::Alfeld,
                    Shape::Cube(2),
                    Shape::Torus(3),
                    Shape::Sphere,
                ],
                &[4, 4, 4],
                if quick { 1 } else { 6 },
            )
        } else {
            Vec::new()
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let (a, plain) = with_pair::<_, N>(at, draw, |pair| {
            (pair.a::<K>(), pair.a::<PlainSecondForm>())
        });
        let flat = at.degree == 0;
        // R and Θ of size 1 times σ of size 1: what cancels.
        let size = 1.0;
        vec![
            Equation::new("∫⟨G,σ⟩vω")
                .left("Σ_T", a.t)
                .vanishes(true, "G = 0")
                .magnitude(size),
            Equation::new("∫⟨⟦II‾⟧,σ⟩vω_F")
                .left("Σ_F", a.f)
                .vanishes(true, "II‾ = II − Hg = 0 on a curve")
                .magnitude(size)
                .forge("II for II‾", "Σ_F", plain.f)
                .vacuous(flat, FLAT),
            Equation::new("∫Θ Tr(σ|_S)v")
                .left("Σ_S", a.s)
                .vanishes(true, POINTS)
                .magnitude(size),
        ]
    }
}

/// The same as M05 by the Einstein tensor.
pub struct M10;

impl Evolution for M10 {
    const RECORD: Record = Record {
        label: "M10",
        paper: &["sec:einstein", "def:distein", "curvdotintro"],
        title: "The variation by (div div 𝕊)_dist and the distributional Einstein tensor",
        statement: r"\frac{d}{dt}\Big|_0\langle (R\omega)_{\rm dist}(g+t\sigma),v\rangle = \langle(\operatorname{div}
            \operatorname{div}\mathbb{S})_{\rm dist}\sigma,v\rangle - \langle (G\omega)_{\rm dist}(g),v\sigma\rangle",
        sides: "As M05, but the last term is the Einstein tensor against the field vσ, tested with 1, for one random v: \
            nothing vanishes term by term. v need not be smooth.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        everywhere(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(_: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let (pair, v) = (&m.at, &m.v);
        let paired = |sum: &[f64]| -> f64 { sum.iter().zip(v).map(|(s, c)| s * c).sum() };
        let whole = |x: &Three| paired(&x.t) + paired(&x.f) + paired(&x.s);
        let product = Product {
            space: &pair.space,
            v,
            sigma: &pair.sigma,
        };
        let hats = Lagrange::new(pair.space.mesh(), 1);
        let einstein = a_h_with::<K, f64, N, _, _>(&pair.g, &product, &hats, &pair.rules)
            .pair(&vec![1.0; hats.len()]);
        vec![
            Equation::new("by the Einstein tensor")
                .left("d/dt⟨(Rω)_dist,v⟩", whole(&m.rate))
                .right("⟨(div div 𝕊)_dist σ,v⟩", whole(&pair.b::<K>()))
                .right("−⟨(Gω)_dist,vσ⟩", -einstein.iter().sum::<f64>())
                .vanishes(N == 2, "(Gω)_dist = 0 when N = 2"),
        ]
    }
}

/// The trace of the Einstein tensor.
pub struct M19;

impl OnMesh for M19 {
    const RECORD: Record = Record {
        label: "M19",
        paper: &["sec:einstein"],
        title: "The trace of the distributional Einstein tensor",
        statement: r"\langle (G\omega)_{\rm dist}(g),gv\rangle = -\frac{N-2}{2}\langle (R\omega)_{\rm dist}(g),v\rangle,
            \text{ sum by sum}",
        sides: "Left: the production a_h with σ = g: Ric, II‾ and hinge traces contracted with g. Right: the production \
            functional of def:distcurv. They share Γ, H and Θ, whose values D03, D11 and O01–O03 check; the claim is about the \
            contractions. The same rule on both sides: no quadrature error.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 1 } else { 4 };
        match dimension {
            2..=4 => grid(&[Shape::Alfeld, Shape::Sphere], &[3, 3, 3], times),
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let (a, r) = with_pair::<_, N>(at, draw, |pair| {
            let (g, space, rules) = (&pair.g, &pair.space, &pair.rules);
            (
                values(a_h_with::<K, f64, N, _, _>(g, g, space, rules)),
                values(distributional_curvature_with::<K, f64, N, _>(
                    g, space, rules,
                )),
            )
        });
        let (flat, surface) = (at.degree == 0, N == 2);
        let size = r.s.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let side = |name, left: &[f64], right: &[f64], none: bool| {
            Equation::new(name)
                .left("⟨(Gω),gv⟩", left.to_vec())
                .vanishes(none || surface, "N − 2 = 0, or g is constant on cells")
                .right("−(N−2)/2 ⟨(Rω),v⟩", times(-0.5 * (N as f64 - 2.0), right))
                .vanishes(none || surface, "N − 2 = 0, or g is constant on cells")
                .magnitude(size)
                .forge(
                    "N − 1 for N − 2",
                    "−(N−2)/2 ⟨(Rω),v⟩",
                    times(-0.5 * (N as f64 - 1.0), right),
                )
                .vacuous(none, FLAT)
        };
        vec![
            side("Σ_T", &a.t, &r.t, flat),
            side("Σ_F", &a.f, &r.f, flat),
            side("Σ_S", &a.s, &r.s, false),
        ]
    }
}

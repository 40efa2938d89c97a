//! M07, M10, M19: the distributional Einstein tensor.

use crate::harness::{Equation, Judgement, Record, Setting, pairwise};
use crate::stage::fields::moving;
use crate::stage::mesh::{Evolution, Moving, QUADRATURE, Three, everywhere, rates};
use regge_curvature::field::{Evaluate, PointByPoint};
use regge_curvature::functional::{distributional_curvature, einstein};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::Mat;
use regge_curvature::simplex::{Derivatives, JetTable, Points};
use regge_curvature::spaces::{Indicators, Lagrange};

/// v σ for a function v of a Lagrange space.
struct Product<'a, S, const N: usize> {
    space: &'a Lagrange<N>,
    v: &'a [f64],
    sigma: &'a S,
}

impl<S: Evaluate<f64, N>, const N: usize> Evaluate<f64, N> for Product<'_, S, N> {
    type Table = (JetTable<f64, N>, S::Table);
    type Local = (Vec<f64>, S::Local);

    fn tabulate(&self, points: &Points) -> Self::Table {
        let v = JetTable::new(self.space.degree(), points);
        (v, self.sigma.tabulate(points))
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        let v: Vec<f64> = self.space.cell_dofs(cell).map(|d| self.v[d]).collect();
        let v = Derivatives::<N>::new(self.space.degree()).follow(1, &v);
        (v, self.sigma.on_cell(cell))
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let v = table.0.jet2(q, &local.0);
        self.sigma.jet2(&local.1, &table.1, q).map(|x| v * x)
    }
}

/// The size of what is added up: for one random v a sum may be a hundred times smaller than its terms, and the rounding is
/// of these. For r = 0 there may be one test function alone, whose terms are the hinges'.
fn parts<const N: usize>(at: &Setting, m: &Moving<N>) -> f64 {
    let pair = &m.at;
    let size = |sum: &[f64]| -> f64 { sum.iter().map(|x| x.abs()).sum() };
    let all = |three: &Three| size(&three.t) + size(&three.f) + size(&three.s);
    if at.degree == 0 {
        let simplices = Indicators::new(pair.space.mesh());
        let g = moving(&pair.g, &pair.sigma);
        return all(&rates(&distributional_curvature(
            &g,
            &simplices,
            &pair.rules,
        )));
    }
    let times = |sum: &[f64]| pairwise(sum, &m.v, |s, c| s * c);
    size(&times(&m.rate.t)) + size(&times(&m.rate.f)) + size(&times(&m.rate.s))
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

    fn equations<const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let (pair, v) = (&m.at, &m.v);
        let paired = |sum: &[f64]| -> f64 { sum.iter().zip(v).map(|(s, c)| s * c).sum() };
        let whole = |x: &Three| paired(&x.t) + paired(&x.f) + paired(&x.s);
        let product = Product {
            space: &pair.space,
            v,
            sigma: &pair.sigma,
        };
        // vσ is evaluated over f64 alone.
        let g = PointByPoint(&pair.g);
        let einstein = einstein(&g, &product, pair.space.mesh(), &pair.rules);
        vec![
            Equation::new("by the Einstein tensor")
                .left("d/dt⟨(Rω)_dist,v⟩", whole(&m.rate))
                .right("⟨(div div 𝕊)_dist σ,v⟩", whole(&pair.b()))
                .right("−⟨(Gω)_dist,vσ⟩", -einstein.total())
                .magnitude(parts(at, m))
                .vanishes(N == 2, "(Gω)_dist = 0 when N = 2"),
        ]
    }
}

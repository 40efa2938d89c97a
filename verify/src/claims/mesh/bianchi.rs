//! M18: the contracted Bianchi identity.

use super::fields::{Regge, metric};
use super::gauge::value_only;
use super::setting::{Draw, OnMesh, QUADRATURE, Setting, Shape};
use super::variation::{FLAT, POINTS, everywhere};
use crate::claim::{Equation, Judgement, Record};
use regge_curvature::field::TensorField;
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{Rules, a_h_with, b_h_with, distributional_curvature_with};
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, symmetric};
use regge_curvature::simplex::{JetTable, Points, barycentric_jets, multi_indices, subsets};
use regge_curvature::spaces::Lagrange;
use regge_curvature::spaces::ReggeSpace;

/// X = Σ c_ij λ_iλ_j (x_j − x_i) over the edges i < j: continuous, and tangent to every subsimplex.
pub(super) struct Tangent<'a, const N: usize> {
    /// The metric that it moves.
    pub g: &'a Regge<f64, N>,
    /// By edge of the mesh.
    pub c: Vec<f64>,
}

impl<const N: usize> Tangent<'_, N> {
    /// c on the edges of a cell.
    pub fn on_edges(&self, cell: usize) -> Vec<f64> {
        let edges = self.g.space().mesh().simplices_of(cell, 1);
        edges.iter().map(|&e| self.c[e as usize]).collect()
    }

    /// Xᵏ in reference coordinates, with derivatives.
    pub fn jets(c: &[f64], lambda: &[Jet2<f64, N>]) -> Vector<Jet1<f64, N>, N> {
        let mut x = Vector::from_element(Jet1::constant(0.0));
        for (edge, c) in subsets(N + 1, 2).iter().zip(c) {
            let (i, j) = (edge[0], edge[1]);
            let product = lambda[i] * lambda[j];
            let jet = Jet1 {
                value: c * product.value,
                d: product.d.map(|d| c * d),
            };
            // Vertex v is at e_{v−1}, vertex 0 at the origin.
            x[j - 1] += jet;
            if i > 0 {
                x[i - 1] -= jet;
            }
        }
        x
    }

    /// The coefficients of Xv of degree q+1: X B_α = Σ c_ij [α_j (α_i+1) B_{α+e_i} − α_i (α_j+1) B_{α+e_j}]/(q+1).
    fn apply(&self, space: &Lagrange<N>, target: &Lagrange<N>, v: &[f64]) -> Vec<f64> {
        let q = space.degree();
        let raised = multi_indices(N + 1, q + 1);
        let mut all = vec![0.0; target.len()];
        for cell in 0..space.mesh().cell_count() {
            let mut local = vec![0.0; raised.len()];
            for (alpha, dof) in multi_indices(N + 1, q).iter().zip(space.cell_dofs(cell)) {
                for (edge, c) in subsets(N + 1, 2).iter().zip(self.on_edges(cell)) {
                    for (from, to, sign) in [(edge[1], edge[0], 1.0), (edge[0], edge[1], -1.0)] {
                        let mut beta = alpha.clone();
                        beta[to] += 1;
                        let Some(place) = raised.iter().position(|b| *b == beta) else {
                            continue;
                        };
                        let factor = (alpha[from] * beta[to]) as f64 / (q + 1) as f64;
                        local[place] += sign * c * factor * v[dof];
                    }
                }
            }
            for (value, dof) in local.iter().zip(target.cell_dofs(cell)) {
                all[dof] = *value;
            }
        }
        all
    }
}

impl<const N: usize> TensorField<f64, N> for Tangent<'_, N> {
    type Table = (Vec<Vec<Jet2<f64, N>>>, JetTable<f64, N>);
    type Local = (Vec<f64>, Vec<f64>);

    fn tabulate(&self, points: &Points) -> Self::Table {
        let lambda = (0..points.len())
            .map(|q| barycentric_jets(points, q))
            .collect();
        (lambda, TensorField::<f64, N>::tabulate(self.g, points))
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        (
            self.on_edges(cell),
            TensorField::<f64, N>::on_cell(self.g, cell),
        )
    }
    /// (L_X g)_mn = Xᵏ∂_k g_mn + g_kn ∂_m Xᵏ + g_mk ∂_n Xᵏ.
    fn jet2(&self, local: &Self::Local, table: &Self::Table, q: usize) -> Mat<Jet2<f64, N>, N> {
        let x = Self::jets(&local.0, &table.0[q]);
        let g: Mat<Jet1<f64, N>, N> = self.g.jet1(&local.1, &table.1, q);
        symmetric(|m, n| {
            let mut sum = 0.0;
            for k in 0..N {
                sum += x[k].value * g[(m, n)].d[k];
                sum += g[(k, n)].value * x[k].d[m] + g[(m, k)].value * x[k].d[n];
            }
            value_only(sum)
        })
    }
}

/// The discrete Bianchi identity.
pub struct M18;

impl OnMesh for M18 {
    const RECORD: Record = Record {
        label: "M18",
        paper: &[],
        title: "The contracted Bianchi identity for Regge metrics",
        statement: r"X=\sum c_{ij}\lambda_i\lambda_j(x_j-x_i):\qquad b_h(g;L_Xg,v)-a_h(g;L_Xg,v) =
            -\langle (R\omega)_{\rm dist}(g),Xv\rangle\qquad\forall v\in V",
        sides: "Left: b_h and a_h with a Lie derivative. Right: the functional of g alone. X is tangent to every simplex, so \
            that its flow maps Regge metrics to Regge metrics on the same mesh, and the functional is invariant. Finite: the three \
            sums of φ*g against v∘φ and of g against v, φ = id + X, without any derivative of the functional.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        everywhere(dimension, quick)
            .into_iter()
            // L_X g has degree r + 2, v degree 2.
            .map(|s| Setting {
                order: s.order + 2,
                ..s
            })
            .filter(|s| dimension < 4 || s.shape != Shape::Torus(3))
            .collect()
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let g = metric(&regge, draw);
        let field = Tangent {
            g: &g,
            c: draw.numbers(mesh.count(1)),
        };
        let (space, target) = (
            Lagrange::new(&mesh, at.test),
            Lagrange::new(&mesh, at.test + 1),
        );
        let rules = Rules::new::<N>(at.order);
        let mut v = draw.numbers(space.len());
        for (dof, c) in v.iter_mut().enumerate() {
            *c *= f64::from(u8::from(space.vanishes_on_boundary(dof)));
        }
        let b = b_h_with::<K, f64, N, _, _>(&g, &field, &space, &rules).pair(&v);
        let a = a_h_with::<K, f64, N, _, _>(&g, &field, &space, &rules).pair(&v);
        let r = distributional_curvature_with::<K, f64, N, _>(&g, &target, &rules)
            .pair(&field.apply(&space, &target, &v));
        let (flat, surface) = (at.degree == 0, N == 2);
        vec![
            Equation::new("Bianchi")
                .left("Σ_T ∫⟨𝕊L_Xg,∇∇v⟩ω", b[0])
                .left("−Σ_F ∫𝕊L_Xg(n,n)⟦∇_n v⟧ω_F", b[1])
                .left("−Σ_T ∫⟨G,L_Xg⟩vω", -a[0])
                .vanishes(
                    flat || surface,
                    "G = 0 when N = 2, or g is constant on cells",
                )
                .left("−Σ̊_F ∫⟨⟦II‾⟧,L_Xg⟩vω_F", -a[1])
                .vanishes(
                    flat || surface,
                    "II‾ = 0 when N = 2, or g is constant on cells",
                )
                .left("Σ̊_S ∫Θ Tr(L_Xg|_S)vω_S", -a[2])
                .vanishes(surface, POINTS)
                .right("−Σ_T ∫R (Xv) ω", -r[0])
                .vanishes(flat, FLAT)
                .right("−2Σ̊_F ∫⟦H⟧(Xv)ω_F", -r[1])
                .vanishes(flat, FLAT)
                .right("−2Σ̊_S ∫Θ(Xv)ω_S", -r[2])
                .vanishes(surface, "X = 0 at vertices"),
        ]
    }
}

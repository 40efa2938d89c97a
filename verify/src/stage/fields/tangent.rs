//! Vector fields that are tangent to every subsimplex, and the Lie derivatives of metrics along them.

use super::regge::Regge;
use crate::harness::{each, list};
use regge_curvature::field::{Evaluate, TensorField};
use regge_curvature::jet::{Jet, Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, symmetric};
use regge_curvature::simplex::{JetTable, Points, barycentric_jets, multi_indices, subsets};
use regge_curvature::spaces::Lagrange;

/// The jet whose derivatives nobody may use: they are poison.
pub fn value_only<const N: usize>(value: f64) -> Jet2<f64, N> {
    Jet2 {
        value,
        d: [f64::NAN; N],
        dd: [[f64::NAN; N]; N],
    }
}

/// X = Σ c_ij λ_iλ_j (x_j − x_i) over the edges i < j: continuous, and tangent to every subsimplex.
pub struct Tangent<const N: usize> {
    /// The metric that it moves.
    pub g: Regge<f64, N>,
    /// By edge of the mesh.
    pub c: Vec<f64>,
}

impl<const N: usize> Tangent<N> {
    /// c on the edges of a cell.
    pub fn on_edges(&self, cell: usize) -> Vec<f64> {
        let edges = self.g.space().mesh().simplices_of(cell, 1);
        each(edges, |&e| self.c[e as usize])
    }

    /// Xᵏ in reference coordinates, with derivatives.
    pub fn jets(c: &[f64], lambda: &[Jet2<f64, N>]) -> Vector<Jet1<f64, N>, N> {
        let mut x = Vector::from_element(Jet1::constant(0.0));
        for (edge, c) in subsets(N + 1, 2).iter().zip(c) {
            let (i, j) = (edge[0], edge[1]);
            let product = lambda[i] * lambda[j];
            let jet = product.lower().map(|x| c * x);
            // Vertex v is at e_{v−1}, vertex 0 at the origin.
            x[j - 1] += jet;
            if i > 0 {
                x[i - 1] -= jet;
            }
        }
        x
    }

    /// The coefficients of Xv of degree q+1: X B_α = Σ c_ij [α_j (α_i+1) B_{α+e_i} − α_i (α_j+1) B_{α+e_j}]/(q+1).
    pub fn apply(&self, space: &Lagrange<N>, target: &Lagrange<N>, v: &[f64]) -> Vec<f64> {
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
                        let place = raised.iter().position(|b| *b == beta);
                        let place = place.expect("β is of degree q+1");
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

impl<const N: usize> Evaluate<f64, N> for Tangent<N> {
    type Table = (Vec<Vec<Jet2<f64, N>>>, JetTable<f64, N>);
    type Local = (Vec<f64>, Vec<f64>);

    fn tabulate(&self, points: &Points) -> Self::Table {
        let lambda = list(points.len(), |q| barycentric_jets(points, q));
        (lambda, Evaluate::<f64, N>::tabulate(&self.g, points))
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        (
            self.on_edges(cell),
            Evaluate::<f64, N>::on_cell(&self.g, cell),
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

impl<const N: usize> TensorField<N> for Tangent<N> {
    type Scalar = f64;
    type Wide = f64;
}

//! The local L² projection of a field, cell by cell.

use crate::Error;
use crate::field::Evaluate;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::simplex::{Bernstein, subsets};
use crate::spaces::{ReggeSpace, edge_components};
use nalgebra::DMatrix;

/// The rule of the local L² projection on each cell onto P_r.
#[derive(Clone, Debug)]
pub struct Projection {
    rule: Rule,
}

impl Projection {
    /// By a rule of exactness 2r + 12: the projection of a smooth metric to rounding on meshes that resolve it.
    pub fn exact<const N: usize>(degree: usize) -> Self {
        Self {
            rule: Rule::new(N, 2 * degree + 12),
        }
    }

    /// By a given rule; with as many points as dim P_r it interpolates there.
    pub fn by(rule: Rule) -> Self {
        Self { rule }
    }

    /// Coefficients of the projections of all edge components on all cells: `[cell][edge][α]`.
    pub(super) fn project<const N: usize, G: Evaluate<f64, N>>(
        &self,
        space: &ReggeSpace<N>,
        g: &G,
    ) -> Result<Vec<Vec<f64>>, Error> {
        let basis = Bernstein::new(N + 1, space.degree());
        let matrix = projection_matrix(&basis, &self.rule)?;
        let table = g.tabulate(self.rule.points());
        let edges = subsets(N + 1, 2).len();
        let mut all = Vec::with_capacity(space.mesh().cell_count());
        let on_cell = |cell: usize| {
            let local = g.on_cell(cell);
            let mut coefficients = vec![0.0; edges * basis.len()];
            for q in 0..self.rule.len() {
                for (e, c) in edge_components(&g.value(&local, &table, q))
                    .into_iter()
                    .enumerate()
                {
                    for a in 0..basis.len() {
                        coefficients[e * basis.len() + a] += matrix[(a, q)] * c;
                    }
                }
            }
            coefficients
        };
        in_order(space.mesh().cell_count(), on_cell, |_, local| {
            all.push(local)
        });
        Ok(all)
    }
}

/// M with c_α = Σ_q M_αq f(λ_q) the discrete L² projection: (∫ B_α B_β)⁻¹ B_β(λ_q) w_q, integrals by the same rule.
pub(super) fn projection_matrix(basis: &Bernstein, rule: &Rule) -> Result<DMatrix<f64>, Error> {
    let table = basis.tabulate::<f64>(rule.points());
    let values = DMatrix::from_fn(basis.len(), rule.len(), |a, q| table[q][a]);
    let weighted = DMatrix::from_fn(basis.len(), rule.len(), |a, q| {
        table[q][a] * rule.weights()[q]
    });
    let gram = &values * weighted.transpose();
    gram.lu().solve(&weighted).ok_or_else(|| {
        Error::Input(format!(
            "{} points cannot determine {} coefficients",
            rule.len(),
            basis.len()
        ))
    })
}

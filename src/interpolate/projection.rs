//! The local L² projection of a field, cell by cell.

use crate::Error;
use crate::field::Evaluate;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::simplex::Bernstein;
use crate::spaces::{ReggeSpace, edge_components};
use nalgebra::DMatrix;

/// The L² projection of the edge components on each cell onto P_r, its integrals by one rule.
///
/// With as many points as dim P_r it interpolates there.
#[derive(Clone, Debug)]
pub(super) struct LocalProjection {
    rule: Rule,
    basis: Bernstein,
    matrix: DMatrix<f64>,
}

impl LocalProjection {
    /// Onto the polynomials of degree r on a simplex of dimension N by a rule.
    ///
    /// # Errors
    /// If the rule is one of another dimension or has too few points.
    pub(super) fn by<const N: usize>(rule: Rule, degree: usize) -> Result<Self, Error> {
        if rule.points().vertices() != N + 1 {
            let reason = format!(
                "a rule for simplices of {} vertices cannot project on those of {}",
                rule.points().vertices(),
                N + 1
            );
            return Err(Error::Input(reason));
        }
        let basis = Bernstein::new(N + 1, degree);
        let matrix = projection_matrix(&basis, &rule)?;
        Ok(Self {
            rule,
            basis,
            matrix,
        })
    }

    /// Coefficients of the projections of all edge components on all cells: `[cell][edge][α]`.
    pub(super) fn project<const N: usize, G: Evaluate<f64, N>>(
        &self,
        space: &ReggeSpace<N>,
        g: &G,
    ) -> Vec<Vec<f64>> {
        let table = g.tabulate(self.rule.points());
        let mut all = Vec::with_capacity(space.mesh().cell_count());
        let on_cell = |cell: usize| {
            let local = g.on_cell(cell);
            self.coefficients(N, |q| edge_components(&g.value(&local, &table, q)))
        };
        in_order(space.mesh().cell_count(), on_cell, |_, local| {
            all.push(local);
        });
        all
    }

    /// `[edge][α]` on one n-simplex, from the edge components at the q-th point.
    fn coefficients(&self, n: usize, at: impl Fn(usize) -> Vec<f64>) -> Vec<f64> {
        let size = self.basis.len();
        let mut coefficients = vec![0.0; n * (n + 1) / 2 * size];
        for q in 0..self.rule.len() {
            for (e, c) in at(q).into_iter().enumerate() {
                for a in 0..size {
                    coefficients[e * size + a] += self.matrix[(a, q)] * c;
                }
            }
        }
        coefficients
    }
}

/// M with c_α = Σ_q M_αq f(λ_q) the discrete L² projection: (∫ B_α B_β)⁻¹ B_β(λ_q) w_q, integrals by the same rule.
pub(super) fn projection_matrix(basis: &Bernstein, rule: &Rule) -> Result<DMatrix<f64>, Error> {
    let too_few = || {
        let (points, unknowns) = (rule.len(), basis.len());
        Error::Input(format!(
            "{points} points cannot determine {unknowns} coefficients"
        ))
    };
    if rule.len() < basis.len() {
        // Rounding may hide that the matrix is singular.
        return Err(too_few());
    }
    let table = basis.tabulate::<f64>(rule.points());
    let values = DMatrix::from_fn(basis.len(), rule.len(), |a, q| table[q][a]);
    let weighted = DMatrix::from_fn(basis.len(), rule.len(), |a, q| {
        table[q][a] * rule.weights()[q]
    });
    let gram = &values * weighted.transpose();
    gram.lu().solve(&weighted).ok_or_else(too_few)
}

//! The local L² projection of a field, cell by cell.

use crate::Error;
use crate::field::{Evaluate, TensorField};
use crate::parallel::rows_in_order;
use crate::quadrature::Rule;
use crate::scalar::Real;
use crate::simplex::{Bernstein, edges_of};
use crate::spaces::{ReggeSpace, add_edge_components};
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
    pub(super) fn project<const N: usize, G: TensorField<N, Scalar = f64>>(
        &self,
        space: &ReggeSpace<N>,
        g: &G,
    ) -> Vec<Vec<f64>> {
        self.project_in::<G::Wide, G, N>(space, g)
    }

    fn project_in<T: Real<Sum = f64>, G: Evaluate<T, N>, const N: usize>(
        &self,
        space: &ReggeSpace<N>,
        g: &G,
    ) -> Vec<Vec<f64>> {
        let table = g.tabulate(self.rule.points());
        let vertices: Vec<usize> = (0..=N).collect();
        let (edges, matrix) = (edges_of(&vertices), self.matrix_blocks::<T>());
        let on_cell = |cell: usize, row: &mut [f64], sums: &mut Vec<T>| {
            let local = g.on_cell(cell);
            sums.clear();
            sums.resize(row.len(), T::zero());
            for (block, column) in matrix.iter().enumerate() {
                add_edge_components(&g.value(&local, &table, block), &edges, column, sums);
            }
            for (entry, sum) in row.iter_mut().zip(sums) {
                *entry = sum.reduce();
            }
        };
        let (cells, width) = (space.mesh().cell_count(), edges.len() * self.basis.len());
        let mut all = Vec::with_capacity(cells);
        rows_in_order(cells, width, 0.0, Vec::new, on_cell, |_, row| {
            all.push(row.to_vec());
        });
        all
    }

    /// M by blocks of the rule's points: `[block][α]`; lanes beyond the last point are 0.
    fn matrix_blocks<T: Real>(&self) -> Vec<Vec<T>> {
        let (size, points) = self.matrix.shape();
        let entry = |a: usize, q: usize| if q < points { self.matrix[(a, q)] } else { 0.0 };
        let column = |block: usize| {
            (0..size)
                .map(|a| T::pack(|lane| entry(a, block * T::LANES + lane)))
                .collect()
        };
        (0..points.div_ceil(T::LANES)).map(column).collect()
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

//! Floor 7. R_h^(q): the L²(Ω, g_h)-projection of the distributional curvature onto Lagrange functions.
//!
//! u ∈ V_h with ∫ u v ω(g_h) = ⟨(Rω)_dist(g_h), v⟩ for all v ∈ V_h, Lagrange functions of degree q. Paper: section 1.
//! The paper's functional is defined for v that vanish on ∂Ω, and so is u; with the boundary terms of
//! [`boundary_curvature`](crate::functional::boundary_curvature) all of the Lagrange space may be taken.

use crate::Error;
use crate::field::Evaluate;
use crate::linalg::inverse_and_det;
use crate::norm::factor::Factor;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::spaces::Lagrange;
use faer::sparse::linalg::cholesky::SymmetricOrdering;

/// The test functions of a projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tested {
    /// Those that vanish on the boundary.
    Interior,
    /// All.
    All,
}

/// The mass matrix of a Lagrange space in L²(Ω, g), factorised.
#[derive(Debug)]
pub struct Projection {
    /// The functions that are unknowns.
    unknowns: Vec<usize>,
    len: usize,
    /// None where there is no unknown.
    factor: Option<Factor>,
}

impl Projection {
    /// The projection in the metric g, integrals by a rule on cells.
    ///
    /// # Errors
    /// If memory does not suffice, or g is not positive definite at the points of the rule.
    pub fn new<const N: usize, G: Evaluate<f64, N>>(
        g: &G,
        space: &Lagrange<N>,
        tested: Tested,
        rule: &Rule,
    ) -> Result<Self, Error> {
        let kept = |dof: &usize| tested == Tested::All || space.vanishes_on_boundary(*dof);
        let unknowns: Vec<usize> = (0..space.len()).filter(kept).collect();
        let factor = match unknowns.is_empty() {
            true => None,
            false => {
                let mass = Mass::new(g, space, &unknowns, rule);
                let order = SymmetricOrdering::Amd;
                Some(Factor::of(&mass.columns, &mass.rows, &mass.values, order)?)
            }
        };
        Ok(Self {
            unknowns,
            len: space.len(),
            factor,
        })
    }

    /// The coefficients of u from ⟨f, v⟩ for every basis function v; 0 where v is not tested.
    pub fn apply(&self, load: &[f64]) -> Vec<f64> {
        let mut x: Vec<f64> = self.unknowns.iter().map(|&dof| load[dof]).collect();
        if let Some(factor) = &self.factor {
            factor.solve(&mut x);
        }
        let mut coefficients = vec![0.0; self.len];
        for (&dof, x) in self.unknowns.iter().zip(x) {
            coefficients[dof] = x;
        }
        coefficients
    }
}

/// The upper triangle of ∫ v_i v_j ω in compressed columns.
struct Mass {
    columns: Vec<usize>,
    rows: Vec<usize>,
    values: Vec<f64>,
}

/// No unknown.
const NONE: u32 = u32::MAX;

impl Mass {
    fn new<const N: usize, G: Evaluate<f64, N>>(
        g: &G,
        space: &Lagrange<N>,
        unknowns: &[usize],
        rule: &Rule,
    ) -> Self {
        let mut number = vec![NONE; space.len()];
        for (i, &dof) in unknowns.iter().enumerate() {
            number[dof] = i as u32;
        }
        let mut mass = Self::pattern(space, &number, unknowns.len());
        let (table, basis) = (
            g.tabulate(rule.points()),
            space.basis(N).tabulate::<f64>(rule.points()),
        );
        let size = basis[0].len();
        let on_cell = |cell: usize| {
            let local = g.on_cell(cell);
            let mut matrix = vec![0.0; size * size];
            for (q, weight) in rule.weights().iter().enumerate() {
                let (_, det) = inverse_and_det(&g.value(&local, &table, q));
                let scale = det.sqrt() * weight;
                for i in 0..size {
                    for j in 0..size {
                        matrix[i * size + j] += scale * basis[q][i] * basis[q][j];
                    }
                }
            }
            matrix
        };
        let mut dofs = Vec::with_capacity(size);
        in_order(space.mesh().cell_count(), on_cell, |cell, matrix| {
            dofs.clear();
            dofs.extend(space.cell_dofs(cell).map(|dof| number[dof]));
            mass.add(&dofs, &matrix);
        });
        mass
    }

    /// All pairs of unknowns that share a cell.
    fn pattern<const N: usize>(space: &Lagrange<N>, number: &[u32], len: usize) -> Self {
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        for cell in 0..space.mesh().cell_count() {
            let dofs = || space.cell_dofs(cell).map(|dof| number[dof]);
            for column in dofs().filter(|&c| c != NONE) {
                pairs.extend(dofs().filter(|&r| r <= column).map(|row| (column, row)));
            }
        }
        pairs.sort_unstable();
        pairs.dedup();
        let mut columns = vec![0; len + 1];
        for &(column, _) in &pairs {
            columns[column as usize + 1] += 1;
        }
        for i in 0..len {
            columns[i + 1] += columns[i];
        }
        Self {
            columns,
            values: vec![0.0; pairs.len()],
            rows: pairs.into_iter().map(|(_, row)| row as usize).collect(),
        }
    }

    /// Adds a cell's matrix.
    fn add(&mut self, dofs: &[u32], matrix: &[f64]) {
        for (j, &column) in dofs.iter().enumerate().filter(|(_, c)| **c != NONE) {
            let range = self.columns[column as usize]..self.columns[column as usize + 1];
            for (i, &row) in dofs.iter().enumerate().filter(|(_, r)| **r <= column) {
                // The pattern has every pair of a cell.
                if let Ok(at) = self.rows[range.clone()].binary_search(&(row as usize)) {
                    self.values[range.start + at] += matrix[i * dofs.len() + j];
                }
            }
        }
    }
}

//! From a field to a Regge function: the canonical interpolant, and two ways to average a local L² projection.

use super::{Canonical, ReggeFunction, ReggeSpace, check_positive, edge_components, hierarchical};
use crate::Error;
use crate::field::TensorField;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::simplex::{Bernstein, subsets};
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
    fn project<const N: usize, G: TensorField<f64, N>>(
        &self,
        space: &ReggeSpace<'_, N>,
        g: &G,
    ) -> Result<Vec<Vec<f64>>, Error> {
        let basis = Bernstein::new(N + 1, space.degree);
        let matrix = projection_matrix(&basis, &self.rule)?;
        let table = g.tabulate(self.rule.points());
        let edges = subsets(N + 1, 2).len();
        let mut all = Vec::with_capacity(space.mesh.cells());
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
        in_order(space.mesh.cells(), on_cell, |_, local| all.push(local));
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

/// How a Regge metric is made from a metric.
#[derive(Clone, Debug)]
pub enum Interpolant {
    /// The canonical degrees of freedom agree, integrated by rules of this order.
    Canonical {
        /// Exactness of the rules.
        order: usize,
    },
    /// The paper's appendix: local L² projection, canonical degrees of freedom averaged.
    Average(Projection),
    /// What the printed tables used: local L² projection, coefficients averaged in a hierarchical basis of edge,
    /// face and cell functions; those that belong to one cell are kept. Another interpolant for every r ≥ 1.
    AverageHierarchical(Projection),
}

impl Interpolant {
    /// The Regge function of this space.
    ///
    /// # Errors
    /// If g or the interpolant is not positive definite at the points of a rule of order 2r + 2 (named by cell and
    /// point), or the projection's rule has too few points.
    pub fn apply<'s, const N: usize, G: TensorField<f64, N>>(
        &self,
        space: &'s ReggeSpace<'s, N>,
        g: &G,
    ) -> Result<ReggeFunction<'s, f64, N>, Error> {
        let points = Rule::new(N, 2 * space.degree + 2);
        check_positive(g, space.mesh, points.points())?;
        let coefficients = match self {
            Self::Canonical { order } => {
                let canonical = Canonical::new(space);
                canonical.solve(&canonical.evaluate(g, *order))
            }
            Self::Average(projection) => average_canonical(space, projection.project(space, g)?),
            Self::AverageHierarchical(projection) => {
                hierarchical::average(space, projection.project(space, g)?)?
            }
        };
        let function = space.function(coefficients)?;
        function.check_positive(points.points())?;
        Ok(function)
    }
}

/// ℓ_i averaged over the cells that share it. Paper: appendix.
fn average_canonical<const N: usize>(space: &ReggeSpace<'_, N>, cells: Vec<Vec<f64>>) -> Vec<f64> {
    let canonical = Canonical::new(space);
    let mut values = vec![0.0; space.len()];
    let mut shares = vec![0.0; space.len()];
    let of_cell = |cell: usize| {
        let mut list = Vec::with_capacity(cells[cell].len());
        canonical.of_cell(cell, &cells[cell], |dof, value| list.push((dof, value)));
        list
    };
    in_order(cells.len(), of_cell, |_, list| {
        for (dof, value) in list {
            values[dof] += value;
            shares[dof] += 1.0;
        }
    });
    for (value, share) in values.iter_mut().zip(shares) {
        *value /= share;
    }
    canonical.solve(&values)
}

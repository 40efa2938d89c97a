//! Floor 5. From a field to a Regge function: the canonical interpolant, the geodesic one, and two ways to average a
//! local L² projection.

mod canonical;
mod geodesic;
mod hierarchical;
mod projection;

pub use canonical::Canonical;
pub use geodesic::{geodesic_interpolant, geodesic_length};
pub use projection::Projection;

use crate::Error;
use crate::field::Evaluate;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::spaces::{ReggeFunction, ReggeSpace, check_positive};

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
    pub fn apply<const N: usize, G: Evaluate<f64, N>>(
        &self,
        space: &ReggeSpace<N>,
        g: &G,
    ) -> Result<ReggeFunction<f64, N>, Error> {
        let points = Rule::new(N, 2 * space.degree() + 2);
        check_positive(g, space.mesh(), points.points())?;
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
fn average_canonical<const N: usize>(space: &ReggeSpace<N>, cells: Vec<Vec<f64>>) -> Vec<f64> {
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

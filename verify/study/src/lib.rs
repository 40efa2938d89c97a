//! Convergence studies: one helper for every dimension, degree, interpolant, metric and quantity.
//!
//! A [`Study`] says what is to be computed and [`Study::run`] computes it, row by row. Nothing is printed here: an
//! observer is told what goes on.

mod fit;
mod interpolation;
mod memory;
mod named;
pub mod printed;
mod printed_rules;
mod quantity;
mod report;
mod row;
mod rules;
mod run;

pub use fit::{Fit, fits};
pub use interpolation::{Interpolation, ProjectionKind};
pub use named::Named;
pub use printed_rules::printed_rule;
pub use quantity::Quantity;
pub use report::{Make, Report};
pub use row::{ROUNDING, Row, observed_order};
pub use rules::{
    LoadQuadrature, Orders, Quadrature, QuadratureReport, StudyRules, converged_order,
};
pub use run::{Event, Failure, Phase, mesh, mesh_seed};

use regge_curvature::Error;
use regge_curvature::metrics::Metric;

/// One mesh with one polynomial degree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Case {
    /// r.
    pub degree: usize,
    /// k: the cube is cut into 2^k cubes a side before it is cut into simplices.
    pub level: u32,
}

/// What is to be computed.
#[derive(Clone, Debug)]
pub struct Study {
    /// The smooth metric g on the cube (−1, 1)^N.
    pub metric: Metric,
    /// N: 2 or 3.
    pub dimension: usize,
    /// What is measured in H⁻².
    pub quantity: Quantity,
    /// How g_h is made; each case is computed for all of them on the same mesh.
    pub interpolants: Vec<Interpolation>,
    /// The local L² projection inside the averages.
    pub projection: ProjectionKind,
    /// The rules by which the functionals and the norm are integrated.
    pub quadrature: Quadrature,
    /// Where the random meshes come from.
    pub seed: u64,
    /// The cases, in the order in which they are computed.
    pub cases: Vec<Case>,
}

/// The largest degree r that a study accepts: beyond, Bernstein's basis costs the accuracy that r should buy.
pub const LARGEST_DEGREE: usize = 8;

impl Study {
    /// The largest level k in a dimension: 2·4^11 triangles, 6·8^7 tetrahedra.
    pub fn largest_level(dimension: usize) -> u32 {
        if dimension == 2 { 11 } else { 7 }
    }

    /// Can the study be computed at all?
    ///
    /// # Errors
    /// Says what cannot.
    pub fn check(&self) -> Result<(), Error> {
        let refuse = |reason: String| Err(Error::Input(reason));
        if !(2..=3).contains(&self.dimension) {
            return refuse(format!(
                "dimension {}: the H⁻² norm is for 2 and 3",
                self.dimension
            ));
        }
        if self.interpolants.is_empty() || self.cases.is_empty() {
            return refuse("nothing to compute: no interpolant, degree or level".into());
        }
        self.cases
            .iter()
            .try_for_each(|&case| self.check_case(case))
    }

    fn check_case(&self, case: Case) -> Result<(), Error> {
        let largest = Self::largest_level(self.dimension);
        let reason = if case.level > largest {
            let n = self.dimension;
            format!(
                "level {} is too fine: {largest} is the finest in dimension {n}",
                case.level
            )
        } else if case.degree > LARGEST_DEGREE {
            format!(
                "degree {} is too high: {LARGEST_DEGREE} is the highest",
                case.degree
            )
        } else if case.degree > 0 && self.interpolants.contains(&Interpolation::Geodesic) {
            format!("the geodesic interpolant has degree 0, not {}", case.degree)
        } else {
            return Ok(());
        };
        Err(Error::Input(reason))
    }

    /// How much a case is to do, roughly and in no unit: cells times the entries of a cell's matrix.
    pub fn work(&self, case: Case) -> u64 {
        let (factorial, shape) = if self.dimension == 2 { (2, 2) } else { (6, 4) };
        let cells = factorial << (self.dimension as u32 * case.level);
        let local = (case.degree as u64 + 2) * (case.degree as u64 + 3) * shape;
        cells * local * local
    }
}

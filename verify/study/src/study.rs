//! What is to be computed, and whether it can be.

use crate::case::Case;
use crate::projection::ProjectionKind;
use crate::quantity::Quantity;
use crate::rules::Quadrature;
use regge_curvature::Error;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Metric;

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
    pub interpolants: Vec<Interpolant>,
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
        } else {
            let mut all = self.interpolants.iter();
            return all.try_for_each(|interpolant| interpolant.check_degree(case.degree));
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

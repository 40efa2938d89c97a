//! What `--certified` adds to a metric of any degree above 0: bounds that hold at every point of a simplex.

use super::enclosed::{Bounds, bounds};
use super::given::{Given, Phase};
use super::{CurvatureError, failed};
use regge_curvature::functional::enclosed_curvature;
use regge_curvature::scalar::Interval;
use serde::Serialize;

/// Bounds of R, ⟦H⟧ and Θ over whole simplices. That there are any says that the metric is positive definite everywhere.
#[derive(Clone, Debug, Serialize)]
pub struct Everywhere {
    /// R by cell, in the order of the file; null where no bounds were found.
    pub cells: Vec<Option<Bounds>>,
    /// All faces of the mesh.
    pub faces: Vec<SimplexBounds>,
    /// All hinges of the mesh.
    pub hinges: Vec<SimplexBounds>,
}

/// ⟦H⟧ on a face, Θ at a hinge.
#[derive(Clone, Debug, Serialize)]
pub struct SimplexBounds {
    /// Its vertices.
    pub vertices: Vec<u32>,
    /// Is it inside? On the boundary the jump is H from the one side that there is, and the defect π − Σθ.
    pub interior: bool,
    /// The bounds; null where none were found.
    pub bounds: Option<Bounds>,
}

/// On how many simplices a number is positive everywhere, negative everywhere, or neither is known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Signs {
    /// Positive everywhere.
    pub positive: usize,
    /// Negative everywhere.
    pub negative: usize,
    /// Neither is known.
    pub unknown: usize,
}

impl Signs {
    /// Of these bounds.
    pub fn of<'a>(all: impl Iterator<Item = &'a Option<Bounds>>) -> Self {
        let mut signs = Self::default();
        for bounds in all {
            match bounds {
                Some([low, _]) if *low > 0.0 => signs.positive += 1,
                Some([_, high]) if *high < 0.0 => signs.negative += 1,
                _ => signs.unknown += 1,
            }
        }
        signs
    }
}

/// Of the metric that is given.
pub(super) fn everywhere<const N: usize>(
    given: &Given<'_, N>,
    phase: Phase<'_>,
) -> Result<Everywhere, CurvatureError> {
    phase("bounding the curvature everywhere");
    let mesh = given.g_h.space().mesh();
    let all = enclosed_curvature(&given.g_h).map_err(failed)?;
    let on = |k: usize, found: &[Interval]| {
        let of = |(simplex, x): (usize, &Interval)| SimplexBounds {
            vertices: mesh.vertices(k, simplex).to_vec(),
            interior: mesh.is_interior(k, simplex),
            bounds: defined(*x),
        };
        found.iter().enumerate().map(of).collect()
    };
    Ok(Everywhere {
        cells: all.scalar.iter().copied().map(defined).collect(),
        faces: on(N - 1, &all.jumps),
        hinges: on(N - 2, &all.defects),
    })
}

fn defined(x: Interval) -> Option<Bounds> {
    (!x.low().is_nan()).then(|| bounds(x))
}

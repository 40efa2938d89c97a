//! A curve of the paper, with the mesh sizes of its table.

use crate::quantity::Quantity;
use crate::row::observed_order;

/// One curve of a figure of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Series {
    /// The figure's label in the paper's source.
    pub label: &'static str,
    /// Its entry in the legend.
    pub legend: &'static str,
    /// N.
    pub dimension: usize,
    /// r.
    pub degree: usize,
    /// What is plotted.
    pub quantity: Quantity,
    /// Is it the curve of the canonical interpolant?
    pub canonical: bool,
    /// The level of the first point.
    pub first_level: u32,
    /// (ndof, H⁻² norm) by level.
    pub points: &'static [(usize, f64)],
}

/// h by level. Source: tab:error_N2.
pub const MESH_SIZE_2: [f64; 8] = [
    2.828, 1.534, 8.584e-1, 4.609e-1, 2.417e-1, 1.251e-1, 6.260e-2, 3.198e-2,
];

/// h by level. Source: tab:error_N3.
pub const MESH_SIZE_3: [f64; 7] = [
    3.464, 1.850, 9.709e-1, 4.999e-1, 2.753e-1, 1.358e-1, 6.878e-2,
];

impl Series {
    /// The printed norm of a level.
    pub fn error(&self, level: u32) -> Option<f64> {
        let index = level.checked_sub(self.first_level)? as usize;
        self.points.get(index).map(|point| point.1)
    }

    /// The printed order of a level: the tables have orders, made with the printed mesh sizes; the plots have none.
    pub fn order(&self, level: u32) -> Option<f64> {
        if self.quantity != Quantity::CurvatureError {
            return None;
        }
        observed_order(self.point(level.checked_sub(1)?)?, self.point(level)?)
    }

    /// The mesh size of the tables and the printed norm.
    pub fn point(&self, level: u32) -> Option<(f64, f64)> {
        let h: &[f64] = if self.dimension == 2 {
            &MESH_SIZE_2
        } else {
            &MESH_SIZE_3
        };
        Some((*h.get(level as usize)?, self.error(level)?))
    }
}

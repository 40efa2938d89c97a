//! Floor 5. Sparse symmetric positive definite systems: upper triangles in compressed columns, and their factorisation.
//!
//! A matrix is assembled from those of cells, in the cells' order, by [`Upper`]; [`Factor`] solves with it. The H⁻² norm
//! and the projection R_h stand on both.

mod factor;
mod upper;

pub(crate) use factor::{Factor, Order, in_parallel};
pub(crate) use upper::{CellBlock, Upper};

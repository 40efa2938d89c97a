//! Floor 5. Sparse symmetric positive definite systems: upper triangles in compressed columns, and their factorisation.
//!
//! A matrix is assembled from those of cells, in the cells' order, by [`Upper`]; [`Factor`] solves with it; [`Kept`] numbers its
//! unknowns where some are held. The norms and the projection R_h stand on them.

mod factor;
mod kept;
mod neighbours;
mod upper;

pub(crate) use factor::{Factor, Order, in_parallel};
pub(crate) use kept::Kept;
pub(crate) use neighbours::CellBlock;
pub(crate) use upper::Upper;

//! Floor 5. Sparse symmetric positive definite systems: lower triangles in compressed columns, and their factorisation.
//!
//! A matrix is assembled from those of cells, in the cells' order, by [`Lower`]; [`Factor`] solves with it; [`Kept`] numbers its
//! unknowns where some are held. The norms and the projection R_h stand on them.

mod analysis;
mod factor;
mod kept;
mod lower;
mod neighbours;

pub(crate) use factor::{Factor, in_parallel};
pub(crate) use kept::Kept;
pub(crate) use lower::Lower;
pub(crate) use neighbours::CellBlock;

use crate::Error;
use faer::dyn_stack::{MemBuffer, StackReq};
use faer::sparse::FaerError;

/// Memory that faer works in, of a system of so many unknowns.
fn memory(unknowns: usize, need: StackReq) -> Result<MemBuffer, Error> {
    MemBuffer::try_new(need).map_err(|_| refused(unknowns, FaerError::OutOfMemory))
}

/// What faer refuses.
fn refused(unknowns: usize, error: FaerError) -> Error {
    match error {
        FaerError::IndexOverflow => lower::too_large(unknowns),
        FaerError::OutOfMemory => Error::Solver(format!("{unknowns} unknowns: out of memory")),
        other => Error::Solver(format!("{unknowns} unknowns: {other}")),
    }
}

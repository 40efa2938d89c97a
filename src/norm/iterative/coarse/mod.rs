//! The coarse correction: tensor-product cubic splines on a lattice, about p of its cells to a box of the mesh's size.
//!
//! The correction is P C⁻¹ Pᵀ, P the transfer of a spline to the mesh's unknowns and C all but the form of Δ². On a cube the
//! splines are clamped and C is diagonal in the modes of one axis ([`modes`]). On any other domain they are all that meet the
//! mesh, cut off at ∂Ω by leaving out the unknowns there, and C is solved with by a cycle of its own ([`domain`]).

mod domain;
pub(super) mod lattice;
mod modes;
mod nodes;
mod patch;
mod slabs;
mod spline;
mod stencil;
mod transfer;

use super::skeleton::Skeleton;
use crate::Error;
use crate::norm::hhj::{Hhj, Size};
use domain::Levels;
use lattice::Lattice;
use modes::Diagonal;
use std::sync::Arc;
use stencil::Short;
use transfer::Transfer;

/// The coarse correction for one mesh and degree.
#[derive(Debug)]
pub(super) struct Coarse<const N: usize> {
    transfer: Transfer<N>,
    inverse: Inverse<N>,
}

/// C⁻¹.
#[derive(Debug)]
enum Inverse<const N: usize> {
    Cube(Diagonal<N>),
    Domain(Levels<N>),
}

impl<const N: usize> Coarse<N> {
    /// # Errors
    /// If the mesh has no points, and as [`Diagonal::new`] and [`Levels::new`].
    pub fn new(hhj: &Arc<Hhj<N>>, skeleton: &Arc<Skeleton>) -> Result<Self, Error> {
        let transfer = |grid| Transfer::new(hhj, skeleton, grid);
        if let Some(lattice) = Lattice::of(hhj.mesh()) {
            let (diagonal, grid) = Diagonal::new(&lattice, hhj.space().degree())?;
            return Ok(Self {
                transfer: transfer(grid),
                inverse: Inverse::Cube(diagonal),
            });
        }
        let transfer = transfer(domain::background(hhj)?);
        let inverse = Inverse::Domain(Levels::new(&transfer)?);
        Ok(Self { transfer, inverse })
    }

    /// How the mesh's unknowns are best smoothed around the correction: how many steps of Chebyshev's iteration, and the
    /// largest eigenvalue over the least that is smoothed.
    ///
    /// Measured on the cube: with two steps and 2 or 8 the iteration takes up to a fifth longer, and a third step saves next
    /// to nothing. Cells from elsewhere differ in size and shape, and their lattice is coarser: eight steps with 34 take 19 iterations
    /// for 34 with four and 12 on a ball of 31 611 tetrahedra, p = 3, and 15 for 23 on one of 153 475, p = 2. In the plane
    /// three take 24 for 35 on an L of 249 696 triangles and 0.84 of the time, four take as long as three.
    pub fn smoothing(&self) -> (usize, f64) {
        match self.inverse {
            Inverse::Cube(_) => (2, 4.0),
            Inverse::Domain(_) if N == 2 => (3, 8.0),
            Inverse::Domain(_) => (8, 34.0),
        }
    }

    /// z += P C⁻¹ Pᵀ r, weighted. Single precision has a narrow range: r should be of a size that is not far from one.
    pub fn add(&self, r: &[Short], z: &mut [Short]) {
        let mut spline = self.transfer.restrict(r);
        match &self.inverse {
            Inverse::Cube(diagonal) => diagonal.solve(&mut spline),
            Inverse::Domain(levels) => levels.solve(&mut spline),
        }
        self.transfer.prolong(&spline, z);
    }
}

/// The bytes of the splines' forms on a mesh with so many faces in ∂Ω that is no cube.
pub(super) fn memory(size: &Size, boundary: usize) -> f64 {
    domain::memory(size, boundary)
}

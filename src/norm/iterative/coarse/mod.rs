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
pub(super) use domain::Rooms;
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

    /// How many steps of smoothing around the correction are best.
    ///
    /// Measured: on the cube a third step saves next to nothing. Cells from elsewhere differ in size and shape, and their lattice is
    /// coarser: on a ball of 24 334 tetrahedra, p = 3, five, six, seven and eight steps take 23, 19, 16 and 15 iterations, and eight the
    /// least time. In the plane two take as many iterations as three on triangles by Gmsh. On triangles of a moved lattice, which
    /// are half as high for their size, two take 40 where four take 22, and about as long.
    pub fn smoothing(&self) -> usize {
        match self.inverse {
            Inverse::Domain(_) if N == 3 => 8,
            _ => 2,
        }
    }

    /// What [`Coarse::add`] works with.
    pub fn rooms(&self) -> Rooms<N> {
        match &self.inverse {
            Inverse::Cube(_) => Rooms::default(),
            Inverse::Domain(levels) => levels.rooms(),
        }
    }

    /// z += P C⁻¹ Pᵀ r, weighted. Single precision has a narrow range: r should be of a size that is not far from one.
    pub fn add(&self, r: &[Short], z: &mut [Short], rooms: &mut Rooms<N>) {
        let mut spline = self.transfer.restrict(r);
        match &self.inverse {
            Inverse::Cube(diagonal) => diagonal.solve(&mut spline),
            Inverse::Domain(levels) => levels.solve(&mut spline, rooms),
        }
        self.transfer.prolong(&spline, z);
    }
}

/// The bytes of the splines' forms on a mesh with so many faces in ∂Ω that is no cube.
pub(super) fn memory(size: &Size, boundary: usize) -> f64 {
    domain::memory(size, boundary)
}

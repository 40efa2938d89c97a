//! Section 5: the example, its meshes, the tables and the plots.

mod curvature;
mod meshes;
mod tables;

use crate::harness::Catalogue;
use crate::stage::{mesh, point};

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<const N: usize>(all: &mut Catalogue) {
    point::add::<curvature::N01, N>(all);
    point::add::<curvature::N02, N>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<const N: usize>(all: &mut Catalogue) {
    mesh::add::<meshes::N03, N>(all);
    mesh::add::<meshes::N04, N>(all);
    mesh::add::<tables::N05, N>(all);
}

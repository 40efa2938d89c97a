//! Section 4 and the appendix: inequalities, and the interpolants.

mod interpolants;
mod normals;
mod simplices;

use crate::harness::Catalogue;
use crate::stage::{mesh, point};

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<const N: usize>(all: &mut Catalogue) {
    point::add::<normals::I01, N>(all);
    point::add::<normals::I02, N>(all);
    point::add::<normals::I03, N>(all);
    point::add::<simplices::I18, N>(all);
    point::add::<simplices::I28, N>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<const N: usize>(all: &mut Catalogue) {
    mesh::add::<interpolants::I29, N>(all);
    mesh::add::<interpolants::InterpolantOracle, N>(all);
}

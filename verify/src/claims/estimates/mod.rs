//! Section 4 and the appendix: inequalities, and the interpolants.

mod interpolants;
mod normals;
mod simplices;

use crate::harness::Catalogue;
use crate::stage::{mesh, point};
use regge_curvature::formulas::Formulas;

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<K: Formulas, const N: usize>(all: &mut Catalogue) {
    point::add::<normals::I01, K, N>(all);
    point::add::<normals::I02, K, N>(all);
    point::add::<normals::I03, K, N>(all);
    point::add::<simplices::I18, K, N>(all);
    point::add::<simplices::I28, K, N>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<K: Formulas, const N: usize>(all: &mut Catalogue) {
    mesh::add::<interpolants::I29, K, N>(all);
    mesh::add::<interpolants::InterpolantOracle, K, N>(all);
}

//! Section 3.1: the first variation of the distributional scalar curvature.

mod defects;
mod segment;
mod simplex;
mod theorem;

use crate::harness::Catalogue;
use crate::stage::mesh;
use regge_curvature::formulas::Formulas;

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<K: Formulas, const N: usize>(all: &mut Catalogue) {
    mesh::add_evolution::<defects::M01, K, N>(all);
    mesh::add_evolution::<defects::M02, K, N>(all);
    mesh::add_evolution::<defects::M03, K, N>(all);
    mesh::add_evolution::<theorem::M05, K, N>(all);
    mesh::add::<segment::M06, K, N>(all);
    mesh::add::<segment::AtOneTime, K, N>(all);
    mesh::add_evolution::<simplex::M17, K, N>(all);
    mesh::add_evolution::<simplex::P04, K, N>(all);
}

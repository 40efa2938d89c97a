//! Section 3.1: the first variation of the distributional scalar curvature.

mod defects;
mod segment;
mod simplex;
mod theorem;

use crate::harness::Catalogue;
use crate::stage::mesh;

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<const N: usize>(all: &mut Catalogue) {
    mesh::add_evolution::<defects::M01, N>(all);
    mesh::add_evolution::<defects::M02, N>(all);
    mesh::add_evolution::<defects::M03, N>(all);
    mesh::add_evolution::<theorem::M05, N>(all);
    mesh::add::<segment::M06, N>(all);
    mesh::add::<segment::AtOneTime, N>(all);
    mesh::add_evolution::<simplex::M17, N>(all);
    mesh::add_evolution::<simplex::P04, N>(all);
}

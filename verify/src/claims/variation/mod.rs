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
    mesh::add_stretched::<defects::M01, 3, N>(all);
    mesh::add_stretched::<defects::M02, 3, N>(all);
    mesh::add_stretched::<defects::M03, 3, N>(all);
    mesh::add_evolution::<theorem::M05, N>(all);
    // Without quadrature's errors where the integrands are polynomials: where g is constant on cells.
    mesh::add_stretched::<theorem::M05, 1, N>(all);
    mesh::add::<segment::M06, N>(all);
    mesh::add::<segment::AtOneTime, N>(all);
    mesh::add_evolution::<simplex::M17, N>(all);
    mesh::add_evolution::<simplex::P04, N>(all);
}

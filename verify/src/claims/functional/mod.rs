//! Section 3: the distributional scalar curvature, and what it must satisfy.

mod bianchi;
mod definition;
mod gauge;
mod gauss_bonnet;
mod single_valued;
mod smooth;
mod traces;

use crate::harness::Catalogue;
use crate::stage::mesh::Stretched;
use crate::stage::{mesh, point};

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<const N: usize>(all: &mut Catalogue) {
    point::add::<single_valued::D13, N>(all);
    point::add::<single_valued::M20, N>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<const N: usize>(all: &mut Catalogue) {
    mesh::add::<smooth::D10, N>(all);
    mesh::add::<smooth::SmoothOracle, N>(all);
    mesh::add::<definition::D11, N>(all);
    mesh::add::<definition::FromFlat, N>(all);
    mesh::add::<traces::D14, N>(all);
    mesh::add::<gauss_bonnet::M15, N>(all);
    mesh::add_evolution::<gauss_bonnet::Unchanged, N>(all);
    mesh::add::<gauge::M16, N>(all);
    mesh::add::<gauge::Straight, N>(all);
    mesh::add::<bianchi::M18, N>(all);
    mesh::add::<bianchi::Invariance, N>(all);
    mesh::add::<single_valued::M20, N>(all);
    mesh::add::<Stretched<single_valued::M20, 3>, N>(all);
}

//! Section 3: the distributional scalar curvature, and what it must satisfy.

mod bianchi;
mod definition;
mod gauge;
mod gauss_bonnet;
mod single_valued;
mod smooth;
mod traces;

use crate::harness::Catalogue;
use crate::stage::{mesh, point};
use regge_curvature::formulas::Formulas;

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<K: Formulas, const N: usize>(all: &mut Catalogue) {
    point::add::<single_valued::D13, K, N>(all);
    point::add::<single_valued::M20, K, N>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<K: Formulas, const N: usize>(all: &mut Catalogue) {
    mesh::add::<smooth::D10, K, N>(all);
    mesh::add::<smooth::SmoothOracle, K, N>(all);
    mesh::add::<definition::D11, K, N>(all);
    mesh::add::<definition::FromFlat, K, N>(all);
    mesh::add::<traces::D14, K, N>(all);
    mesh::add::<gauss_bonnet::M15, K, N>(all);
    mesh::add_evolution::<gauss_bonnet::Unchanged, K, N>(all);
    mesh::add::<gauge::M16, K, N>(all);
    mesh::add::<gauge::Straight, K, N>(all);
    mesh::add::<bianchi::M18, K, N>(all);
    mesh::add::<bianchi::Invariance, K, N>(all);
    mesh::add::<single_valued::M20, K, N>(all);
}

//! Section 3.2: the distributional Einstein tensor, and Regge's action.

mod action;
mod closed;
mod constant;
mod hessian;
mod product;
mod surface;
mod trace;

pub(crate) use hessian::second_variation;

use crate::harness::Catalogue;
use crate::stage::{mesh, point};
use regge_curvature::formulas::Formulas;

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<K: Formulas, const N: usize>(all: &mut Catalogue) {
    point::add::<trace::M11, K, N>(all);
    point::add::<trace::M19, K, N>(all);
    point::add::<surface::M07, K, N>(all);
    point::add::<constant::M12, K, N>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<K: Formulas, const N: usize>(all: &mut Catalogue) {
    mesh::add::<surface::M07, K, N>(all);
    mesh::add_evolution::<closed::M08, K, N>(all);
    mesh::add::<closed::M09, K, N>(all);
    mesh::add::<mesh::ByPath<closed::Action>, K, N>(all);
    mesh::add_evolution::<product::M10, K, N>(all);
    mesh::add::<constant::M12, K, N>(all);
    mesh::add::<hessian::M13, K, N>(all);
    mesh::add::<hessian::FromFlat, K, N>(all);
    mesh::add::<action::M14, K, N>(all);
    mesh::add::<action::ActionOracle, K, N>(all);
    mesh::add::<trace::M19, K, N>(all);
}

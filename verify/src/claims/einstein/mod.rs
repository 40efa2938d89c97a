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
use crate::stage::mesh::Stretched;
use crate::stage::{mesh, point};

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<const N: usize>(all: &mut Catalogue) {
    point::add::<trace::M11, N>(all);
    point::add::<trace::M19, N>(all);
    point::add::<surface::M07, N>(all);
    point::add::<constant::M12, N>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<const N: usize>(all: &mut Catalogue) {
    mesh::add::<surface::M07, N>(all);
    mesh::add::<Stretched<surface::M07, 3>, N>(all);
    mesh::add_evolution::<closed::M08, N>(all);
    mesh::add::<closed::M09, N>(all);
    mesh::add::<mesh::ByPath<closed::Action>, N>(all);
    mesh::add_evolution::<product::M10, N>(all);
    mesh::add::<constant::M12, N>(all);
    mesh::add::<Stretched<constant::M12, 1>, N>(all);
    mesh::add::<hessian::M13, N>(all);
    mesh::add::<hessian::FromFlat, N>(all);
    mesh::add::<action::M14, N>(all);
    mesh::add::<Stretched<action::M14, 1>, N>(all);
    mesh::add::<action::ActionOracle, N>(all);
    mesh::add::<trace::M19, N>(all);
    mesh::add::<Stretched<trace::M19, 3>, N>(all);
}

//! Sections 2 and 3: conventions and definitions at a point, and curvatures that textbooks know.

mod closed_forms;
mod dihedral;
mod second_form;
mod sectional;
mod surface;
mod traces;

use crate::harness::Catalogue;
use crate::stage::point;

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<const N: usize>(all: &mut Catalogue) {
    point::add::<traces::D01, N>(all);
    point::add::<traces::D02, N>(all);
    point::add::<traces::I09, N>(all);
    point::add::<second_form::D03, N>(all);
    point::add::<second_form::D04, N>(all);
    point::add::<second_form::D07, N>(all);
    point::add::<second_form::D08, N>(all);
    point::add::<sectional::D15, N>(all);
    point::add::<surface::D05, N>(all);
    point::add::<surface::D06, N>(all);
    point::add::<surface::T02, N>(all);
    point::add::<dihedral::D09, N>(all);
    point::add::<dihedral::I20, N>(all);
    point::add::<closed_forms::O01, N>(all);
    point::add::<closed_forms::O02, N>(all);
    point::add::<closed_forms::O03, N>(all);
}

//! Sections 2 and 3: conventions and definitions at a point, and curvatures that textbooks know.

mod closed_forms;
mod dihedral;
mod second_form;
mod surface;
mod traces;

use crate::harness::Catalogue;
use crate::stage::point;
use regge_curvature::formulas::Formulas;

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<K: Formulas, const N: usize>(all: &mut Catalogue) {
    point::add::<traces::D01, K, N>(all);
    point::add::<traces::D02, K, N>(all);
    point::add::<traces::I09, K, N>(all);
    point::add::<second_form::D03, K, N>(all);
    point::add::<second_form::D04, K, N>(all);
    point::add::<second_form::D07, K, N>(all);
    point::add::<second_form::D08, K, N>(all);
    point::add::<surface::D05, K, N>(all);
    point::add::<surface::D06, K, N>(all);
    point::add::<surface::T02, K, N>(all);
    point::add::<dihedral::D09, K, N>(all);
    point::add::<dihedral::I20, K, N>(all);
    point::add::<closed_forms::O01, K, N>(all);
    point::add::<closed_forms::O02, K, N>(all);
    point::add::<closed_forms::O03, K, N>(all);
}

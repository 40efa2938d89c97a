//! Claims on meshes.

use super::Catalogue;
use regge::formulas::Formulas;

/// Adds them all, by the formulas K.
pub fn checks<K: Formulas>(_all: &mut Catalogue) {}

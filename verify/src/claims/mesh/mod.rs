//! Claims on meshes.
//!
//! Each file holds one claim or one family. [`setting`] has the meshes and the step from a claim to an entry of the
//! run, [`fields`] the random Regge metrics.

pub mod fields;
pub mod setting;
mod defects;
mod density;
mod parts;
mod variation;

use super::Catalogue;
use regge::formulas::Formulas;
use setting::{MeshCheck, OnMesh};

/// Adds them all, by the formulas K.
pub fn checks<K: Formulas>(all: &mut Catalogue) {
    checks_in::<K, 2>(all);
    checks_in::<K, 3>(all);
    checks_in::<K, 4>(all);
}

/// Adds a claim in dimension N, if it is meaningful there.
fn add<C: OnMesh, K: Formulas, const N: usize>(all: &mut Catalogue) {
    if !C::settings(N, false).is_empty() {
        all.push(Box::new(MeshCheck::<C, K, N>::default()));
    }
}

/// Adds those of dimension N.
pub fn checks_in<K: Formulas, const N: usize>(all: &mut Catalogue) {
    add::<defects::M01, K, N>(all);
    add::<defects::M02, K, N>(all);
    add::<defects::M03, K, N>(all);
    add::<parts::M04, K, N>(all);
    add::<variation::M05, K, N>(all);
    add::<parts::T03, K, N>(all);
    add::<parts::T04, K, N>(all);
}

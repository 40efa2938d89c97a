//! Claims on meshes.
//!
//! Each file holds one claim or one family. [`setting`] has the meshes and the step from a claim to an entry of the
//! run, [`fields`] the random Regge metrics.

mod bianchi;
mod closed;
mod constant;
mod defects;
mod density;
mod einstein;
mod euclid;
mod evolution;
pub mod fields;
mod gauge;
mod hessian;
mod homotopy;
mod invariance;
mod pair;
mod parts;
mod patch;
mod references;
pub mod setting;
mod simplex;
mod smooth;
mod spaces;
mod stokes;
mod tables;
mod traces;
mod variation;

use super::Catalogue;
use crate::claim::Record;
use evolution::{ByAd, ByPath, Evolution};
pub(crate) use hessian::second_variation;
use regge_curvature::formulas::Formulas;
use setting::{MeshCheck, OnMesh};

/// Those of claims that are checked at a point or by exact integrals as well.
pub(super) const M04_RECORD: Record = <parts::M04 as OnMesh>::RECORD;
pub(super) const M07_RECORD: Record = <einstein::M07 as OnMesh>::RECORD;
pub(super) const M12_RECORD: Record = <constant::M12 as OnMesh>::RECORD;
pub(super) const M19_RECORD: Record = <einstein::M19 as OnMesh>::RECORD;
pub(super) const M20_RECORD: Record = <traces::M20 as OnMesh>::RECORD;
pub(super) const T01_RECORD: Record = <stokes::T01 as OnMesh>::RECORD;
pub(super) const T03_RECORD: Record = <parts::T03 as OnMesh>::RECORD;
pub(super) const T04_RECORD: Record = <parts::T04 as OnMesh>::RECORD;

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

/// Adds a claim on d/dt by both methods.
fn both<C: Evolution, K: Formulas, const N: usize>(all: &mut Catalogue) {
    add::<ByAd<C>, K, N>(all);
    add::<ByPath<C>, K, N>(all);
}

/// Adds those of dimension N.
pub fn checks_in<K: Formulas, const N: usize>(all: &mut Catalogue) {
    add::<smooth::D10, K, N>(all);
    add::<references::SmoothOracle, K, N>(all);
    add::<references::D11, K, N>(all);
    add::<references::FromFlat, K, N>(all);
    add::<traces::D14, K, N>(all);
    both::<defects::M01, K, N>(all);
    both::<defects::M02, K, N>(all);
    both::<defects::M03, K, N>(all);
    add::<parts::M04, K, N>(all);
    both::<variation::M05, K, N>(all);
    add::<homotopy::M06, K, N>(all);
    add::<homotopy::AtOneTime, K, N>(all);
    add::<einstein::M07, K, N>(all);
    both::<closed::M08, K, N>(all);
    add::<closed::M09, K, N>(all);
    add::<ByPath<closed::Action>, K, N>(all);
    both::<einstein::M10, K, N>(all);
    add::<constant::M12, K, N>(all);
    add::<hessian::M13, K, N>(all);
    add::<hessian::FromFlat, K, N>(all);
    add::<constant::M14, K, N>(all);
    add::<references::ActionOracle, K, N>(all);
    add::<closed::M15, K, N>(all);
    both::<closed::Unchanged, K, N>(all);
    add::<gauge::M16, K, N>(all);
    add::<gauge::Straight, K, N>(all);
    both::<simplex::M17, K, N>(all);
    add::<bianchi::M18, K, N>(all);
    add::<invariance::Invariance, K, N>(all);
    add::<einstein::M19, K, N>(all);
    add::<traces::M20, K, N>(all);
    both::<simplex::P04, K, N>(all);
    add::<spaces::I29, K, N>(all);
    add::<references::InterpolantOracle, K, N>(all);
    add::<spaces::N03, K, N>(all);
    add::<spaces::N04, K, N>(all);
    add::<tables::N05, K, N>(all);
    add::<stokes::T01, K, N>(all);
    add::<parts::T03, K, N>(all);
    add::<parts::T04, K, N>(all);
}

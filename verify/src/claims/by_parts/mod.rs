//! Section 3.1: integration by parts, on meshes and exactly.

mod cell;
mod lemma;
mod stokes;

use crate::harness::Catalogue;
use crate::stage::{mesh, polynomial};
use regge_curvature::formulas::Formulas;

/// Adds those that are integrated exactly.
pub(super) fn exactly<K: Formulas>(all: &mut Catalogue) {
    polynomial::add::<stokes::T01, K, 2>(all);
    polynomial::add::<stokes::T01, K, 3>(all);
    polynomial::add::<cell::T03, K, 2>(all);
    polynomial::add::<cell::T03, K, 3>(all);
    polynomial::add::<lemma::T04, K, 2>(all);
    polynomial::add::<lemma::T04, K, 3>(all);
    // The denominators of more cells than three would need polynomials of very high degree.
    polynomial::add::<lemma::M04, K, 2>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<K: Formulas, const N: usize>(all: &mut Catalogue) {
    mesh::add::<stokes::T01, K, N>(all);
    mesh::add::<cell::T03, K, N>(all);
    mesh::add::<lemma::T04, K, N>(all);
    mesh::add::<lemma::M04, K, N>(all);
}

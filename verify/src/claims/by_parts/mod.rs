//! Section 3.1: integration by parts, on meshes and exactly.

mod cell;
mod lemma;
mod stokes;

use crate::harness::Catalogue;
use crate::stage::{mesh, polynomial};

/// Adds those that are integrated exactly.
pub(super) fn exactly(all: &mut Catalogue) {
    polynomial::add::<stokes::T01, 2>(all);
    polynomial::add::<stokes::T01, 3>(all);
    polynomial::add::<cell::T03, 2>(all);
    polynomial::add::<cell::T03, 3>(all);
    polynomial::add::<lemma::T04, 2>(all);
    polynomial::add::<lemma::T04, 3>(all);
    // The denominators of more cells than three would need polynomials of very high degree.
    polynomial::add::<lemma::M04, 2>(all);
}

/// Adds those on meshes, in dimension N.
pub(super) fn on_meshes<const N: usize>(all: &mut Catalogue) {
    mesh::add::<stokes::T01, N>(all);
    mesh::add::<cell::T03, N>(all);
    mesh::add::<lemma::T04, N>(all);
    mesh::add::<lemma::M04, N>(all);
}

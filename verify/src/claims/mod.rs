//! The catalogue.
//!
//! # How to add a claim
//!
//! *At a point.* Implement [`Pointwise`] for a unit type, in a file of its own or in that of its family: a
//! [`Record`](crate::claim::Record), and `equations`, which returns the named terms of both sides at one random
//! [`Instance`](crate::instance::Instance). Name it in [`pointwise`]. Dropped, flipped and doubled terms are forged
//! by the harness; add what can go wrong otherwise with `.forge(…)`.
//!
//! *On a mesh, or any other kind.* Implement [`Check`] for a type that knows its dimension and method: `run` makes
//! a [`Tally`](crate::claim::Tally), adds the equations of every case to it, and finishes it to an
//! [`Entry`](crate::report::Entry). Use [`Key::runner`](crate::claim::seed::Key::runner) for randomness, so that
//! the seed replays it, and put r and the mesh into the [`Case`](crate::claim::Case). Name it in [`mesh::checks`].

pub mod mesh;
mod scalar_curvature;

use crate::claim::{Check, Pointwise, PointwiseCheck};
use crate::exact::Fp;
use num_dual::Dual64;
use regge::formulas::{Formulas, Paper};
use regge::jet::Jet1;

/// The claims of the catalogue, in its order.
pub type Catalogue = Vec<Box<dyn Check>>;

/// All of them, by the formulas of the paper.
pub fn catalogue() -> Catalogue {
    let mut all = Catalogue::new();
    pointwise::<Paper, 2>(&mut all);
    pointwise::<Paper, 3>(&mut all);
    pointwise::<Paper, 4>(&mut all);
    pointwise::<Paper, 5>(&mut all);
    mesh::checks::<Paper>(&mut all);
    // Row by row; the dimensions and methods of one claim stay together.
    all.sort_by_key(|c| c.record().label);
    all
}

/// Adds a claim in dimension N by both methods, if it is meaningful there.
fn both<C: Pointwise, K: Formulas, const N: usize>(all: &mut Catalogue) {
    if !C::DIMENSIONS.contains(&N) {
        return;
    }
    all.push(Box::new(PointwiseCheck::<C, K, Dual64, N>::default()));
    if !C::BOUND {
        all.push(Box::new(PointwiseCheck::<C, K, Jet1<Fp, 1>, N>::default()));
    }
}

/// The claims that hold at a point, in dimension N, by the formulas K.
pub fn pointwise<K: Formulas, const N: usize>(all: &mut Catalogue) {
    both::<scalar_curvature::P01, K, N>(all);
    both::<scalar_curvature::P03, K, N>(all);
}

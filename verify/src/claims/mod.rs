//! The catalogue.
//!
//! # How to add a claim
//!
//! *At a point.* Implement [`Pointwise`] for a unit type, in a file of its own or in that of its family: a
//! [`Record`], and `equations`, which returns the named terms of both sides at one random
//! [`Instance`](crate::instance::Instance). Name it in [`pointwise`]. Dropped, flipped and doubled terms are forged
//! by the harness; add what can go wrong otherwise with `.forge(…)`.
//!
//! *On a mesh.* Implement [`OnMesh`](mesh::setting::OnMesh), or `Evolution` for a statement on d/dt, which then is
//! checked by AD and along finite paths; name it in [`mesh::checks_in`].
//!
//! *Any other kind.* Implement [`Check`] for a type that knows its dimension and method: `run` makes a
//! [`Tally`](crate::claim::Tally), adds the equations of every case to it, and finishes it to an
//! [`Entry`](crate::report::Entry). Use [`Key::runner`](crate::claim::seed::Key::runner) for randomness, so that
//! the seed replays it, and put r and the mesh into the [`Case`](crate::claim::Case).

pub mod mesh;

mod angle;
mod by_parts;
mod closed_forms;
mod connection;
mod densities;
mod density;
mod dihedral;
mod estimates;
mod frames;
mod mean_curvature;
mod normal;
mod scalar_curvature;
mod second_form;
mod simplices;
mod single_valued;
mod surface;
mod traces;
mod volume;

use crate::claim::{Check, Over, Pointwise, PointwiseCheck, Record};
use crate::exact::Fp;
use by_parts::{ByParts, ByPartsCheck};
use num_dual::Dual64;
use regge_curvature::formulas::{Formulas, Paper};
use regge_curvature::jet::Jet1;

/// The claims of the catalogue, in its order.
pub type Catalogue = Vec<Box<dyn Check>>;

/// All of them, by the formulas of the paper.
pub fn catalogue() -> Catalogue {
    let mut all = Catalogue::new();
    pointwise::<Paper, 2>(&mut all);
    // The unit tests of this crate do not run the catalogue: they are spared the compilation of the rest.
    #[cfg(not(test))]
    {
        pointwise::<Paper, 3>(&mut all);
        pointwise::<Paper, 4>(&mut all);
        pointwise::<Paper, 5>(&mut all);
        by_parts::<Paper>(&mut all);
        mesh::checks::<Paper>(&mut all);
    }
    // Row by row; the dimensions and methods of one claim stay together.
    all.sort_by_key(|c| c.record().label);
    all
}

/// What the pages say of each claim, in the order of the catalogue.
pub fn records() -> Vec<&'static Record> {
    let mut records: Vec<&'static Record> = catalogue().iter().map(|c| c.record()).collect();
    records.dedup_by_key(|r| r.label);
    records
}

/// Adds a claim in dimension N by both methods, if it is meaningful there.
fn both<C: Pointwise, K: Formulas, const N: usize>(all: &mut Catalogue) {
    if !C::DIMENSIONS.contains(&N) {
        return;
    }
    if C::OVER != Over::Integers {
        all.push(Box::new(PointwiseCheck::<C, K, Dual64, N>::default()));
    }
    if C::OVER != Over::Ordered {
        all.push(Box::new(PointwiseCheck::<C, K, Jet1<Fp, 1>, N>::default()));
    }
}

/// The claims that hold at a point, in dimension N, by the formulas K.
pub fn pointwise<K: Formulas, const N: usize>(all: &mut Catalogue) {
    both::<scalar_curvature::P01, K, N>(all);
    both::<scalar_curvature::P03, K, N>(all);
    both::<volume::P02, K, N>(all);
    both::<connection::P05, K, N>(all);
    both::<connection::P06, K, N>(all);
    both::<connection::I12, K, N>(all);
    both::<normal::P07, K, N>(all);
    both::<normal::P08, K, N>(all);
    both::<normal::P09, K, N>(all);
    both::<normal::D12, K, N>(all);
    both::<frames::P10, K, N>(all);
    both::<frames::P11, K, N>(all);
    both::<frames::P12, K, N>(all);
    both::<frames::P13, K, N>(all);
    both::<mean_curvature::P14, K, N>(all);
    both::<mean_curvature::P15, K, N>(all);
    both::<mean_curvature::P16, K, N>(all);
    both::<mean_curvature::P17, K, N>(all);
    both::<mean_curvature::P18, K, N>(all);
    both::<mean_curvature::P19, K, N>(all);
    both::<density::P20, K, N>(all);
    both::<density::P21, K, N>(all);
    both::<angle::P22, K, N>(all);
    both::<angle::P23, K, N>(all);
    both::<angle::P24, K, N>(all);
    both::<traces::D01, K, N>(all);
    both::<traces::D02, K, N>(all);
    both::<traces::I09, K, N>(all);
    both::<traces::M11, K, N>(all);
    both::<second_form::D03, K, N>(all);
    both::<second_form::D04, K, N>(all);
    both::<second_form::D07, K, N>(all);
    both::<second_form::D08, K, N>(all);
    both::<surface::D05, K, N>(all);
    both::<surface::D06, K, N>(all);
    both::<surface::T02, K, N>(all);
    both::<dihedral::D09, K, N>(all);
    both::<dihedral::I20, K, N>(all);
    both::<single_valued::D13, K, N>(all);
    both::<estimates::I01, K, N>(all);
    both::<estimates::I02, K, N>(all);
    both::<estimates::I03, K, N>(all);
    both::<simplices::I18, K, N>(all);
    both::<simplices::I28, K, N>(all);
    both::<closed_forms::N01, K, N>(all);
    both::<closed_forms::N02, K, N>(all);
    both::<closed_forms::O01, K, N>(all);
    both::<closed_forms::O02, K, N>(all);
    both::<closed_forms::O03, K, N>(all);
    both::<densities::M07, K, N>(all);
    both::<densities::M12, K, N>(all);
    both::<densities::M19, K, N>(all);
    both::<densities::M20, K, N>(all);
}

/// The claims that are integrated exactly, by the formulas K.
pub fn by_parts<K: Formulas>(all: &mut Catalogue) {
    exactly::<by_parts::T01, K>(all);
    exactly::<by_parts::T03, K>(all);
    exactly::<by_parts::T04, K>(all);
    // The denominators of more cells than three would need polynomials of very high degree.
    all.push(Box::new(ByPartsCheck::<by_parts::M04, K, 2>::default()));
}

fn exactly<C: ByParts, K: Formulas>(all: &mut Catalogue) {
    all.push(Box::new(ByPartsCheck::<C, K, 2>::default()));
    all.push(Box::new(ByPartsCheck::<C, K, 3>::default()));
}

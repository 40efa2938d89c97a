//! Floor 3 of the verification. The catalogue, by the sections of the paper.
//!
//! | folder | where in the paper |
//! |---|---|
//! | `conventions` | sections 2 and 3: traces, surfaces and angles at a point; textbook curvatures |
//! | `evolution` | section 2: how curvature, normals and angles change with the metric |
//! | `functional` | section 3, def:distcurv, and what the functional must satisfy |
//! | `by_parts` | section 3.1: Stokes' theorem and lemma:IBPdivdivS |
//! | `variation` | section 3.1: thm:distcurvdot and the steps to it |
//! | `einstein` | section 3.2: the distributional Einstein tensor and Regge's action |
//! | `estimates` | section 4 and the appendix: inequalities and interpolants |
//! | `numerical` | section 5: meshes, tables and plots |
//!
//! # How to add a claim
//!
//! *At a point.* Implement [`Pointwise`](crate::stage::point::Pointwise) for a unit type, in the folder of its section:
//! a [`Record`], and `equations`, which returns the named terms of both sides at one random
//! [`Instance`](crate::stage::point::Instance). Name it in the folder's `at_a_point`. Dropped, flipped and doubled terms
//! are forged by the harness; add what can go wrong otherwise with `.forge(…)`.
//!
//! *On a mesh.* Implement [`OnMesh`](crate::stage::mesh::OnMesh), or [`Evolution`](crate::stage::mesh::Evolution) for a
//! statement on d/dt, which then is checked by AD and along finite paths; name it in the folder's `on_meshes`.
//!
//! *Exactly, as an integral.* Implement [`ByParts`](crate::stage::polynomial::ByParts) and name it in the folder's
//! `exactly`.
//!
//! A claim that is checked in several ways is one type with several of these. Claims do not use each other: what several
//! of them compute belongs to the [`stage`](crate::stage).

mod by_parts;
mod conventions;
mod einstein;
mod estimates;
mod evolution;
mod functional;
mod numerical;
mod variation;

pub use crate::harness::Catalogue;
pub(crate) use einstein::second_variation;

use crate::harness::Record;

/// All of them.
pub fn catalogue() -> Catalogue {
    let mut all = Catalogue::new();
    at_a_point::<2>(&mut all);
    // The unit tests of this crate do not run the catalogue: they are spared the compilation of the rest.
    #[cfg(not(test))]
    {
        at_a_point::<3>(&mut all);
        at_a_point::<4>(&mut all);
        at_a_point::<5>(&mut all);
        exactly(&mut all);
        on_meshes::<2>(&mut all);
        on_meshes::<3>(&mut all);
        on_meshes::<4>(&mut all);
    }
    // Row by row; the dimensions and methods of one claim stay together.
    all.sort_by_key(|c| c.record.label);
    all
}

/// What the pages say of each claim, in the order of the catalogue.
pub fn records() -> Vec<&'static Record> {
    let mut records: Vec<&'static Record> = catalogue().iter().map(|c| c.record).collect();
    records.dedup_by_key(|r| r.label);
    records
}

/// Adds the claims that hold at a point, in dimension N.
pub fn at_a_point<const N: usize>(all: &mut Catalogue) {
    conventions::at_a_point::<N>(all);
    evolution::at_a_point::<N>(all);
    functional::at_a_point::<N>(all);
    einstein::at_a_point::<N>(all);
    estimates::at_a_point::<N>(all);
    numerical::at_a_point::<N>(all);
}

/// Adds the claims that are integrated exactly.
pub fn exactly(all: &mut Catalogue) {
    by_parts::exactly(all);
}

/// Adds the claims on meshes, in dimension N.
pub fn on_meshes<const N: usize>(all: &mut Catalogue) {
    functional::on_meshes::<N>(all);
    by_parts::on_meshes::<N>(all);
    variation::on_meshes::<N>(all);
    einstein::on_meshes::<N>(all);
    estimates::on_meshes::<N>(all);
    numerical::on_meshes::<N>(all);
}

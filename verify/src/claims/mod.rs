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
//! How to add one is in docs/how-to/claim.md. Claims do not use each other: what several of them compute belongs to the
//! [`stage`](crate::stage).

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
    let mut all = at_a_point();
    all.extend(exactly());
    all.extend(on_meshes());
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

/// The claims that hold at a point.
pub fn at_a_point() -> Catalogue {
    let mut all = Catalogue::new();
    add_at_a_point::<2>(&mut all);
    add_at_a_point::<3>(&mut all);
    add_at_a_point::<4>(&mut all);
    add_at_a_point::<5>(&mut all);
    all
}

/// The claims that are integrated exactly.
pub fn exactly() -> Catalogue {
    let mut all = Catalogue::new();
    by_parts::exactly(&mut all);
    all
}

/// The claims on meshes.
pub fn on_meshes() -> Catalogue {
    let mut all = Catalogue::new();
    add_on_meshes::<2>(&mut all);
    add_on_meshes::<3>(&mut all);
    add_on_meshes::<4>(&mut all);
    all
}

fn add_at_a_point<const N: usize>(all: &mut Catalogue) {
    conventions::at_a_point::<N>(all);
    evolution::at_a_point::<N>(all);
    functional::at_a_point::<N>(all);
    einstein::at_a_point::<N>(all);
    estimates::at_a_point::<N>(all);
    numerical::at_a_point::<N>(all);
}

fn add_on_meshes<const N: usize>(all: &mut Catalogue) {
    functional::on_meshes::<N>(all);
    by_parts::on_meshes::<N>(all);
    variation::on_meshes::<N>(all);
    einstein::on_meshes::<N>(all);
    estimates::on_meshes::<N>(all);
    numerical::on_meshes::<N>(all);
}

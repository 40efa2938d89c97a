//! Floor 4 of the verification. What a run found: data, tables, pages.

mod chart;
mod formula;
mod html;
mod page;
mod summary;

pub use crate::harness::{Entry, Failure, Forgery, Vacuous, Verdict};
pub use html::document;
pub use page::{Page, pages};
pub use summary::Row;

use serde::Serialize;

/// The whole run.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The version of this package.
    pub version: String,
    /// The revision of the sources, if whoever runs the catalogue fills it in; else `unknown`.
    pub revision: String,
    /// The seed that all randomness comes from.
    pub seed: u64,
    /// One entry for each claim, dimension and method.
    pub claims: Vec<Entry>,
}

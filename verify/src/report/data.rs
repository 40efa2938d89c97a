//! The whole run, as data.

use crate::harness::Entry;
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

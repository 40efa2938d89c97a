//! What users bring along: formulas, metrics, meshes and tables of edge lengths, read from files.
//!
//! Nothing that stands in a file is trusted: every refusal is one line that says what, where and, if it is not plain,
//! what to do. Memory is bounded by the size of the file, not by the counts that it states.

mod error;
pub mod expression;
mod lengths;
pub mod mesh;
pub mod metric;
pub mod trial;

pub use error::{InputError, Place};
pub use lengths::read_lengths;

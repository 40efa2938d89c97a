//! Enclosures: classical Regge calculus with proven digits, and curvature of any degree bounded over whole simplices.

mod bound;
mod boxes;
mod curvature;
mod lengths;
mod metric;
mod polynomial;

pub use curvature::{EnclosedCurvature, enclosed_curvature};
pub use lengths::{Enclosed, enclosed};
pub use metric::proven_metric;

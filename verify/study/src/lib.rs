//! Convergence studies: one helper for every dimension, degree, interpolant, metric and quantity.
//!
//! A [`Study`] says what is to be computed and [`Study::run`] computes it, row by row. Nothing is printed here: an
//! observer is told what goes on.
//!
//! What has no mesh (rows, fits, reports, rules, the loop over cases) knows no dimension at compile time; what has one
//! is behind one trait (`case_mesh.rs`).

mod case;
mod case_mesh;
mod event;
mod fit;
mod memory;
mod named;
mod pace;
pub mod printed;
mod printed_rules;
mod projection;
mod quantity;
mod report;
mod row;
mod rules;
mod run;
mod study;

pub use case::Case;
pub use case_mesh::{mesh, mesh_seed};
pub use event::{Event, Failure, Phase};
pub use fit::{Fit, fits, slope};
pub use named::Named;
pub use pace::Pace;
pub use printed_rules::printed_rule;
pub use projection::ProjectionKind;
pub use quantity::Quantity;
pub use report::{Make, Report};
pub use row::{ROUNDING, Row, observed_order};
pub use rules::{
    LoadQuadrature, Orders, Quadrature, QuadratureReport, StudyRules, converged_order,
};
pub use study::{LARGEST_DEGREE, Study};

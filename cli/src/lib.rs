//! Behind the command line `regge`: input files, curvature of what they hold, pictures.
//!
//! The claims are in `regge-catalogue`, the studies in `regge-study`.

pub mod curvature;
pub mod map;
pub mod plot;
pub mod vtu;

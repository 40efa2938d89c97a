//! Behind the command line `regge`: input files, curvature of what they hold, pictures.
//!
//! The readers of the files are `regge-readers`, the studies `regge-study`, the claims `regge-verify`.

pub mod curvature;
pub mod map;
pub mod npz;
pub mod plot;
pub mod ply;
mod svg;
pub mod vtu;

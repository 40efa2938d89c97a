//! x
pub mod curvature;
pub mod input;
pub mod plot;
pub mod printed;
pub mod study;

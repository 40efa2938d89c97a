//! x
pub mod plot;
pub mod printed;
pub mod study;

//! The catalogue of claims: every statement of the paper as a test that can fail.
//!
//! [`run()`] checks all of them and yields a [`Report`](report::Report). See [`claims`] for how to add one.

pub mod claim;
pub mod claims;
pub mod exact;
pub mod instance;
pub mod report;
mod run;

pub use run::{Options, Progress, UnknownLabel, run, run_catalogue};

//! The sceptic's half of `regge`: the catalogue of claims.
//!
//! [`run()`] checks every claim and yields a [`Report`](report::Report). See [`claims`] for how to add one.

pub mod claim;
pub mod claims;
pub mod errata;
pub mod exact;
pub mod exact_rule;
pub mod instance;
pub mod report;
mod run;

pub use run::{Options, Progress, UnknownLabel, run, run_catalogue};

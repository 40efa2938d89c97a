//! The sceptic's half of `regge`: the catalogue of claims, and the studies that reproduce the paper's tables.
//!
//! [`run()`] checks every claim and yields a [`Report`](report::Report). See [`claims`] for how to add one.

pub mod claim;
pub mod claims;
pub mod curvature;
pub mod errata;
pub mod exact;
pub mod exact_rule;
pub mod input;
pub mod instance;
pub mod oracle;
pub mod plot;
pub mod printed;
pub mod report;
mod run;
pub mod study;

pub use run::{Options, Progress, UnknownLabel, run, run_catalogue};

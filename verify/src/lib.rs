//! The sceptic's half of `regge-curvature`: the catalogue of claims.
//!
//! [`run()`] checks every claim and yields a [`Report`](report::Report). See [`claims`] for how to add one.
//!
//! | floor | module | what is there |
//! |---|---|---|
//! | 0 | [`exact`], [`paper`] | a prime field, and integrals over it; the paper's labels and statements |
//! | 1 | [`harness`] | equations, forgeries, checks as data, one entry of the report |
//! | 2 | [`stage`] | instances, fields, meshes, and what several claims compute |
//! | 3 | [`claims`] | the claims, by the sections of the paper |
//! | 4 | [`report`] | tables and pages |
//! | 5 | [`run()`], [`errata`], [`certificates`] | the catalogue, run; what it proves, for another judge |

pub mod certificates;
pub mod claims;
pub mod errata;
pub mod exact;
pub mod harness;
pub mod paper;
pub mod report;
mod run;
pub mod stage;

pub use run::{Options, Progress, UnknownLabel, run, run_catalogue};

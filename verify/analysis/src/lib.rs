//! What the analysis of the paper asserts about constants and convergence, measured and judged.
//!
//! A [`Claim`] is measured as a list of [`Finding`]s: a series of numbers over levels with a rule by which it is judged,
//! and wrong versions that the same rule must catch. An upper bound is judged from one side: by the best constant, which must
//! not grow, or by the fitted order, which must not fall short.
//!
//! | floor | module | what is there |
//! |---|---|---|
//! | 0 | [`series`], [`best`], [`local`] | numbers over levels; best constants by Cholesky; basis functions at points |
//! | 1 | [`finding`], [`pieces`], [`represent`], [`measures`], [`splines`] | rules and verdicts; a mesh cell by cell; functions by coefficients; fixed sets; functions of H²_0 |
//! | 2 | [`norms`], [`distance`], [`projected`], [`mollified`], [`families`], [`claim`] | the norms of section 4; g_h − g; R_h − R; metrics that are smooth near a hinge; meshes and metrics; what a claim is |
//! | 3 | [`claims`] | the claims |
//! | 4 | [`report`] | table, pages, pictures |
//! | 5 | [`run()`] | the claims, run |

pub mod best;
pub mod claim;
pub mod claims;
pub mod distance;
pub mod families;
pub mod finding;
pub mod local;
pub mod measures;
pub mod mollified;
pub mod norms;
pub mod pieces;
pub mod projected;
pub mod report;
pub mod represent;
mod run;
pub mod series;
pub mod splines;

pub use claim::{Claim, Effort};
pub use finding::{Caught, Entry, Finding, Rule};
pub use run::{is_called, run};

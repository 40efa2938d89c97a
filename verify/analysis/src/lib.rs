//! What the analysis of the paper asserts about constants and convergence, measured and judged.
//!
//! A [`Claim`] is measured as a list of [`Finding`]s: a series of numbers over levels with a rule by which it is judged,
//! and wrong versions that the same rule must catch. An upper bound is judged from one side: by the best constant, which must
//! not grow, or by the fitted order, which must not fall short.
//!
//! | floor | module | what is there |
//! |---|---|---|
//! | 0 | [`series`], [`best`], [`local`], [`delaunay`], [`fields`] | numbers over levels; best constants by Cholesky; basis functions at points; Delaunay's triangulation; metrics by formulas |
//! | 1 | [`rule`], [`finding`], [`pieces`], [`represent`], [`measures`], [`splines`], [`bubble`] | what can be claimed; verdicts; a mesh cell by cell; functions by coefficients; fixed sets; functions of H²_0, and one of them |
//! | 2 | [`norms`], [`distance`], [`projected`], [`mollified`], [`families`], [`claim`] | the norms of section 4; g_h − g; R_h − R; metrics that are smooth near a hinge; meshes and Regge metrics; what a claim is |
//! | 3 | [`errors`], [`on_mesh`] | the error of the curvature and the right side of thm:conv; splines on a mesh |
//! | 4 | [`claims`] | the claims |
//! | 5 | [`report`] | table, pages, pictures, labels |
//! | 6 | [`run()`] | the claims, run |

pub mod best;
pub mod bubble;
pub mod claim;
pub mod claims;
pub mod delaunay;
pub mod distance;
pub mod errors;
pub mod families;
pub mod fields;
pub mod finding;
pub mod local;
pub mod measures;
pub mod mollified;
pub mod norms;
pub mod on_mesh;
pub mod pieces;
pub mod projected;
pub mod report;
pub mod represent;
pub mod rule;
mod run;
pub mod series;
pub mod splines;

pub use claim::{Claim, Effort};
pub use finding::{Caught, Entry, Finding};
pub use rule::Rule;
pub use run::{is_called, run};

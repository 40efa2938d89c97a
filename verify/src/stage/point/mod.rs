//! Random instances: a moving metric, fields, and hypersurfaces, by their jets at one point.
//!
//! An instance is a fixed number of random numbers, arranged. They shrink towards zero: the metric towards ½ δ, all
//! fields towards 0.

mod claim;
mod draw;
mod frame;
mod instance;
mod reduced;
mod scene;

pub use claim::{Over, Pointwise, add};
pub use frame::{Frame, orthonormal};
pub use instance::{Instance, along, derivative, still_jet, sum};
pub use scene::{Face, Scene, divergence_terms, mean_curvature_density};

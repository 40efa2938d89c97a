//! Fields on meshes: random Regge functions, smooth metrics, and what is made of them.

mod patch;
mod regge;
mod seen;
mod tangent;
mod test_function;

pub use patch::Patch;
pub use regge::{Regge, combination, flat, function, metric, moving, near_flat, variation, wild};
pub use seen::{Seen, both_sides, integral, points_of};
pub use tangent::{Tangent, value_only};
pub use test_function::test_function;

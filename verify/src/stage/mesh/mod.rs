//! Claims on meshes: where they are tried, and the sums that they are about.

mod cases;
mod claim;
mod evolution;
mod pair;
mod reasons;
mod shapes;
mod sums;
mod terms;

pub use cases::{QUADRATURE, ROUNDING, at_points, everywhere, on_one_simplex, orders};
pub use claim::{OnMesh, Stretched, add};
pub use evolution::{
    ByPath, Evolution, Moving, POINTS_IN_T, add_evolution, add_stretched, too_few,
};
pub use pair::{Pair, Where, spaces};
pub use reasons::{FLAT, NO_G, NO_II, POINTS};
pub use shapes::torn;
pub use sums::{Tested, Three, minus, rates, times, values};
pub use terms::{FaceTerms, HingeTerms, div_div, opposite, outward_of_face};

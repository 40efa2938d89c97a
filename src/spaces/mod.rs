//! Floor 5. Finite element spaces: Lagrange functions and Regge metrics of any degree in any dimension, and the metrics of
//! surfaces and solids that are given by points.

mod basis;
#[cfg(feature = "serde")]
mod document;
mod function;
mod immersion;
mod lagrange;
mod regge;
mod test;

pub use basis::BasisFunction;
pub(crate) use function::add_edge_components;
pub use function::{ReggeFunction, check_positive};
pub use immersion::{Immersed, Immersion};
pub use lagrange::Lagrange;
pub(crate) use regge::slots_on as regge_slots;
pub use regge::{ReggeSpace, dofs_per_simplex};
pub use test::{Indicators, Scalar, Symmetric, TestSpace, Trace, Value};

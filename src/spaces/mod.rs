//! Floor 5. Finite element spaces: Lagrange functions and Regge metrics of any degree in any dimension.

mod basis;
#[cfg(feature = "serde")]
mod document;
mod function;
mod lagrange;
mod regge;
mod test;

pub use basis::BasisFunction;
pub(crate) use function::add_edge_components;
pub use function::{ReggeFunction, check_positive};
pub use lagrange::Lagrange;
pub(crate) use regge::slots_on as regge_slots;
pub use regge::{ReggeSpace, dofs_per_simplex};
pub use test::{Indicators, Scalar, Symmetric, TestSpace, Trace, Value};

//! Floor 5. Finite element spaces: Lagrange functions and Regge metrics of any degree in any dimension.

mod basis;
#[cfg(feature = "serde")]
mod document;
mod lagrange;
mod regge;
mod test;

pub use basis::BasisFunction;
pub use lagrange::Lagrange;
pub use regge::{ReggeFunction, ReggeSpace, check_positive, dofs_per_simplex};
pub(crate) use regge::{edge_components, slots_on as regge_slots};
pub use test::{Indicators, Scalar, Symmetric, TestSpace, Trace, Value};

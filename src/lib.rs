//! x
pub mod error;
pub mod jet;
pub mod lagrange;
pub mod linalg;
pub mod mesh;
#[cfg(feature = "norms")]
pub mod norm;
pub mod quadrature;
pub mod scalar;
pub mod simplex;

pub use error::Error;

//! x
pub mod error;
pub mod jet;
pub mod lagrange;
pub mod linalg;
pub mod mesh;
pub mod quadrature;
pub mod scalar;
pub mod simplex;

pub use error::Error;

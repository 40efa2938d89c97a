//! x
pub mod error;
pub mod field;
pub mod formulas;
pub mod functional;
pub mod hinge;
pub mod hypersurface;
pub mod jet;
pub mod lagrange;
pub mod linalg;
pub mod mesh;
pub mod metrics;
#[cfg(feature = "norms")]
pub mod norm;
mod parallel;
pub mod quadrature;
pub mod regge;
pub mod riemann;
pub mod scalar;
pub mod simplex;
pub mod smooth;

pub use error::Error;

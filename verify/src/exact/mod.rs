//! Floor 0 of the verification. A prime field, over which the library's formulas are exact, and exact integrals over it.

mod field;
mod rule;

pub use field::Fp;
pub use rule::on_simplex;

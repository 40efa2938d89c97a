//! Floor 0 of the verification. Prime fields, over which the library's formulas are exact, exact integrals over them, and the
//! programs that the formulas are.

mod field;
mod program;
mod rule;

pub use field::{Fp, Fq, Modular};
pub use program::{Degrees, Program, Recorded, Step, degrees, record};
pub use rule::on_simplex;

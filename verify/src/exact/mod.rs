//! Floor 0 of the verification. Prime fields, over which the library's formulas are exact, exact integrals over them, and the
//! programs that the formulas are, with the points that determine what they compute.

mod field;
mod lattice;
mod program;
mod rational;
mod rule;

pub use field::{Fp, Fq, Modular};
pub use lattice::{Sparse, determining, positive};
pub use program::{Degrees, MultiDegree, Program, Recorded, Step, degrees, record, supports};
pub use rational::Ratio;
pub use rule::on_simplex;

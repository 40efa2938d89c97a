//! What the library is compared with: geometry by another route, and the numbers of another code.

mod euclid;
mod minor;
mod oracle;

pub use euclid::{FlatHinge, against_hats, hinges};
pub use minor::leading_minor;
pub use oracle::{FEW, NGSOLVE, case_of, cases};

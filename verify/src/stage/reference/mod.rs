//! What the library is compared with: geometry by another route, and the numbers of another code.

mod euclid;
mod oracle;

pub use euclid::{FlatHinge, against_hats, hinges};
pub use oracle::{FEW, NGSOLVE, case_of, cases};

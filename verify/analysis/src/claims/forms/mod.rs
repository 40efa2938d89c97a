//! Section 4: the norms, the two forms, and the lemmas about them.

mod a_form;
mod b_form;
mod conforming;
mod jumps;
mod point;
mod segment;
mod steps;
mod trace;

pub use a_form::{A05, A07};
pub use b_form::{A01, A02, A03};
pub use conforming::A34;
pub use jumps::{A06, A18};
pub use point::{A09, A10, A11};
pub use segment::{A04, A19};
pub use steps::A35;
pub use trace::{A12, A13};

//! thm:conv, cor:conv and remark:suboptimal: the error of the curvature, its norm, and what it is made of.

mod attained;
mod hminus2;
mod hoelder;
mod meshes;
mod open;
mod rates;
mod terms;

pub use attained::A22;
pub use hminus2::{A30, A31};
pub use hoelder::A36;
pub use meshes::{A37, A38};
pub use open::{A39, A40};
pub use rates::{A20, A21};
pub use terms::{A23, A24};

//! One case of a check: its seed, its random numbers, its mesh.

mod draw;
mod seed;
mod setting;

pub use draw::Draw;
pub use seed::Key;
pub use setting::{Setting, Shape, grid};

//! The commands for meshes from files.

pub mod action;
pub mod curvature;
pub mod einstein;
mod files;
mod given;
mod memory;
mod simplices;

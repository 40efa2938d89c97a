//! Meshes, spaces, kernels and functionals, as one program: what is generic is compiled once for all of its files.
//!
//! `cargo test -p regge-curvature --test geometry exactness` runs one of them.

mod action;
mod common;
mod conventions;
mod exactness;
mod field;
mod lagrange;
mod mesh;
mod oracle;
mod pointwise;
mod quadrature;
mod regge;
mod regular;
mod scalars;
mod threads;

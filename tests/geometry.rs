//! Meshes, spaces, kernels and functionals, as one program: what is generic is compiled once for all of its files.
//!
//! `cargo test -p regge-curvature --test geometry exactness` runs one of them.

mod action;
mod common;
mod conventions;
mod documents;
mod enclosed;
mod evaluation;
mod everywhere;
mod exactness;
mod field;
mod immersion;
mod interpolate;
mod lagrange;
mod mesh;
mod oracle;
mod parts;
mod pointwise;
#[cfg(feature = "norms")]
mod projection;
mod quadrature;
mod regge;
mod regular;
mod rounding;
mod scalars;
mod threads;
mod tolerances;
mod variation;

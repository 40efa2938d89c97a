//! What needs the norm of H⁻², as one program: what is generic is compiled once for all of its files.
//!
//! `cargo test -p regge-curvature --test norms convergence` runs one of them.

mod common;
mod convergence;
mod domains;
mod norm;
mod norm_domains;
mod norm_iterative;
mod norm_riesz;
mod oracle_norms;
mod quadrature_order;

//! Polynomial fields on simplices over the prime fields, and exact integrals of what is made of them.
//!
//! The metric is g = LLᵀ with L unipotent and affine, which is curved and has det g = 1; v = (∏_F q_F)² w, q_F = ν·g⁻¹ν,
//! clears the denominators. Every integrand is then a polynomial and is integrated exactly over F_p.

mod claim;
mod fields;
mod integrals;
mod roots;

pub use claim::{ByParts, add};
pub use integrals::{Exactly, OnFace, add_up, poison, poisoned};

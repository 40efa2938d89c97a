//! Floor 4. The claims, by what they are about.

mod convergence;
mod earlier;
mod forms;
mod heuristics;
mod interpolation;
mod measures;

use crate::claim::Claim;

/// All of them, in the order of their labels.
pub const ALL: &[Claim] = &[
    forms::A01,
    forms::A02,
    forms::A03,
    forms::A04,
    forms::A05,
    forms::A06,
    forms::A07,
    forms::A09,
    forms::A10,
    forms::A11,
    forms::A12,
    forms::A13,
    interpolation::A14,
    interpolation::A15,
    interpolation::A16,
    interpolation::A17,
    forms::A18,
    forms::A19,
    convergence::A20,
    convergence::A21,
    convergence::A22,
    convergence::A23,
    convergence::A24,
    measures::A25,
    earlier::A26,
    earlier::A27,
    earlier::A28,
    earlier::A29,
    convergence::A30,
    convergence::A31,
    heuristics::A32,
    heuristics::A33,
    forms::A34,
    forms::A35,
    convergence::A36,
    convergence::A37,
    convergence::A38,
    convergence::A39,
    convergence::A40,
];

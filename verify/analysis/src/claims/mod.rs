//! Floor 3. The claims, by what they are about.

mod a_form;
mod b_form;
mod conforming;
mod earlier;
mod heuristics;
mod hminus2;
mod interpolation;
mod jumps;
mod measures;
mod meshes;
mod open;
mod point;
mod rates;
mod segment;
mod terms;
mod trace;

use crate::claim::Claim;

/// All of them, in the order of their labels.
pub const ALL: &[Claim] = &[
    b_form::A01,
    b_form::A02,
    b_form::A03,
    segment::A04,
    a_form::A05,
    jumps::A06,
    a_form::A07,
    point::A09,
    point::A10,
    point::A11,
    trace::A12,
    trace::A13,
    interpolation::A14,
    interpolation::A15,
    interpolation::A16,
    interpolation::A17,
    jumps::A18,
    segment::A19,
    rates::A20,
    rates::A21,
    rates::A22,
    terms::A23,
    terms::A24,
    measures::A25,
    earlier::A26,
    earlier::A27,
    earlier::A28,
    earlier::A29,
    hminus2::A30,
    hminus2::A31,
    heuristics::A32,
    heuristics::A33,
    conforming::A34,
    conforming::A35,
    conforming::A36,
    meshes::A37,
    meshes::A38,
    open::A39,
    open::A40,
];

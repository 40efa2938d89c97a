//! Floor 3. The claims, by what they are about.

mod a_form;
mod b_form;
mod interpolation;
mod jumps;
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
];

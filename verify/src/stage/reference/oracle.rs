//! The reference cases that NGSolve computed, as settings.

use crate::harness::{Judgement, Setting, Shape};
use regge_oracle::Oracle;

/// NGSolve's differences leave errors of 1e-9 to 1e-7 of an entry; a third code agrees to 1e-9 of the largest.
pub const NGSOLVE: Judgement = Judgement::Rounding { tolerance: 1e-8 };
/// Why a claim against them has few cases.
pub const FEW: &str = "there are ten reference cases";

/// The reference cases, some of them.
pub fn cases(dimension: usize, quick: bool, wanted: fn(&Oracle) -> bool) -> Vec<Setting> {
    let all = regge_oracle::numbers(dimension).into_iter();
    let kept = all.take(if quick { 3 } else { 5 });
    kept.filter(|&i| wanted(&regge_oracle::case(i)))
        .map(|i| Setting::new(Shape::Oracle(i), 0, 20))
        .collect()
}

/// The case of a setting.
pub fn case_of(at: &Setting) -> Oracle {
    let Shape::Oracle(number) = at.shape else {
        panic!("these settings are reference cases")
    };
    regge_oracle::case(number)
}

//! From a lattice to one with boxes twice as large: a spline there is Σ_k w_k b_(2I−3+k) along each axis, w = (1 4 6 4 1)/8.

use super::super::patch::Patch;
use super::super::stencil::Short;
use crate::norm::iterative::number::Number;
use crate::parallel::for_chunks;
use std::borrow::Cow;

/// The two-scale relation.
const WEIGHTS: [f64; 5] = [0.125, 0.5, 0.75, 0.5, 0.125];

/// How many splines along an axis the coarser lattice has.
pub(super) fn halved(side: usize) -> usize {
    (side - 3).div_ceil(2) + 3
}

/// The fine splines, of `side`, that a coarse one is made of: the first, and the one behind the last.
pub(super) fn children(coarse: usize, side: usize) -> (usize, usize) {
    ((2 * coarse).saturating_sub(3), (2 * coarse + 2).min(side))
}

/// The weight of a child.
#[inline]
pub(super) fn weight(coarse: usize, fine: usize) -> f64 {
    WEIGHTS[fine + 3 - 2 * coarse]
}

/// The coarse splines that are made of some fine ones, `low` ≤ i < `high`.
fn parents(low: usize, high: usize) -> (usize, usize) {
    (low / 2, (high + 2) / 2 + 1)
}

/// One axis: the sums over the children of the coarse splines from `to.0` to `to.1`, of the numbers of the fine ones from
/// `from.0` to `from.1`; `inner` numbers belong to each.
fn gather<T: Number>(x: &[T], inner: usize, from: (usize, usize), to: (usize, usize), y: &mut [T]) {
    for coarse in to.0..to.1 {
        let y = &mut y[(coarse - to.0) * inner..][..inner];
        let (first, end) = children(coarse, from.1);
        for fine in first.max(from.0)..end {
            let weight = T::of(weight(coarse, fine));
            let x = &x[(fine - from.0) * inner..][..inner];
            for (y, x) in y.iter_mut().zip(x) {
                *y += weight * *x;
            }
        }
    }
}

/// The transpose of [`gather`] for all splines of an axis.
fn spread(x: &[Short], inner: usize, coarse: usize, fine: usize, y: &mut [Short]) {
    for (parent, x) in x.chunks_exact(inner).enumerate().take(coarse) {
        let (first, end) = children(parent, fine);
        for child in first..end {
            let weight = weight(parent, child) as Short;
            let y = &mut y[child * inner..][..inner];
            for (y, x) in y.iter_mut().zip(x) {
                *y += weight * x;
            }
        }
    }
}

/// The dual vector of the coarser lattice from that of the finer one.
pub(super) fn restrict<const N: usize>(x: &[Short], sides: &[usize; N]) -> Vec<Short> {
    let (mut x, mut inner) = (Cow::Borrowed(x), 1);
    for &side in sides {
        let coarse = halved(side);
        let outer = x.len() / (inner * side);
        let mut y = vec![0.0; inner * coarse * outer];
        for_chunks(&mut y, inner * coarse, |i, y| {
            let x = &x[i * inner * side..][..inner * side];
            gather(x, inner, (0, side), (0, coarse), y);
        });
        x = Cow::Owned(y);
        inner *= coarse;
    }
    x.into_owned()
}

/// The spline of the coarser lattice on the finer one.
pub(super) fn prolong<const N: usize>(mut x: Vec<Short>, sides: &[usize; N]) -> Vec<Short> {
    let mut inner = 1;
    for &side in sides {
        let coarse = halved(side);
        let outer = x.len() / (inner * coarse);
        let mut y = vec![0.0; inner * side * outer];
        for_chunks(&mut y, inner * side, |i, y| {
            let x = &x[i * inner * coarse..][..inner * coarse];
            spread(x, inner, coarse, side, y);
        });
        x = y;
        inner *= side;
    }
    x
}

/// The splines of the coarser lattice that a tensor on the finer one is handed on to.
pub(super) fn reduced_patch<const N: usize>(patch: &Patch<N>) -> Patch<N> {
    let ends = |axis: usize| parents(patch.low[axis], patch.high[axis]);
    Patch {
        low: std::array::from_fn(|axis| ends(axis).0),
        high: std::array::from_fn(|axis| ends(axis).1),
    }
}

/// A tensor on the finer lattice handed on: the numbers on [`reduced_patch`]. The last axis comes first: lines along the first one,
/// whose numbers are added up one by one, are fewer then.
pub(super) fn reduce<const N: usize>(patch: &Patch<N>, numbers: &[f64]) -> Vec<f64> {
    let (reduced, mut x) = (reduced_patch(patch), Cow::Borrowed(numbers));
    for axis in (0..N).rev() {
        let inner = patch.sides()[..axis].iter().product::<usize>();
        let from = (patch.low[axis], patch.high[axis]);
        let to = (reduced.low[axis], reduced.high[axis]);
        let (before, after) = (inner * (from.1 - from.0), inner * (to.1 - to.0));
        let mut y = vec![0.0; x.len() / before * after];
        for (x, y) in x.chunks_exact(before).zip(y.chunks_exact_mut(after)) {
            gather(x, inner, from, to, y);
        }
        x = Cow::Owned(y);
    }
    x.into_owned()
}

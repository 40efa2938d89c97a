//! The forms of cells near ∂Ω and of flat ones on the splines that they reach.

use super::super::patch::Patch;
use super::super::stencil::Short;
use crate::parallel::zeros;
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

/// The form of the splines that reach a cell: row i has the numbers from i on.
pub(super) struct CellForm<'a, const N: usize> {
    pub patch: Patch<N>,
    pub form: &'a mut [Short],
}

/// How many numbers the form has of a cell that reaches these splines.
pub(super) fn size<const N: usize>(patch: &Patch<N>) -> usize {
    patch.len().pow(2)
}

/// A place for the form of each cell, by what it reaches, one after the other in `numbers`, which grow if they have to. If these cells
/// are not the last, they are made for as many as there may be, once.
pub(super) fn places<'a, const N: usize>(
    patches: Vec<Patch<N>>,
    numbers: &'a mut Vec<Short>,
    are_last: bool,
) -> Vec<CellForm<'a, N>> {
    let wanted = patches.iter().map(size).sum();
    if numbers.len() < wanted {
        *numbers = zeros(wanted.max(if are_last { 0 } else { AT_ONCE }));
    }
    let mut rest = &mut numbers[..];
    let place = |patch: Patch<N>| {
        let (form, others) = std::mem::take(&mut rest).split_at_mut(size(&patch));
        rest = others;
        CellForm { patch, form }
    };
    patches.into_iter().map(place).collect()
}

/// How many numbers the cells' forms have that are there at a time, 8 MB of them: those of some 16 cells at p = 4 and of 130 at p = 2,
/// so that threads seldom wait for the last form.
pub(super) const AT_ONCE: usize = 1 << 21;

/// In how many strips a form is made: with four, 5/8 of a square are computed for the half that is wanted.
const STRIPS: usize = 4;

/// What a cell's form is made from.
#[derive(Default)]
pub(super) struct FormRoom {
    /// The cell's unknowns that are not on ∂Ω.
    pub kept: Vec<usize>,
    /// Of these: Rᵀ column by column, and P row by row.
    pub root: Vec<Short>,
    pub rows: Vec<Short>,
    /// (R P)ᵀ.
    product: Vec<Short>,
}

impl FormRoom {
    /// (R P)ᵀ R P: row i holds the entries from i on, and others before.
    pub fn gram(&mut self, columns: usize, form: &mut [Short]) {
        if self.kept.is_empty() {
            form.fill(0.0);
            return;
        }
        let outer = self.kept.len();
        let rank = self.root.len() / outer;
        let root = MatRef::from_column_major_slice(&self.root, outer, rank);
        // Row-major P is column-major Pᵀ.
        let rows = MatRef::from_column_major_slice(&self.rows, columns, outer);
        self.product.resize(columns * rank, 0.0);
        let half = MatMut::from_column_major_slice_mut(&mut self.product, columns, rank);
        matmul(half, Accum::Replace, rows, root, 1.0, Par::Seq);
        let half = MatRef::from_column_major_slice(&self.product, columns, rank);
        let strip = columns.div_ceil(STRIPS).max(1);
        for begin in (0..columns).step_by(strip) {
            let (width, rest) = (strip.min(columns - begin), columns - begin);
            let of_strip = &mut form[begin * columns..(begin + width) * columns];
            let of_strip = MatMut::from_column_major_slice_mut(of_strip, columns, width);
            let transposed = half.subrows(begin, width).transpose();
            matmul(
                of_strip.subrows_mut(begin, rest),
                Accum::Replace,
                half.subrows(begin, rest),
                transposed,
                1.0,
                Par::Seq,
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn patch(side: usize) -> Patch<2> {
        Patch {
            low: [0, 0],
            high: [side, side],
        }
    }

    /// Forms do not overlap, and there is room for one that is larger than all that are made at a time.
    #[test]
    fn there_is_room_for_every_form() {
        let mut numbers = Vec::new();
        let forms = places(vec![patch(3), patch(2)], &mut numbers, false);
        let lengths: Vec<usize> = forms.iter().map(|form| form.form.len()).collect();
        assert_eq!(lengths, [81, 16]);
        assert_eq!(numbers.len(), AT_ONCE);
        let large = patch(39);
        assert!(size(&large) > AT_ONCE);
        let forms = places(vec![large], &mut numbers, false);
        assert_eq!(forms[0].form.len(), size(&large));
        let mut numbers = Vec::new();
        places(vec![patch(3)], &mut numbers, true);
        assert_eq!(numbers.len(), 81);
    }
}

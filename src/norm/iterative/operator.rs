//! The condensed operator without a matrix: cell by cell Tᵀ B̂ᵀ (W ⊗ I) B̂ T, where only W (the cell's metric) and T
//! (the change of unknown on its faces) see the cell, and both are made anew from its shape each time.
//!
//! Cells are taken in batches, so that B̂ and B̂ᵀ are products of dense matrices; each batch writes to a place of its own,
//! and every simplex then adds up what its cells have for it, in their order: no bit depends on the threads.

use super::batch::CELLS;
use super::kernel::{Kernel, Work};
use super::number::Number;
use super::skeleton::Skeleton;
use super::width::by_width;
use crate::norm::hhj::Hhj;
use crate::parallel::for_chunks_in;
use std::ops::Range;
use std::sync::Arc;

/// The operator on the unknowns of a [`Skeleton`].
#[derive(Clone, Debug)]
pub(super) struct Operator<T, const N: usize> {
    pub hhj: Arc<Hhj<N>>,
    pub skeleton: Arc<Skeleton>,
    pub kernel: Kernel<T, N>,
}

/// In how many parts the cells are gone through, and how many batches a part has at least: few cells' results are little.
const PARTS: usize = 8;
const BATCHES: usize = 64;

impl<T: Number, const N: usize> Operator<T, N> {
    pub fn new(hhj: &Arc<Hhj<N>>, skeleton: &Arc<Skeleton>) -> Self {
        Self {
            hhj: hhj.clone(),
            skeleton: skeleton.clone(),
            kernel: Kernel::new(hhj, skeleton),
        }
    }

    /// How much room [`Operator::apply`] needs: for a part of the cells. (The cycle's operator, which is in a hurry, has one for all.)
    pub fn room(&self) -> usize {
        let batches = self.cells().div_ceil(CELLS).div_ceil(PARTS);
        (batches.max(BATCHES) * CELLS).min(self.cells()) * self.kernel.outer()
    }

    /// How many cells.
    pub fn cells(&self) -> usize {
        self.skeleton.order.cells.len()
    }

    /// The operations of [`Operator::apply`]: B̂ and B̂ᵀ without their zeros, twice W ⊗ I where there are bubbles, and T with Tᵀ.
    pub fn operations(&self) -> f64 {
        let (element, pairing) = (self.hhj.element(), &self.kernel.pairing);
        let rows = element.pairing.nrows();
        let bubbles = element.layout.bubbles;
        let weights = rows * element.pairs.len() * if bubbles > 0 { 2 } else { 1 };
        let slopes: usize = element.layout.faces.iter().map(Vec::len).sum();
        let products = pairing.len() + 2 * rows * bubbles;
        let cell = 4 * products + 2 * weights + 4 * slopes * (N + 2);
        cell as f64 * self.hhj.mesh().cell_count() as f64
    }

    /// y = S x for the Schur complement S of the bubbles. `room` is overwritten.
    pub fn apply(&self, x: &[T], y: &mut [T], room: &mut [T]) {
        y.fill(T::ZERO);
        self.add(T::ONE, x, y, room);
    }

    /// y += factor · S x. `room` is overwritten.
    fn add(&self, factor: T, x: &[T], y: &mut [T], room: &mut [T]) {
        self.in_parts(room, &|work, out| work.image(x, out), &mut |cells, room| {
            self.collect(cells, room, y, factor);
        });
    }

    /// `work` at all batches, with the place for their results, some cells' at a time; `take` is given these.
    fn in_parts(
        &self,
        room: &mut [T],
        work: &(dyn Fn(&mut Work<'_, T, N>, &mut [T]) + Sync),
        take: &mut dyn FnMut(Range<usize>, &[T]),
    ) {
        let outer = self.kernel.outer();
        let of_part = self.room() / outer;
        for begin in (0..self.cells()).step_by(of_part.max(1)) {
            let cells = begin..self.cells().min(begin + of_part);
            let room = &mut room[..cells.len() * outer];
            for_chunks_in(
                room,
                CELLS * outer,
                || Work::new(&self.kernel),
                |batch, out, at| {
                    at.turn_to(begin / CELLS + batch);
                    work(at, out);
                },
            );
            take(cells, room);
        }
    }

    /// y += factor · the sum over some cells, whose results are in `room`.
    pub fn collect(&self, cells: Range<usize>, room: &[T], y: &mut [T], factor: T) {
        let (skeleton, layout) = (&self.skeleton, self.hhj.layout());
        let outer = self.kernel.outer();
        let starts = |k: usize| -> Vec<usize> {
            let blocks = layout.blocks.iter().filter(|b| b.k == k);
            blocks.map(|b| b.start - layout.bubbles).collect()
        };
        let starts: Vec<_> = (0..skeleton.widths.len()).map(starts).collect();
        skeleton.by_pieces([y], |piece, [y]| {
            if piece.cells.end <= cells.start || cells.end <= piece.cells.start {
                return;
            }
            let (layer, starts) = (&skeleton.order.layers[piece.k], &starts[piece.k]);
            let width = skeleton.widths[piece.k];
            let simplices = piece.simplices.clone().zip(y.chunks_exact_mut(width));
            for (simplex, y) in simplices {
                let star = layer.star(simplex);
                let star = star.filter(|(cell, _)| cells.contains(cell));
                let parts = star.map(|(cell, which)| {
                    &room[(cell - cells.start) * outer + starts[which]..][..width]
                });
                by_width!(width, W => add_parts::<T, W>(y, factor, parts), else {
                    parts.for_each(|part| add_part(y, factor, part));
                });
            }
        });
    }
}

/// y += factor · part.
fn add_part<T: Number>(y: &mut [T], factor: T, part: &[T]) {
    for (y, x) in y.iter_mut().zip(part) {
        *y = y.plus_product(factor, *x);
    }
}

/// y += factor · the sum of the parts, one after the other, all of W numbers.
fn add_parts<'a, T: Number, const W: usize>(
    y: &mut [T],
    factor: T,
    parts: impl Iterator<Item = &'a [T]>,
) {
    let y: &mut [T; W] = y.try_into().expect("a simplex has so many");
    let mut sum = *y;
    for part in parts {
        let part: &[T; W] = part.try_into().expect("a simplex has so many");
        add_part(&mut sum, factor, part);
    }
    *y = sum;
}

/// What is done once a solution.
impl<const N: usize> Operator<f64, N> {
    /// y −= A_sb A_bb⁻¹ f_b: the bubbles' load handed on to the other unknowns.
    pub fn condense(&self, load: &[f64], y: &mut [f64], room: &mut [f64]) {
        let bend = |work: &mut Work<'_, f64, N>, out: &mut [f64]| {
            work.y.fill(0.0);
            work.bend(&|place| load[place]);
            work.unload(out);
        };
        self.in_parts(room, &bend, &mut |cells, room| {
            self.collect(cells, room, y, -1.0);
        });
    }

    /// Writes the bubbles A_bb⁻¹ (f_b − A_bs x) into a deflection's coefficients. `room` is overwritten.
    pub fn bubbles(&self, load: &[f64], x: &[f64], coefficients: &mut [f64], room: &mut [f64]) {
        let count = self.hhj.layout().bubbles;
        if count == 0 {
            return;
        }
        let solve = |work: &mut Work<'_, f64, N>, out: &mut [f64]| {
            work.load(x);
            work.bend(&|place| load[place]);
            out[..work.t.len()].copy_from_slice(&work.t);
        };
        let outer = self.kernel.outer();
        self.in_parts(room, &solve, &mut |cells, room| {
            for (i, cell) in cells.clone().enumerate() {
                let (batch, lane) = (i - i % CELLS, i % CELLS);
                let lanes = CELLS.min(cells.len() - batch);
                for (bubble, place) in self.skeleton.bubbles(cell).enumerate() {
                    coefficients[place] = room[batch * outer + bubble * lanes + lane];
                }
            }
        });
    }
}

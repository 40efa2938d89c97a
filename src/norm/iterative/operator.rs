//! The condensed operator without a matrix: cell by cell Tᵀ B̂ᵀ (W ⊗ I) B̂ T, where only W (the cell's metric) and T
//! (the change of unknown on its faces) see the cell, and both are made anew from its shape each time.
//!
//! Cells are taken in batches, so that B̂ and B̂ᵀ are products of dense matrices; each batch writes to a place of its own,
//! and every simplex then adds up what its cells have for it, in their order: no bit depends on the threads.

use super::batch::CELLS;
use super::kernel::{Kernel, Work};
use super::number::Number;
use super::skeleton::Skeleton;
use crate::norm::hhj::Hhj;
use crate::parallel::{for_chunks, for_chunks_in};
use std::sync::Arc;

/// The operator on the unknowns of a [`Skeleton`].
#[derive(Clone, Debug)]
pub(super) struct Operator<T, const N: usize> {
    pub hhj: Arc<Hhj<N>>,
    pub skeleton: Arc<Skeleton>,
    pub kernel: Kernel<T, N>,
}

/// How many simplices add up their cells' contributions in one piece of work.
const SIMPLICES: usize = 1024;

impl<T: Number, const N: usize> Operator<T, N> {
    pub fn new(hhj: &Arc<Hhj<N>>, skeleton: &Arc<Skeleton>) -> Self {
        Self {
            hhj: hhj.clone(),
            skeleton: skeleton.clone(),
            kernel: Kernel::new(hhj, skeleton),
        }
    }

    /// How much room [`Operator::apply`] needs.
    pub fn room(&self) -> usize {
        self.hhj.mesh().cell_count() * self.kernel.outer()
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
    pub fn add(&self, factor: T, x: &[T], y: &mut [T], room: &mut [T]) {
        self.for_batches(room, &|work, out| work.image(x, out));
        self.collect(room, y, factor);
    }

    /// `work` at all batches, with the place for their results.
    fn for_batches(&self, room: &mut [T], work: &(dyn Fn(&mut Work<'_, T, N>, &mut [T]) + Sync)) {
        let stride = CELLS * self.kernel.outer();
        for_chunks_in(
            room,
            stride,
            || Work::new(&self.kernel),
            |batch, out, at| {
                at.turn_to(batch);
                work(at, out);
            },
        );
    }

    /// y += factor · the sum over the cells.
    pub fn collect(&self, room: &[T], y: &mut [T], factor: T) {
        let (order, layout) = (&self.skeleton.order, self.hhj.layout());
        let outer = self.kernel.outer();
        for (k, simplices) in order.layers.iter().enumerate() {
            let width = self.skeleton.widths[k];
            if width == 0 {
                continue;
            }
            let starts: Vec<usize> = (layout.blocks.iter().filter(|b| b.k == k))
                .map(|b| b.start - layout.bubbles)
                .collect();
            let layer = self.skeleton.layer_mut(k, y);
            for_chunks(layer, SIMPLICES * width, |piece, layer| {
                for (i, y) in layer.chunks_exact_mut(width).enumerate() {
                    for (cell, which) in simplices.star(piece * SIMPLICES + i) {
                        let of_cell = &room[cell * outer + starts[which]..][..width];
                        for (y, x) in y.iter_mut().zip(of_cell) {
                            *y = y.plus_product(factor, *x);
                        }
                    }
                }
            });
        }
    }
}

/// What is done once a solution.
impl<const N: usize> Operator<f64, N> {
    /// y −= A_sb A_bb⁻¹ f_b: the bubbles' load handed on to the other unknowns.
    pub fn condense(&self, load: &[f64], y: &mut [f64], room: &mut [f64]) {
        self.for_batches(room, &|work, out| {
            work.y.fill(0.0);
            work.bend(&|place| load[place]);
            work.unload(out);
        });
        self.collect(room, y, -1.0);
    }

    /// Writes the bubbles A_bb⁻¹ (f_b − A_bs x) into a deflection's coefficients. `room` is overwritten.
    pub fn bubbles(&self, load: &[f64], x: &[f64], coefficients: &mut [f64], room: &mut [f64]) {
        let count = self.hhj.layout().bubbles;
        if count == 0 {
            return;
        }
        let (cells, stride) = (self.skeleton.order.cells.len(), CELLS * self.kernel.outer());
        self.for_batches(room, &|work, out| {
            work.load(x);
            work.bend(&|place| load[place]);
            out[..work.t.len()].copy_from_slice(&work.t);
        });
        for cell in 0..cells {
            let (batch, lane) = (cell / CELLS, cell % CELLS);
            let lanes = CELLS.min(cells - batch * CELLS);
            for (i, place) in self.skeleton.bubbles(cell).enumerate() {
                coefficients[place] = room[batch * stride + i * lanes + lane];
            }
        }
    }
}

//! The condensed operator without a matrix: cell by cell Tᵀ B̂ᵀ (W ⊗ I) B̂ T, where only W (the cell's metric) and T
//! (the change of unknown on its faces) see the cell, and both are made anew from its shape each time.
//!
//! Cells are taken in batches, so that B̂ and B̂ᵀ are products of dense matrices; each batch writes to a place of its own,
//! and every simplex then adds up what its cells have for it, in their order: no bit depends on the threads.

use super::batch::{Batch, CELLS, Geometry, row, row_mut};
use super::number::Number;
use super::skeleton::Skeleton;
use crate::norm::hhj::Hhj;
use crate::parallel::{for_chunks, for_chunks_in};
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use nalgebra::DMatrix;
use std::sync::Arc;

/// The operator on the unknowns of a [`Skeleton`].
#[derive(Clone, Debug)]
pub(super) struct Operator<T, const N: usize> {
    pub hhj: Arc<Hhj<N>>,
    pub skeleton: Arc<Skeleton>,
    /// B̂_aᵀ B̂_b + B̂_bᵀ B̂_a restricted to the bubbles, or half of it where a = b: row after row of the lower triangle.
    gram: Vec<DMatrix<T>>,
    /// B̂.
    pairing: DMatrix<T>,
    geometry: Geometry<T>,
}

/// How many simplices add up their cells' contributions in one piece of work.
const SIMPLICES: usize = 1024;

impl<T: Number, const N: usize> Operator<T, N> {
    pub fn new(hhj: &Arc<Hhj<N>>, skeleton: &Arc<Skeleton>) -> Self {
        let element = hhj.element();
        let (size, bubbles) = (element.moments.len(), element.layout.bubbles);
        let block = |a: usize| element.pairing.view((a * size, 0), (size, bubbles));
        let pairs = element.pairs.len();
        let product = |a: usize, b: usize| -> DMatrix<f64> { block(a).transpose() * block(b) };
        let entries = (0..pairs).flat_map(|a| (0..=a).map(move |b| (a, b)));
        let gram = entries.map(|(a, b)| match a == b {
            true => product(a, a),
            false => product(a, b) + product(b, a),
        });
        let gram = gram.map(|gram| gram.map(T::of)).collect();
        Self {
            hhj: hhj.clone(),
            skeleton: skeleton.clone(),
            gram,
            pairing: element.pairing.map(T::of),
            geometry: Geometry::new(hhj, &skeleton.order.cells),
        }
    }

    /// How much room [`Operator::apply`] needs.
    pub fn room(&self) -> usize {
        self.hhj.mesh().cell_count() * self.outer()
    }

    /// The operations of [`Operator::apply`]: B̂ and B̂ᵀ, twice W ⊗ I where there are bubbles, and T with Tᵀ.
    pub fn operations(&self) -> f64 {
        let element = self.hhj.element();
        let (rows, columns) = element.pairing.shape();
        let bubbles = element.layout.bubbles;
        let weights = rows * element.pairs.len() * if bubbles > 0 { 2 } else { 1 };
        let slopes: usize = element.layout.faces.iter().map(Vec::len).sum();
        let cell = 4 * rows * (columns + bubbles) + 2 * weights + 4 * slopes * (N + 1);
        cell as f64 * self.hhj.mesh().cell_count() as f64
    }

    /// y = S x for the Schur complement S of the bubbles. `room` is overwritten.
    pub fn apply(&self, x: &[T], y: &mut [T], room: &mut [T]) {
        y.fill(T::ZERO);
        self.add(T::ONE, x, y, room);
    }

    /// y += factor · S x. `room` is overwritten.
    pub fn add(&self, factor: T, x: &[T], y: &mut [T], room: &mut [T]) {
        self.for_batches(room, &|work, out| {
            work.load(x);
            work.bend(&|_| T::ZERO);
            work.unload(out);
        });
        self.collect(room, y, factor);
    }

    /// `work` at all batches, with the place for their results.
    fn for_batches(&self, room: &mut [T], work: &(dyn Fn(&mut Work<'_, T, N>, &mut [T]) + Sync)) {
        let stride = CELLS * self.outer();
        for_chunks_in(
            room,
            stride,
            || Work::new(self),
            |batch, out, at| {
                at.turn_to(batch);
                work(at, out);
            },
        );
    }

    /// y += factor · the sum over the cells.
    fn collect(&self, room: &[T], y: &mut [T], factor: T) {
        let (order, layout) = (&self.skeleton.order, self.hhj.layout());
        let (outer, cells) = (self.outer(), order.cells.len());
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
                        let begin = cell / CELLS * CELLS;
                        let lanes = CELLS.min(cells - begin);
                        let from = begin * outer + starts[which] * lanes + cell - begin;
                        for (y, x) in y.iter_mut().zip(room[from..].iter().step_by(lanes)) {
                            *y += factor * *x;
                        }
                    }
                }
            });
        }
    }

    /// B̂ without the bubbles' columns.
    fn outer_pairing(&self) -> MatRef<'_, T> {
        as_mat(&self.pairing).subcols(self.hhj.layout().bubbles, self.outer())
    }

    /// How many of a cell's unknowns are not bubbles.
    fn outer(&self) -> usize {
        self.hhj.layout().len - self.hhj.layout().bubbles
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
        let (cells, stride) = (self.skeleton.order.cells.len(), CELLS * self.outer());
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

/// A batch at work, and after it the next.
struct Work<'a, T, const N: usize> {
    operator: &'a Operator<T, N>,
    batch: Batch<'a, T>,
    /// Its first cell.
    begin: usize,
    /// The unknowns of the cells without bubbles.
    x: Vec<T>,
    /// B̂ x, and (W ⊗ I) B̂ x.
    y: Vec<T>,
    z: Vec<T>,
    /// The bubbles.
    t: Vec<T>,
}

impl<'a, T: Number, const N: usize> Work<'a, T, N> {
    fn new(operator: &'a Operator<T, N>) -> Self {
        let [x, y, z, t] = Default::default();
        Self {
            operator,
            batch: Batch::EMPTY,
            begin: 0,
            x,
            y,
            z,
            t,
        }
    }

    /// To another batch. What is computed is left over from the one before.
    fn turn_to(&mut self, batch: usize) {
        let (element, layout) = (self.operator.hhj.element(), self.operator.hhj.layout());
        self.begin = batch * CELLS;
        self.batch.turn_to(element, &self.operator.geometry, batch);
        let (lanes, rows) = (self.batch.lanes, element.pairing.nrows());
        self.x.resize(self.operator.outer() * lanes, T::ZERO);
        self.y.resize(rows * lanes, T::ZERO);
        self.z.resize(rows * lanes, T::ZERO);
        self.t.resize(layout.bubbles * lanes, T::ZERO);
    }

    /// y = B̂ T x for the cells' part of a global x, without bubbles.
    fn load(&mut self, global: &[T]) {
        let (hhj, skeleton) = (&self.operator.hhj, &self.operator.skeleton);
        let (element, lanes) = (hhj.element(), self.batch.lanes);
        // On ∂Ω it is zero.
        self.x.fill(T::ZERO);
        for lane in 0..lanes {
            let cell = self.begin + lane;
            for block in &element.layout.blocks {
                let from = skeleton.of_cell(block.k, cell, block.place);
                let first = (block.start - element.layout.bubbles) * lanes + lane;
                let rows = self.x[first..].iter_mut().step_by(lanes);
                for (x, from) in rows.zip(&global[from]) {
                    *x = *from;
                }
            }
        }
        self.batch.shift(element, &mut self.x);
        let pairing = self.operator.outer_pairing();
        multiply(&mut self.y, &self.x, lanes, pairing.transpose());
    }

    /// z = (W ⊗ I)(y + B̂_b t) with the bubbles t = A_bb⁻¹ (f − B̂_bᵀ (W ⊗ I) y); `f` by places.
    fn bend(&mut self, f: &dyn Fn(usize) -> T) {
        let operator = self.operator;
        let (element, lanes) = (operator.hhj.element(), self.batch.lanes);
        let (pairs, size, bubbles) = (
            element.pairs.len(),
            element.moments.len(),
            element.layout.bubbles,
        );
        self.batch.weigh(pairs, size, &self.y, &mut self.z);
        if bubbles == 0 {
            return;
        }
        let t = &mut self.t;
        for lane in 0..lanes {
            for (i, place) in operator.skeleton.bubbles(self.begin + lane).enumerate() {
                t[i * lanes + lane] = f(place);
            }
        }
        for i in 0..bubbles {
            for r in 0..pairs * size {
                let b = operator.pairing[(r, i)];
                for (t, z) in row_mut(t, i, lanes).iter_mut().zip(row(&self.z, r, lanes)) {
                    *t -= b * *z;
                }
            }
        }
        self.batch.solve_bubbles(&operator.gram, t);
        for i in 0..bubbles {
            for r in 0..pairs * size {
                let b = operator.pairing[(r, i)];
                for (y, t) in row_mut(&mut self.y, r, lanes)
                    .iter_mut()
                    .zip(row(t, i, lanes))
                {
                    *y += b * *t;
                }
            }
        }
        self.batch.weigh(pairs, size, &self.y, &mut self.z);
    }

    /// Tᵀ B̂ᵀ z without the bubbles' rows.
    fn unload(&mut self, out: &mut [T]) {
        let (element, lanes) = (self.operator.hhj.element(), self.batch.lanes);
        multiply(out, &self.z, lanes, self.operator.outer_pairing());
        self.batch.shift_back(element, out);
    }
}

/// c = a b for rows of lanes: the rows of c and a are columns here.
fn multiply<T: Number>(c: &mut [T], a: &[T], lanes: usize, b: MatRef<'_, T>) {
    let c = MatMut::from_column_major_slice_mut(c, lanes, b.ncols());
    let a = MatRef::from_column_major_slice(a, lanes, b.nrows());
    matmul(c, Accum::Replace, a, b, T::ONE, Par::Seq);
}

fn as_mat<T>(a: &DMatrix<T>) -> MatRef<'_, T> {
    MatRef::from_column_major_slice(a.as_slice(), a.nrows(), a.ncols())
}

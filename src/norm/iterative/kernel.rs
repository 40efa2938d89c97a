//! Some cells' part of the operator: what is done with a batch, step by step.

use super::batch::{Batch, CELLS, Geometry, row, row_mut};
use super::number::Number;
use super::pairing::Pairing;
use super::skeleton::Skeleton;
use super::width::by_width;
use crate::norm::hhj::Hhj;
use nalgebra::DMatrix;
use std::sync::Arc;

/// What the operator is made of on a cell.
#[derive(Clone, Debug)]
pub(super) struct Kernel<T, const N: usize> {
    hhj: Arc<Hhj<N>>,
    skeleton: Arc<Skeleton>,
    /// B̂_aᵀ B̂_b + B̂_bᵀ B̂_a restricted to the bubbles, or half of it where a = b: row after row of the lower triangle.
    gram: Vec<DMatrix<T>>,
    /// B̂.
    pub pairing: Pairing<T>,
    geometry: Geometry<T>,
}

impl<T: Number, const N: usize> Kernel<T, N> {
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
            pairing: Pairing::new(element),
            geometry: Geometry::new(hhj, &skeleton.order.cells),
        }
    }

    /// How many of a cell's unknowns are not bubbles.
    pub fn outer(&self) -> usize {
        self.hhj.layout().len - self.hhj.layout().bubbles
    }
}

/// A batch at work, and after it the next.
pub(super) struct Work<'a, T, const N: usize> {
    kernel: &'a Kernel<T, N>,
    batch: Batch<'a, T>,
    /// Its first cell.
    begin: usize,
    /// The unknowns of the cells without bubbles.
    x: Vec<T>,
    /// B̂ x, and (W ⊗ I) B̂ x.
    pub y: Vec<T>,
    z: Vec<T>,
    /// The bubbles.
    pub t: Vec<T>,
}

impl<'a, T: Number, const N: usize> Work<'a, T, N> {
    pub fn new(kernel: &'a Kernel<T, N>) -> Self {
        let [x, y, z, t] = Default::default();
        Self {
            kernel,
            batch: Batch::EMPTY,
            begin: 0,
            x,
            y,
            z,
            t,
        }
    }

    /// To another batch. What is computed is left over from the one before.
    pub fn turn_to(&mut self, batch: usize) {
        let (element, layout) = (self.kernel.hhj.element(), self.kernel.hhj.layout());
        self.begin = batch * CELLS;
        self.batch.turn_to(element, &self.kernel.geometry, batch);
        let (lanes, rows) = (self.batch.lanes, element.pairing.nrows());
        self.x.resize(self.kernel.outer() * lanes, T::ZERO);
        self.y.resize(rows * lanes, T::ZERO);
        self.z.resize(rows * lanes, T::ZERO);
        self.t.resize(layout.bubbles * lanes, T::ZERO);
    }

    /// The cells' part of S x.
    pub fn image<S: Number>(&mut self, x: &[S], out: &mut [T]) {
        self.load(x);
        self.bend(&|_| T::ZERO);
        self.unload(out);
    }

    /// y = B̂ T x for the cells' part of a global x, without bubbles.
    pub fn load<S: Number>(&mut self, global: &[S]) {
        let (hhj, skeleton) = (&self.kernel.hhj, &self.kernel.skeleton);
        let (element, lanes) = (hhj.element(), self.batch.lanes);
        // On ∂Ω it is zero.
        self.x.fill(T::ZERO);
        for block in element.layout.blocks.iter().filter(|block| block.width > 0) {
            let first = (block.start - element.layout.bubbles) * lanes;
            let rows = &mut self.x[first..first + block.width * lanes];
            let cells = self.begin..self.begin + lanes;
            let lists = skeleton.of_cells(block.k, cells, block.place, global);
            if lanes < CELLS {
                spread_any(rows, lanes, lists);
                continue;
            }
            by_width!(block.width, W => spread::<S, T, W>(rows, lists), else spread_any(rows, lanes, lists));
        }
        self.batch.shift(element, &mut self.x);
        let pairing = &self.kernel.pairing;
        pairing.multiply(&self.x, &mut self.y, lanes);
    }

    /// z = (W ⊗ I)(y + B̂_b t) with the bubbles t = A_bb⁻¹ (f − B̂_bᵀ (W ⊗ I) y); `f` by places.
    pub fn bend(&mut self, f: &dyn Fn(usize) -> T) {
        let kernel = self.kernel;
        let (element, lanes) = (kernel.hhj.element(), self.batch.lanes);
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
            for (i, place) in kernel.skeleton.bubbles(self.begin + lane).enumerate() {
                t[i * lanes + lane] = f(place);
            }
        }
        for i in 0..bubbles {
            for r in 0..pairs * size {
                let b = kernel.pairing.bubbles[(r, i)];
                for (t, z) in row_mut(t, i, lanes).iter_mut().zip(row(&self.z, r, lanes)) {
                    *t -= b * *z;
                }
            }
        }
        self.batch.solve_bubbles(&kernel.gram, t);
        for i in 0..bubbles {
            for r in 0..pairs * size {
                let b = kernel.pairing.bubbles[(r, i)];
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

    /// Tᵀ B̂ᵀ z without the bubbles' rows, cell by cell: so the simplices find what is theirs.
    pub fn unload(&mut self, out: &mut [T]) {
        let (element, lanes) = (self.kernel.hhj.element(), self.batch.lanes);
        self.kernel.pairing.transposed(&self.z, &mut self.x, lanes);
        self.batch.shift_back(element, &mut self.x);
        by_lanes(&self.x, lanes, out);
    }
}

/// Writes what each lane has, if it has anything, into its place of the rows. There are W of them, and a full batch: the compiler knows
/// that all places exist.
fn spread<'a, S: Number, T: Number, const W: usize>(
    rows: &mut [T],
    lists: impl Iterator<Item = &'a [S]>,
) {
    let rows = rows.as_chunks_mut::<CELLS>().0;
    let rows: &mut [_; W] = rows.try_into().expect("as many rows as numbers");
    for (lane, list) in (0..CELLS).zip(lists) {
        // On ∂Ω there is nothing.
        if list.is_empty() {
            continue;
        }
        let list: &[S; W] = list.try_into().expect("a lane has a number for each row");
        for (row, x) in rows.iter_mut().zip(list) {
            row[lane] = T::of(x.double());
        }
    }
}

/// [`spread`] for any number of rows and lanes.
fn spread_any<'a, S: Number, T: Number>(
    rows: &mut [T],
    lanes: usize,
    lists: impl Iterator<Item = &'a [S]>,
) {
    for (lane, list) in lists.enumerate() {
        for (place, x) in rows[lane..].iter_mut().step_by(lanes).zip(list) {
            *place = T::of(x.double());
        }
    }
}

/// Writes the rows' numbers lane by lane.
fn by_lanes<T: Number>(rows: &[T], lanes: usize, out: &mut [T]) {
    let of_lanes = out.chunks_exact_mut(rows.len() / lanes);
    if lanes == CELLS {
        // Here too.
        let rows = rows.as_chunks::<CELLS>().0;
        for (lane, out) in (0..CELLS).zip(of_lanes) {
            for (out, row) in out.iter_mut().zip(rows) {
                *out = row[lane];
            }
        }
        return;
    }
    for (lane, out) in of_lanes.enumerate() {
        for (out, row) in out.iter_mut().zip(rows.chunks_exact(lanes)) {
            *out = row[lane];
        }
    }
}

//! The operator in single precision, and in double precision where cells are flat.
//!
//! Affine functions have no energy on a cell: terms cancel that are as large as the energy of others, which grows like a power of
//! the cell's flatness. In single precision something is left, which the blocks' inverses, which know nothing of it, make much of: on
//! a Fichera corner of 1 134 tetrahedra, p = 3, where an edge is 1/20 of what it was (least mean ratio 0.095), conjugate gradients broke
//! down in step 74, and with the flat cells in double precision they take 23.

use super::batch::CELLS;
use super::kernel::Work;
use super::operator::Operator;
use crate::parallel::for_chunks_in;
use std::sync::Arc;

/// Where a cell's mean ratio is below, its batch is computed in double precision. At 0.153 single precision takes as many steps.
const DOUBLE: f64 = 0.15;

/// The operator of a cycle.
#[derive(Clone, Debug)]
pub(super) struct Mixed<const N: usize> {
    single: Operator<f32, N>,
    double: Arc<Operator<f64, N>>,
    /// By batch: is it computed in double precision?
    flat: Vec<bool>,
}

impl<const N: usize> Mixed<N> {
    /// In double precision it is this one.
    pub fn new(double: &Arc<Operator<f64, N>>) -> Self {
        let batches = double.skeleton.order.ratios.chunks(CELLS);
        let is_flat = |batch: &[f64]| batch.iter().any(|&ratio| ratio < DOUBLE);
        Self {
            single: Operator::new(&double.hhj, &double.skeleton),
            double: double.clone(),
            flat: batches.map(is_flat).collect(),
        }
    }

    /// How much room [`Mixed::apply`] needs.
    pub fn room(&self) -> usize {
        self.single.cells() * self.single.kernel.outer()
    }

    /// How many unknowns.
    pub fn len(&self) -> usize {
        self.single.skeleton.len()
    }

    /// y = S x. `room` is overwritten.
    pub fn apply(&self, x: &[f32], y: &mut [f32], room: &mut [f32]) {
        y.fill(0.0);
        self.add(1.0, x, y, room);
    }

    /// y += factor · S x. `room` is overwritten.
    pub fn add(&self, factor: f32, x: &[f32], y: &mut [f32], room: &mut [f32]) {
        let stride = CELLS * self.single.kernel.outer();
        let works = || {
            (
                Work::new(&self.single.kernel),
                Work::new(&self.double.kernel),
                Vec::new(),
            )
        };
        for_chunks_in(
            room,
            stride,
            works,
            |batch, out, (single, double, image)| {
                if !self.flat[batch] {
                    single.turn_to(batch);
                    return single.image(x, out);
                }
                double.turn_to(batch);
                image.resize(out.len(), 0.0);
                double.image(x, image);
                for (out, x) in out.iter_mut().zip(image.iter()) {
                    *out = *x as f32;
                }
            },
        );
        self.single.collect(0..self.single.cells(), room, y, factor);
    }
}

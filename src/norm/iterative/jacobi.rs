//! The diagonal blocks of the condensed operator, one a simplex, inverted.

use super::batch::lower;
use super::skeleton::Skeleton;
use crate::Error;
use crate::mesh::Mesh;
use crate::norm::hhj::Hhj;
use crate::norm::hhj::cell::eliminate;
use crate::parallel::{for_chunks, in_order};
use std::sync::Arc;

/// A_ss⁻¹ for each interior simplex s. Single precision is enough for a preconditioner: the rounding is one of every
/// entry, relative to itself.
#[derive(Clone, Debug)]
pub(super) struct BlockJacobi {
    skeleton: Arc<Skeleton>,
    /// By dimension: the lower triangles, row by row, one simplex after the other.
    inverses: Vec<Vec<f32>>,
}

/// How many simplices make one piece of work.
const SIMPLICES: usize = 1024;

impl BlockJacobi {
    /// # Errors
    /// If rounding makes a block indefinite (cells that are all but flat).
    pub fn new<const N: usize>(hhj: &Hhj<N>, skeleton: &Arc<Skeleton>) -> Result<Self, Error> {
        let mut inverses = Vec::new();
        for (k, sums) in diagonal(hhj, skeleton).into_iter().enumerate() {
            inverses.push(invert(hhj.mesh(), k, skeleton, &sums)?);
        }
        Ok(Self {
            skeleton: skeleton.clone(),
            inverses,
        })
    }

    /// z = J r.
    pub fn apply(&self, r: &[f32], z: &mut [f32]) {
        let skeleton = &self.skeleton;
        for (k, inverses) in self.inverses.iter().enumerate() {
            let width = skeleton.widths[k];
            if width == 0 {
                continue;
            }
            let (r, size) = (skeleton.layer(k, r), packed(width));
            for_chunks(skeleton.layer_mut(k, z), SIMPLICES * width, |piece, z| {
                let first = piece * SIMPLICES;
                for (i, z) in z.chunks_exact_mut(width).enumerate() {
                    let simplex = first + i;
                    let a = &inverses[simplex * size..(simplex + 1) * size];
                    multiply(a, &r[simplex * width..(simplex + 1) * width], z);
                }
            });
        }
    }
}

/// How many entries the lower triangle of a block has.
fn packed(width: usize) -> usize {
    lower(width, 0)
}

/// The blocks A_ss, as those of [`BlockJacobi`] but in double precision.
fn diagonal<const N: usize>(hhj: &Hhj<N>, skeleton: &Skeleton) -> Vec<Vec<f64>> {
    let (layout, order) = (hhj.layout(), &skeleton.order);
    let sizes: Vec<usize> = skeleton.widths.iter().map(|&w| packed(w)).collect();
    let mut sums: Vec<Vec<f64>> = (0..N)
        .map(|k| vec![0.0; sizes[k] * order.layers[k].free])
        .collect();
    let blocks = |cell: usize| {
        let mut energy = hhj.energy(order.cells[cell] as usize);
        eliminate(&mut energy, layout.bubbles);
        let mut packed = Vec::new();
        for block in &layout.blocks {
            for i in 0..block.width {
                packed.extend((0..=i).map(|j| energy[(block.start + i, block.start + j)]));
            }
        }
        packed
    };
    in_order(order.cells.len(), blocks, |cell, packed| {
        let mut from = packed.as_slice();
        for block in &layout.blocks {
            let (here, rest) = from.split_at(sizes[block.k]);
            from = rest;
            if let Some(simplex) = order.layers[block.k].free_of_cell(cell, block.place) {
                let to = &mut sums[block.k][simplex * here.len()..];
                for (to, a) in to.iter_mut().zip(here) {
                    *to += a;
                }
            }
        }
    });
    sums
}

/// z = A r from A's lower triangle.
fn multiply(a: &[f32], r: &[f32], z: &mut [f32]) {
    let mut next = 0;
    for i in 0..r.len() {
        // Row i is the first to see z_i.
        let mut sum = 0.0;
        for j in 0..i {
            let a = a[next + j];
            sum += a * r[j];
            z[j] += a * r[i];
        }
        z[i] = sum + a[next + i] * r[i];
        next += i + 1;
    }
}

/// The inverses of the k-simplices' blocks.
fn invert<const N: usize>(
    mesh: &Mesh<N>,
    k: usize,
    skeleton: &Skeleton,
    sums: &[f64],
) -> Result<Vec<f32>, Error> {
    let width = skeleton.widths[k];
    let size = packed(width);
    let mut inverses = vec![0.0; sums.len()];
    if size == 0 {
        return Ok(inverses);
    }
    for_chunks(&mut inverses, SIMPLICES * size, |piece, inverses| {
        for (i, inverse) in inverses.chunks_exact_mut(size).enumerate() {
            let simplex = piece * SIMPLICES + i;
            invert_one(width, &sums[simplex * size..(simplex + 1) * size], inverse);
        }
    });
    match inverses.iter().position(|x| !x.is_finite()) {
        None => Ok(inverses),
        Some(i) => Err(Error::Solver(format!(
            "the block of the {k}-simplex {:?} is not positive definite",
            mesh.vertices(k, skeleton.order.layers[k].simplices[i / size] as usize)
        ))),
    }
}

/// A⁻¹ = L⁻ᵀ L⁻¹ from the lower triangle of A; not finite where A is not positive definite.
fn invert_one(n: usize, a: &[f64], inverse: &mut [f32]) {
    let (at, mut l) = (lower, a.to_vec());
    for j in 0..n {
        let square: f64 = (0..j).map(|k| l[at(j, k)] * l[at(j, k)]).sum();
        l[at(j, j)] = (l[at(j, j)] - square).sqrt();
        for i in j + 1..n {
            let sum: f64 = (0..j).map(|k| l[at(i, k)] * l[at(j, k)]).sum();
            l[at(i, j)] = (l[at(i, j)] - sum) / l[at(j, j)];
        }
    }
    // L becomes L⁻¹, column by column.
    for j in 0..n {
        l[at(j, j)] = 1.0 / l[at(j, j)];
        for i in j + 1..n {
            let sum: f64 = (j..i).map(|k| l[at(i, k)] * l[at(k, j)]).sum();
            l[at(i, j)] = -sum / l[at(i, i)];
        }
    }
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (i..n).map(|k| l[at(k, i)] * l[at(k, j)]).sum();
            inverse[at(i, j)] = sum as f32;
        }
    }
}

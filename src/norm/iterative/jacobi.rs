//! Diagonal blocks of the condensed operator, inverted: one a simplex, or one a cell where cells are bad.

use super::closures::{Closures, Plan, bad_cells};
use super::packed::{invert, multiply_all, packed};
use super::skeleton::{Piece, Skeleton};
use crate::Error;
use crate::mesh::Mesh;
use crate::norm::hhj::Hhj;
use crate::norm::hhj::layout::Layout;
use crate::parallel::{for_chunks, in_order, zeros};
use nalgebra::DMatrix;
use std::sync::Arc;

/// A_ss⁻¹ for each interior simplex s, and for the [`Closures`] of bad cells in place of their simplices. Single precision is
/// enough for a preconditioner: the rounding is one of every entry, relative to itself.
#[derive(Clone, Debug)]
pub(super) struct BlockJacobi {
    skeleton: Arc<Skeleton>,
    /// By dimension: the lower triangles, row by row, one simplex after the other; zero for those of bad cells.
    inverses: Vec<Vec<f32>>,
    closures: Closures,
}

/// How many simplices' blocks are inverted in one piece of work.
const SIMPLICES: usize = 1024;

impl BlockJacobi {
    /// # Errors
    /// If rounding makes a block indefinite (cells that are all but flat).
    pub fn new<const N: usize>(hhj: &Hhj<N>, skeleton: &Arc<Skeleton>) -> Result<Self, Error> {
        let mesh = hhj.mesh();
        let plan = Plan::new(hhj, skeleton, bad_cells(skeleton));
        let diagonal = Diagonal::new(hhj, skeleton, &plan);
        let mut inverses = Vec::new();
        for (k, sums) in diagonal.simplices.into_iter().enumerate() {
            let mut of_layer = inverse_blocks(mesh, k, skeleton, &sums)?;
            let size = packed(skeleton.widths[k]);
            for simplex in plan.simplices(k, skeleton) {
                of_layer[simplex * size..(simplex + 1) * size].fill(0.0);
            }
            inverses.push(of_layer);
        }
        Ok(Self {
            skeleton: skeleton.clone(),
            inverses,
            closures: plan.inverted(&diagonal.closures, mesh, skeleton)?,
        })
    }

    /// z = J r.
    pub fn apply(&self, r: &[f32], z: &mut [f32]) {
        self.skeleton
            .by_pieces([z], |piece, [z]| self.on_piece(piece, r, z));
        self.closures.add(1.0, r, &mut [z]);
    }

    /// x = ω J r, and z += x.
    pub fn step(&self, weight: f32, r: &[f32], x: &mut [f32], z: &mut [f32]) {
        self.skeleton.by_pieces([x, z], |piece, [x, z]| {
            self.on_piece(piece, r, x);
            for (x, z) in x.iter_mut().zip(z) {
                *x *= weight;
                *z += *x;
            }
        });
        self.closures.add(weight, r, &mut [x, z]);
    }

    /// What the simplices' own blocks make of r, for some simplices.
    fn on_piece(&self, piece: &Piece, r: &[f32], z: &mut [f32]) {
        let (skeleton, width) = (&self.skeleton, self.skeleton.widths[piece.k]);
        let inverses = &self.inverses[piece.k][piece.simplices.start * packed(width)..];
        multiply_all(width, inverses, skeleton.of_piece(piece, r), z);
    }
}

/// The blocks of [`BlockJacobi`] in double precision.
struct Diagonal {
    /// By dimension.
    simplices: Vec<Vec<f64>>,
    closures: Vec<Vec<f64>>,
}

impl Diagonal {
    fn new<const N: usize>(hhj: &Hhj<N>, skeleton: &Skeleton, plan: &Plan) -> Self {
        let (layout, order) = (hhj.layout(), &skeleton.order);
        let of_layer = |k: usize| zeros(packed(skeleton.widths[k]) * order.layers[k].free);
        let mut sums = Self {
            simplices: (0..N).map(of_layer).collect(),
            closures: plan.zeros(),
        };
        let blocks = |cell: usize| {
            let energy = hhj.condensed(order.cells[cell] as usize);
            let shares = plan.shares(hhj, skeleton, cell, &energy);
            (diagonal_blocks(layout, &energy), shares)
        };
        in_order(order.cells.len(), blocks, |cell, (blocks, shares)| {
            sums.add(layout, skeleton, cell, &blocks);
            for share in shares {
                share.add(&mut sums.closures);
            }
        });
        sums
    }

    /// Adds a cell's blocks to those of its interior simplices.
    fn add(&mut self, layout: &Layout, skeleton: &Skeleton, cell: usize, mut blocks: &[f64]) {
        for block in &layout.blocks {
            let (here, rest) = blocks.split_at(packed(block.width));
            blocks = rest;
            let layer = &skeleton.order.layers[block.k];
            if let Some(simplex) = layer.free_of_cell(cell, block.place) {
                let to = &mut self.simplices[block.k][simplex * here.len()..];
                for (to, a) in to.iter_mut().zip(here) {
                    *to += a;
                }
            }
        }
    }
}

/// The lower triangles of a cell's blocks, one after the other.
fn diagonal_blocks(layout: &Layout, energy: &DMatrix<f64>) -> Vec<f64> {
    let mut packed = Vec::new();
    for block in &layout.blocks {
        for i in 0..block.width {
            packed.extend((0..=i).map(|j| energy[(block.start + i, block.start + j)]));
        }
    }
    packed
}

/// The inverses of the k-simplices' blocks.
fn inverse_blocks<const N: usize>(
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
            invert(width, &sums[simplex * size..(simplex + 1) * size], inverse);
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

//! The global unknowns that are left: u and û on the interior simplices of dimension < N, in order of elimination.

use super::dissection::{Graph, dissect};
use crate::linalg::Vector;
use crate::mesh::Mesh;
use crate::norm::hhj::layout::{Block, Layout};
use crate::sparse::CellBlock;

/// No unknown: the simplex lies in ∂Ω, where u = 0 and û = 0.
const CLAMPED: u32 = u32::MAX;

/// A numbering by blocks, one an interior simplex.
#[derive(Clone, Debug)]
pub(super) struct Unknowns {
    /// For each dimension and simplex: its block, or [`CLAMPED`].
    blocks: Vec<Vec<u32>>,
    /// The first unknown of each block, and the number of all of them.
    pub offsets: Vec<usize>,
}

impl Unknowns {
    /// Numbers the unknowns of all cells with this layout; `centres` are points inside the cells.
    pub fn new<const N: usize>(
        mesh: &Mesh<N>,
        layout: &Layout,
        centres: &[Vector<f64, N>],
    ) -> Self {
        let (mut simplices, mut weights) = (Vec::new(), Vec::new());
        let (mut offsets, mut cells) = (vec![0], Vec::new());
        for k in 0..N {
            let mut blocks = layout.blocks.iter();
            let of_k = blocks.find(|b| b.k == k);
            let width = of_k.expect("every subsimplex has a block").width;
            for simplex in mesh.interior(k).filter(|_| width > 0) {
                simplices.push((k, simplex));
                weights.push(width);
                cells.extend(mesh.star(k, simplex).map(|side| side.cell as u32));
                offsets.push(cells.len());
            }
        }
        let graph = Graph {
            centres: &by_axis(centres),
            offsets: &offsets,
            cells: &cells,
            weights: &weights,
        };
        let mut unknowns = Self {
            blocks: (0..N).map(|k| vec![CLAMPED; mesh.count(k)]).collect(),
            offsets: vec![0],
        };
        for (block, &node) in dissect(&graph).iter().enumerate() {
            let (k, simplex) = simplices[node as usize];
            unknowns.blocks[k][simplex] = block as u32;
            unknowns
                .offsets
                .push(unknowns.offsets[block] + weights[node as usize]);
        }
        unknowns
    }

    /// How many unknowns.
    pub fn len(&self) -> usize {
        self.offsets[self.offsets.len() - 1]
    }

    /// The blocks of a cell that are not clamped.
    pub fn of_cell<const N: usize>(
        &self,
        mesh: &Mesh<N>,
        layout: &Layout,
        cell: usize,
    ) -> Vec<CellBlock> {
        let numbered = |b: &Block| {
            let block = self.blocks[b.k][mesh.simplices_of(cell, b.k)[b.place] as usize];
            (block != CLAMPED).then_some(CellBlock {
                block: block as usize,
                start: b.start,
            })
        };
        layout.blocks.iter().filter_map(numbered).collect()
    }

    /// Writes down for a cell's blocks which of all the cell's unknowns, `cell_unknowns`, each number stands for.
    pub fn locate(&self, blocks: &[CellBlock], cell_unknowns: &[usize], places: &mut [usize]) {
        for &CellBlock { block, start } in blocks {
            for (r, number) in (self.offsets[block]..self.offsets[block + 1]).enumerate() {
                places[number] = cell_unknowns[start + r];
            }
        }
    }
}

/// The coordinates of points: `[axis][point]`.
fn by_axis<const N: usize>(points: &[Vector<f64, N>]) -> Vec<Vec<f64>> {
    let along = |axis| points.iter().map(|x| x[axis]).collect();
    (0..N).map(along).collect()
}

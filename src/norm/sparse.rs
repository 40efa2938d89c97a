//! The condensed matrix: the upper triangle in compressed columns, assembled block by block in the cells' order.

use super::layout::Layout;
use super::unknowns::Unknowns;
use crate::mesh::Mesh;
use nalgebra::DMatrix;

/// The upper triangle of a symmetric matrix whose pattern consists of blocks.
#[derive(Clone, Debug)]
pub(super) struct Upper {
    /// The first entry of each column, and the number of all of them.
    pub columns: Vec<usize>,
    /// The row of each entry, ascending in a column.
    pub rows: Vec<usize>,
    /// The entries.
    pub values: Vec<f64>,
    /// For each block of columns, the blocks of rows above it, ascending, and where each begins in a column.
    above: Vec<Vec<(u32, u32)>>,
}

impl Upper {
    /// The pattern of all pairs of unknowns that share a cell, with values zero.
    pub fn new<const N: usize>(mesh: &Mesh<N>, layout: &Layout, unknowns: &Unknowns) -> Self {
        let mut above = neighbours(mesh, layout, unknowns);
        let (mut columns, mut rows) = (vec![0], Vec::new());
        for (block, list) in above.iter_mut().enumerate() {
            let mut begin = 0;
            for (other, start) in list.iter_mut() {
                *start = begin;
                begin += (unknowns.offsets[*other as usize + 1] - unknowns.offsets[*other as usize])
                    as u32;
            }
            for column in unknowns.offsets[block]..unknowns.offsets[block + 1] {
                for &(other, _) in list.iter() {
                    rows.extend(
                        unknowns.offsets[other as usize]..unknowns.offsets[other as usize + 1],
                    );
                }
                rows.extend(unknowns.offsets[block]..=column);
                columns.push(rows.len());
            }
        }
        let values = vec![0.0; rows.len()];
        Self {
            columns,
            rows,
            values,
            above,
        }
    }

    /// Adds a cell's matrix, of which the lower triangle is read; `cell` lists (global block, local block).
    pub fn add(
        &mut self,
        layout: &Layout,
        unknowns: &Unknowns,
        cell: &[(usize, usize)],
        local: &DMatrix<f64>,
    ) {
        for &(column_block, j) in cell {
            for &(row_block, i) in cell.iter().filter(|(other, _)| *other <= column_block) {
                let begin = self.begin(unknowns, row_block, column_block);
                let (from, to) = (layout.blocks[i], layout.blocks[j]);
                for c in 0..to.width {
                    let first = self.columns[unknowns.offsets[column_block] + c] + begin;
                    let width = if i == j { c + 1 } else { from.width };
                    for r in 0..width {
                        let (a, b) = (from.start + r, to.start + c);
                        self.values[first + r] += local[(a.max(b), a.min(b))];
                    }
                }
            }
        }
    }

    /// Where a block of rows begins in the columns of a block: they share a cell, so it is there.
    fn begin(&self, unknowns: &Unknowns, row_block: usize, column_block: usize) -> usize {
        let list = &self.above[column_block];
        match list.binary_search_by_key(&(row_block as u32), |e| e.0) {
            Ok(position) => list[position].1 as usize,
            // The diagonal block: after all the others.
            Err(_) => {
                let column = unknowns.offsets[column_block];
                self.columns[column + 1] - self.columns[column] - 1
            }
        }
    }
}

/// For each block the earlier blocks that share a cell with it, ascending.
fn neighbours<const N: usize>(
    mesh: &Mesh<N>,
    layout: &Layout,
    unknowns: &Unknowns,
) -> Vec<Vec<(u32, u32)>> {
    let mut above = vec![Vec::new(); unknowns.blocks()];
    for cell in 0..mesh.cell_count() {
        let blocks: Vec<usize> = unknowns.of_cell(mesh, layout, cell).map(|b| b.0).collect();
        for &column in &blocks {
            above[column].extend(
                blocks
                    .iter()
                    .filter(|&&row| row < column)
                    .map(|&row| (row as u32, 0)),
            );
        }
    }
    for list in &mut above {
        list.sort_unstable();
        list.dedup();
        list.shrink_to_fit();
    }
    above
}

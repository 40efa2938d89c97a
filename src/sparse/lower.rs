//! The lower triangle of a sparse symmetric matrix in compressed columns, assembled block by block in the cells' order.

use super::neighbours::{CellBlock, Neighbours};
use crate::Error;
use crate::parallel::zeros;
use nalgebra::DMatrix;
use std::ops::Range;

/// The lower triangle of a symmetric matrix whose pattern consists of blocks: all pairs of unknowns whose blocks share
/// a cell. Its indices are short, as the solver's are.
#[derive(Clone, Debug)]
pub(crate) struct Lower {
    /// The first entry of each column, and the number of all of them.
    pub(super) columns: Vec<u32>,
    /// The row of each entry, ascending in a column, of which the first is on the diagonal.
    pub(super) rows: Vec<u32>,
    /// The entries.
    pub(super) values: Vec<f64>,
    /// The first unknown of each block, and the number of all of them.
    pub(super) offsets: Vec<usize>,
    /// For each block of columns, the blocks of rows below it, ascending, and where each begins in a column, the diagonal block not
    /// counted.
    pub(super) below: Neighbours,
}

impl Lower {
    /// The pattern of all pairs of unknowns that share a cell, with values zero. Block b has the unknowns
    /// `offsets[b]..offsets[b + 1]`; `blocks` tells those of a cell, of which there are `cells`.
    ///
    /// # Errors
    /// If there are more entries than short indices can tell apart.
    pub fn new(
        offsets: Vec<usize>,
        cells: usize,
        blocks: &dyn Fn(usize) -> Vec<CellBlock>,
    ) -> Result<Self, Error> {
        let mut below = Neighbours::new(offsets.len() - 1, cells, blocks);
        let of_block =
            |block: u32| offsets[block as usize] as u32..offsets[block as usize + 1] as u32;
        let mut entries = 0;
        for block in 0..offsets.len() - 1 {
            let (mut begin, width) = (0, of_block(block as u32).len());
            for (other, start) in below.of_mut(block) {
                *start = begin;
                begin += of_block(*other).len() as u32;
            }
            entries += width * begin as usize + width * (width + 1) / 2;
        }
        // The solver's indices have a sign.
        if entries > i32::MAX as usize {
            return Err(too_large(offsets[offsets.len() - 1]));
        }
        let (mut columns, mut rows) = (vec![0], Vec::with_capacity(entries));
        for block in 0..offsets.len() - 1 {
            let own = of_block(block as u32);
            for column in own.clone() {
                rows.extend(column..own.end);
                for &(other, _) in below.of(block) {
                    rows.extend(of_block(other));
                }
                columns.push(rows.len() as u32);
            }
        }
        Ok(Self {
            values: zeros(rows.len()),
            columns,
            rows,
            offsets,
            below,
        })
    }

    /// Adds a cell's symmetric matrix, of which the lower triangle is read.
    pub fn add(&mut self, cell: &[CellBlock], local: &DMatrix<f64>) {
        let (n, local) = (local.nrows(), local.as_slice());
        for from in cell {
            let own = self.unknowns(from.block);
            for to in cell.iter().filter(|to| to.block >= from.block) {
                let rows = self.unknowns(to.block).len();
                let begin = self.begin(to.block, from.block);
                for (c, column) in own.clone().enumerate() {
                    let (first, skipped) = match to.block == from.block {
                        true => (self.columns[column] as usize, c),
                        false => (self.columns[column] as usize + own.len() - c + begin, 0),
                    };
                    let values = &mut self.values[first..first + rows - skipped];
                    let b = from.start + c;
                    for (r, value) in (skipped..).zip(values) {
                        let a = to.start + r;
                        *value += local[a.min(b) * n + a.max(b)];
                    }
                }
            }
        }
    }

    /// xᵀ A x.
    pub fn energy(&self, x: &[f64]) -> f64 {
        let of_column = |(c, x_c): (usize, &f64)| {
            let entries = self.columns[c] as usize..self.columns[c + 1] as usize;
            let products = entries.map(|i| match self.rows[i] as usize {
                row if row == c => self.values[i] * x_c,
                row => 2.0 * self.values[i] * x[row],
            });
            x_c * products.sum::<f64>()
        };
        x.iter().enumerate().map(of_column).sum()
    }

    /// The unknowns of a block.
    pub fn unknowns(&self, block: usize) -> Range<usize> {
        self.offsets[block]..self.offsets[block + 1]
    }

    /// Where a block of rows begins in the columns of a block, the diagonal block not counted.
    fn begin(&self, rows: usize, columns: usize) -> usize {
        if rows == columns {
            return 0;
        }
        let list = self.below.of(columns);
        let position = list
            .binary_search_by_key(&(rows as u32), |entry| entry.0)
            .expect("blocks that share a cell are in the pattern");
        list[position].1 as usize
    }
}

/// That a direct solver cannot do it.
pub(super) fn too_large(unknowns: usize) -> Error {
    Error::Solver(format!(
        "{unknowns} unknowns are too many for the direct solver, whose matrices have at most 2³¹ entries (17 GB): take fewer cells or a \
         lower degree"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two cells that share the block in the middle, blocks of different widths, cells' blocks in any order: the sum of
    /// the cells' matrices, entry by entry.
    #[test]
    fn cells_add_up() {
        let offsets = vec![0, 2, 3, 5];
        let block = |block, start| CellBlock { block, start };
        let cells = [
            vec![block(1, 0), block(0, 1)],
            vec![block(2, 1), block(1, 0)],
        ];
        let mut lower = Lower::new(offsets.clone(), 2, &|cell| cells[cell].clone()).unwrap();
        let mut expected = DMatrix::zeros(5, 5);
        for (i, cell) in cells.iter().enumerate() {
            let local = DMatrix::from_fn(3, 3, |a, b| ((i + 1) * (a * b + a + b)) as f64);
            lower.add(cell, &local);
            for x in cell {
                for y in cell {
                    for a in 0..offsets[x.block + 1] - offsets[x.block] {
                        for b in 0..offsets[y.block + 1] - offsets[y.block] {
                            expected[(offsets[x.block] + a, offsets[y.block] + b)] +=
                                local[(x.start + a, y.start + b)];
                        }
                    }
                }
            }
        }
        let mut found = DMatrix::zeros(5, 5);
        for column in 0..5 {
            for i in lower.columns[column] as usize..lower.columns[column + 1] as usize {
                found[(lower.rows[i] as usize, column)] = lower.values[i];
            }
        }
        // Unknowns 0 and 1 do not meet 3 and 4: that is all that the pattern leaves out.
        assert_eq!(lower.rows.len(), 15 - 4);
        assert_eq!(found, expected.lower_triangle());
        let x = [1.0, -2.0, 0.5, 3.0, -1.0];
        let vector = DMatrix::from_column_slice(5, 1, &x);
        let energy = (vector.transpose() * expected * vector)[(0, 0)];
        assert!((lower.energy(&x) - energy).abs() < 1e-12);
    }

    /// It is refused before anything is made of that size: 2¹⁶ unknowns in one cell have 2³¹ + 2¹⁵ pairs.
    #[test]
    fn too_many_entries() {
        let cell = |_: usize| vec![CellBlock { block: 0, start: 0 }];
        let error = Lower::new(vec![0, 1 << 16], 1, &cell).unwrap_err();
        assert!(
            error.to_string().contains("65536 unknowns are too many"),
            "{error}"
        );
    }
}

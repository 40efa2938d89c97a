//! The upper triangle of a sparse symmetric matrix in compressed columns, assembled block by block in the cells' order.

use nalgebra::DMatrix;

/// The upper triangle of a symmetric matrix whose pattern consists of blocks: all pairs of unknowns whose blocks share
/// a cell.
#[derive(Clone, Debug)]
pub(crate) struct Upper {
    /// The first entry of each column, and the number of all of them.
    pub columns: Vec<usize>,
    /// The row of each entry, ascending in a column.
    pub rows: Vec<usize>,
    /// The entries.
    pub values: Vec<f64>,
    /// The first unknown of each block, and the number of all of them.
    offsets: Vec<usize>,
    /// For each block of columns, the blocks of rows above it, ascending, and where each begins in a column.
    above: Vec<Vec<(u32, u32)>>,
}

/// A block of unknowns as a cell sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CellBlock {
    /// Which of the matrix' blocks.
    pub block: usize,
    /// Where it begins in the cell's matrix.
    pub start: usize,
}

impl Upper {
    /// The pattern of all pairs of unknowns that share a cell, with values zero. Block b has the unknowns
    /// `offsets[b]..offsets[b + 1]`; `blocks` tells those of a cell, of which there are `cells`.
    pub fn new(
        offsets: Vec<usize>,
        cells: usize,
        blocks: &dyn Fn(usize) -> Vec<CellBlock>,
    ) -> Self {
        let mut above = neighbours(offsets.len() - 1, cells, blocks);
        let (mut columns, mut rows) = (vec![0], Vec::new());
        for (block, list) in above.iter_mut().enumerate() {
            let mut begin = 0;
            for (other, start) in list.iter_mut() {
                *start = begin;
                begin += (offsets[*other as usize + 1] - offsets[*other as usize]) as u32;
            }
            for column in offsets[block]..offsets[block + 1] {
                for &(other, _) in list.iter() {
                    rows.extend(offsets[other as usize]..offsets[other as usize + 1]);
                }
                rows.extend(offsets[block]..=column);
                columns.push(rows.len());
            }
        }
        Self {
            values: vec![0.0; rows.len()],
            columns,
            rows,
            offsets,
            above,
        }
    }

    /// Adds a cell's symmetric matrix, of which the lower triangle is read.
    pub fn add(&mut self, cell: &[CellBlock], local: &DMatrix<f64>) {
        for to in cell {
            for from in cell.iter().filter(|from| from.block <= to.block) {
                let begin = self.begin(from.block, to.block);
                for c in 0..self.width(to.block) {
                    let first = self.columns[self.offsets[to.block] + c] + begin;
                    let width = match from.block == to.block {
                        true => c + 1,
                        false => self.width(from.block),
                    };
                    for r in 0..width {
                        let (a, b) = (from.start + r, to.start + c);
                        self.values[first + r] += local[(a.max(b), a.min(b))];
                    }
                }
            }
        }
    }

    /// xᵀ A x.
    pub fn energy(&self, x: &[f64]) -> f64 {
        let of_column = |(c, x_c): (usize, &f64)| {
            let entries = self.columns[c]..self.columns[c + 1];
            let products = entries.map(|i| match self.rows[i] {
                row if row == c => self.values[i] * x_c,
                row => 2.0 * self.values[i] * x[row],
            });
            x_c * products.sum::<f64>()
        };
        x.iter().enumerate().map(of_column).sum()
    }

    /// How many unknowns a block has.
    fn width(&self, block: usize) -> usize {
        self.offsets[block + 1] - self.offsets[block]
    }

    /// Where a block of rows begins in the columns of a block.
    fn begin(&self, rows: usize, columns: usize) -> usize {
        if rows == columns {
            // The diagonal block comes after all the others; the first of its columns has one entry of it.
            let column = self.offsets[columns];
            return self.columns[column + 1] - self.columns[column] - 1;
        }
        let list = &self.above[columns];
        let position = list
            .binary_search_by_key(&(rows as u32), |entry| entry.0)
            .expect("blocks that share a cell are in the pattern");
        list[position].1 as usize
    }
}

/// For each block the earlier blocks that share a cell with it, ascending.
fn neighbours(
    count: usize,
    cells: usize,
    blocks: &dyn Fn(usize) -> Vec<CellBlock>,
) -> Vec<Vec<(u32, u32)>> {
    let mut above = vec![Vec::new(); count];
    for cell in 0..cells {
        let blocks = blocks(cell);
        for column in &blocks {
            let earlier = blocks.iter().filter(|row| row.block < column.block);
            above[column.block].extend(earlier.map(|row| (row.block as u32, 0)));
        }
    }
    for list in &mut above {
        list.sort_unstable();
        list.dedup();
        list.shrink_to_fit();
    }
    above
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
        let mut upper = Upper::new(offsets.clone(), 2, &|cell| cells[cell].clone());
        let mut expected = DMatrix::zeros(5, 5);
        for (i, cell) in cells.iter().enumerate() {
            let local = DMatrix::from_fn(3, 3, |a, b| ((i + 1) * (a * b + a + b)) as f64);
            upper.add(cell, &local);
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
            for i in upper.columns[column]..upper.columns[column + 1] {
                found[(upper.rows[i], column)] = upper.values[i];
            }
        }
        // Unknowns 0 and 1 do not meet 3 and 4: that is all that the pattern leaves out.
        assert_eq!(upper.rows.len(), 15 - 4);
        assert_eq!(found, expected.upper_triangle());
        let x = [1.0, -2.0, 0.5, 3.0, -1.0];
        let vector = DMatrix::from_column_slice(5, 1, &x);
        let energy = (vector.transpose() * expected * vector)[(0, 0)];
        assert!((upper.energy(&x) - energy).abs() < 1e-12);
    }
}

//! Which blocks of unknowns meet in a cell.

use std::ops::Range;

/// A block of unknowns as a cell sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct CellBlock {
    /// Which of the matrix' blocks.
    pub block: usize,
    /// Where it begins in the cell's matrix.
    pub start: usize,
}

/// A block of rows, and where it begins in a column.
pub(super) type Begin = (u32, u32);

/// For each block the later blocks that share a cell with it, ascending: lists, one behind the other.
#[derive(Clone, Debug)]
pub(super) struct Neighbours {
    /// Where each list begins, and where the last one ends.
    begins: Vec<usize>,
    entries: Vec<Begin>,
}

impl Neighbours {
    /// Of so many blocks; `blocks` tells those of a cell, of which there are `cells`. The places in the columns are not known yet.
    pub fn new(count: usize, cells: usize, blocks: &dyn Fn(usize) -> Vec<CellBlock>) -> Self {
        let later = |cell: usize, see: &mut dyn FnMut(usize, u32)| {
            let blocks = blocks(cell);
            for column in &blocks {
                for row in blocks.iter().filter(|row| row.block > column.block) {
                    see(column.block, row.block as u32);
                }
            }
        };
        let mut begins = vec![0; count + 1];
        for cell in 0..cells {
            later(cell, &mut |column, _| begins[column + 1] += 1);
        }
        for i in 0..count {
            begins[i + 1] += begins[i];
        }
        let (mut entries, mut ends) = (vec![(0, 0); begins[count]], begins.clone());
        for cell in 0..cells {
            later(cell, &mut |column, row| {
                entries[ends[column]].0 = row;
                ends[column] += 1;
            });
        }
        let mut lists = Self { begins, entries };
        lists.sort();
        lists
    }

    /// Sorts each list, and keeps one of those that are equal: blocks of a face share two cells.
    fn sort(&mut self) {
        let mut kept = 0;
        for i in 0..self.len() {
            let list = self.range(i);
            self.entries[list.clone()].sort_unstable();
            let begin = std::mem::replace(&mut self.begins[i], kept);
            for j in list {
                if j == begin || self.entries[j] != self.entries[kept - 1] {
                    self.entries[kept] = self.entries[j];
                    kept += 1;
                }
            }
        }
        *self.begins.last_mut().expect("the end of the lists") = kept;
        self.entries.truncate(kept);
        self.entries.shrink_to_fit();
    }

    /// How many blocks.
    pub fn len(&self) -> usize {
        self.begins.len() - 1
    }

    /// The other way round.
    pub fn earlier(&self) -> Earlier {
        let mut begins = vec![0; self.len() + 1];
        for &(row, _) in &self.entries {
            begins[row as usize + 1] += 1;
        }
        for i in 0..self.len() {
            begins[i + 1] += begins[i];
        }
        let (mut blocks, mut ends) = (vec![0; self.entries.len()], begins.clone());
        for block in 0..self.len() {
            for &(row, _) in self.of(block) {
                blocks[ends[row as usize]] = block as u32;
                ends[row as usize] += 1;
            }
        }
        Earlier { begins, blocks }
    }

    /// The list of a block.
    pub fn of(&self, block: usize) -> &[Begin] {
        &self.entries[self.range(block)]
    }

    /// The list of a block.
    pub fn of_mut(&mut self, block: usize) -> &mut [Begin] {
        let list = self.range(block);
        &mut self.entries[list]
    }

    fn range(&self, block: usize) -> Range<usize> {
        self.begins[block]..self.begins[block + 1]
    }
}

/// For each block the earlier blocks that share a cell with it, ascending: lists, one behind the other.
#[derive(Clone, Debug)]
pub(super) struct Earlier {
    /// Where each list begins, and where the last one ends.
    pub begins: Vec<usize>,
    pub blocks: Vec<u32>,
}

impl Earlier {
    /// The list of a block.
    pub fn of(&self, block: usize) -> &[u32] {
        &self.blocks[self.begins[block]..self.begins[block + 1]]
    }
}

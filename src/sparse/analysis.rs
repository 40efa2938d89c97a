//! Where the factor of a matrix of blocks has entries.
//!
//! faer's analysis counts the entries of L one by one. All columns of a block have the same rows below it, in A and so in L: here the
//! blocks of L are counted, of which there are fewer by the square of their width, and faer is told what came out.

use super::lower::Lower;
use super::neighbours::Earlier;
use super::{memory, refused};
use crate::Error;
use faer::dyn_stack::{MemStack, StackReq};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::cholesky::simplicial::{
    prefactorize_symbolic_cholesky, prefactorize_symbolic_cholesky_scratch,
};
use faer::sparse::linalg::cholesky::supernodal::{
    SymbolicSupernodalCholesky, factorize_supernodal_symbolic_cholesky,
    factorize_supernodal_symbolic_cholesky_scratch,
};

/// The root of a tree has no parent.
const NONE: u32 = u32::MAX;

/// The pattern of the factor L of a matrix with at least one row, its columns gathered where they have the same rows.
///
/// # Errors
/// If memory does not suffice, or L has more entries than short indices can tell apart.
pub(super) fn analyse(matrix: &Lower) -> Result<SymbolicSupernodalCholesky<u32>, Error> {
    let n = matrix.columns.len() - 1;
    let earlier = matrix.below.earlier();
    let tree = Tree::new(&matrix.offsets, &earlier);
    let edges = tree.edges(&matrix.offsets);
    // One row of a block says that all of its columns have entries here.
    let mut pattern = Pattern::default();
    for block in 0..matrix.below.len() {
        for _ in matrix.unknowns(block) {
            let rows = earlier.of(block).iter();
            pattern.push(rows.map(|&row| matrix.offsets[row as usize] as u32));
        }
    }
    let mut memory = memory(
        n,
        StackReq::or(
            prefactorize_symbolic_cholesky_scratch::<u32>(n, edges.rows.len()),
            factorize_supernodal_symbolic_cholesky_scratch::<u32>(n),
        ),
    )?;
    let stack = MemStack::new(&mut memory);
    let (mut parents, mut of_edges) = (vec![0; n], vec![0; n]);
    let parents = prefactorize_symbolic_cholesky(&mut parents, &mut of_edges, edges.view(), stack);
    let (counts, params) = (tree.counts(&matrix.offsets), Default::default());
    factorize_supernodal_symbolic_cholesky(pattern.view(), parents, &counts, stack, params)
        .map_err(|error| refused(n, error))
}

/// The tree of elimination of the blocks, and how many rows L has below each.
struct Tree {
    /// The first block of rows below each block, in L; or [`NONE`].
    parents: Vec<u32>,
    below: Vec<u32>,
}

impl Tree {
    /// Of blocks whose unknowns begin at `offsets`: block j is a row of L in the columns of the earlier ones that it meets in A, and of
    /// all between these and j in the tree.
    fn new(offsets: &[usize], earlier: &Earlier) -> Self {
        let count = offsets.len() - 1;
        let (mut parents, mut below) = (vec![NONE; count], vec![0; count]);
        let mut seen = vec![NONE; count];
        for j in 0..count {
            let width = (offsets[j + 1] - offsets[j]) as u32;
            seen[j] = j as u32;
            for &first in earlier.of(j) {
                let mut i = first as usize;
                while seen[i] != j as u32 {
                    if parents[i] == NONE {
                        parents[i] = j as u32;
                    }
                    below[i] += width;
                    seen[i] = j as u32;
                    i = parents[i] as usize;
                }
            }
        }
        Self { parents, below }
    }

    /// How many entries each column of L has.
    fn counts(&self, offsets: &[usize]) -> Vec<u32> {
        let of_block = |(block, below): (usize, &u32)| {
            let (below, width) = (*below, (offsets[block + 1] - offsets[block]) as u32);
            (0..width).map(move |column| width - column + below)
        };
        self.below.iter().enumerate().flat_map(of_block).collect()
    }

    /// A matrix that has this tree, and nothing but its edges: the parent of a column is the next one of its block, that of the last is
    /// the first of the parent's.
    fn edges(&self, offsets: &[usize]) -> Pattern {
        let mut children = vec![Vec::new(); self.parents.len()];
        for (child, &parent) in self.parents.iter().enumerate() {
            if parent != NONE {
                children[parent as usize].push(offsets[child + 1] as u32 - 1);
            }
        }
        let mut edges = Pattern::default();
        for (block, children) in children.into_iter().enumerate() {
            edges.push(children);
            for column in offsets[block] + 1..offsets[block + 1] {
                edges.push([column as u32 - 1]);
            }
        }
        edges
    }
}

/// Where a triangle above the diagonal has entries.
struct Pattern {
    columns: Vec<u32>,
    rows: Vec<u32>,
}

impl Default for Pattern {
    /// Without columns.
    fn default() -> Self {
        Self {
            columns: vec![0],
            rows: Vec::new(),
        }
    }
}

impl Pattern {
    /// One more column.
    fn push(&mut self, rows: impl IntoIterator<Item = u32>) {
        self.rows.extend(rows);
        self.columns.push(self.rows.len() as u32);
    }

    fn view(&self) -> SymbolicSparseColMatRef<'_, u32> {
        let n = self.columns.len() - 1;
        SymbolicSparseColMatRef::new_checked(n, n, &self.columns, None, &self.rows)
    }
}

#[cfg(test)]
mod tests {
    use super::super::CellBlock;
    use super::*;
    use crate::mesh::SplitMix64;
    use faer::Side;
    use faer::sparse::linalg::SupernodalThreshold;
    use faer::sparse::linalg::cholesky::{
        CholeskySymbolicParams, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
    };

    /// The same pattern as faer's analysis of all entries of the matrix, for blocks of widths 1 to 4 that meet at random, some of them
    /// in no cell with others.
    #[test]
    fn the_pattern_is_that_of_all_entries() {
        for seed in 0..20 {
            let mut random = SplitMix64::new(seed);
            let mut below = |n: usize| ((random.symmetric() + 1.0) / 2.0 * n as f64) as usize % n;
            let mut offsets = vec![0];
            for block in 0..60 {
                offsets.push(offsets[block] + 1 + below(4));
            }
            let cells: Vec<Vec<CellBlock>> = (0..40)
                .map(|_| {
                    let mut blocks = [below(60), below(60), below(60)].to_vec();
                    blocks.sort_unstable();
                    blocks.dedup();
                    let seen = blocks.iter().map(|&block| CellBlock { block, start: 0 });
                    seen.collect()
                })
                .collect();
            let matrix = Lower::new(offsets, cells.len(), &|cell| cells[cell].clone()).unwrap();
            let found = analyse(&matrix).unwrap();
            let mut rows = vec![Vec::new(); found.nrows()];
            for column in 0..rows.len() {
                for i in matrix.columns[column] as usize..matrix.columns[column + 1] as usize {
                    rows[matrix.rows[i] as usize].push(column as u32);
                }
            }
            let mut whole = Pattern::default();
            rows.into_iter().for_each(|row| whole.push(row));
            let params = CholeskySymbolicParams {
                supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
                ..Default::default()
            };
            let order = SymmetricOrdering::Identity;
            let all =
                factorize_symbolic_cholesky(whole.view(), Side::Upper, order, params).unwrap();
            let SymbolicCholeskyRaw::Supernodal(all) = all.raw() else {
                panic!("it was forced to");
            };
            assert_eq!(found.supernode_begin(), all.supernode_begin(), "{seed}");
            assert_eq!(found.col_ptr_for_val(), all.col_ptr_for_val(), "{seed}");
            assert_eq!(found.row_idx(), all.row_idx(), "{seed}");
        }
    }
}

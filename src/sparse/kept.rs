//! Unknowns that are kept, of all degrees of freedom of a space.

use super::neighbours::CellBlock;
use super::upper::Upper;
use crate::Error;

/// No unknown.
const NONE: usize = usize::MAX;

/// Which degrees of freedom are unknowns, each a block of its own.
#[derive(Debug)]
pub(crate) struct Kept {
    /// The number of each degree of freedom.
    number: Vec<usize>,
    /// The degree of freedom of each unknown.
    dofs: Vec<usize>,
}

impl Kept {
    /// Of so many degrees of freedom those for which this holds.
    pub fn new(len: usize, is_kept: impl Fn(usize) -> bool) -> Self {
        let dofs: Vec<usize> = (0..len).filter(|&dof| is_kept(dof)).collect();
        let mut number = vec![NONE; len];
        for (i, &dof) in dofs.iter().enumerate() {
            number[dof] = i;
        }
        Self { number, dofs }
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.dofs.is_empty()
    }

    /// A cell's degrees of freedom that are unknowns.
    pub fn blocks(&self, dofs: impl Iterator<Item = usize>) -> Vec<CellBlock> {
        let numbers = dofs.map(|dof| self.number[dof]).enumerate();
        let kept = numbers.filter(|&(_, block)| block != NONE);
        kept.map(|(start, block)| CellBlock { block, start })
            .collect()
    }

    /// A matrix of the unknowns, zero; `blocks` are those of a cell.
    ///
    /// # Errors
    /// As [`Upper::new`].
    pub fn matrix(
        &self,
        cells: usize,
        blocks: &dyn Fn(usize) -> Vec<CellBlock>,
    ) -> Result<Upper, Error> {
        Upper::new((0..=self.dofs.len()).collect(), cells, blocks)
    }

    /// The entries of the unknowns.
    pub fn gather(&self, all: &[f64]) -> Vec<f64> {
        self.dofs.iter().map(|&dof| all[dof]).collect()
    }

    /// The entries of all degrees of freedom; 0 where there is no unknown.
    pub fn scatter(&self, unknowns: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.number.len()];
        for (&dof, x) in self.dofs.iter().zip(unknowns) {
            all[dof] = *x;
        }
        all
    }
}

//! Unknowns that are kept, of all degrees of freedom of a space, in an order of elimination with little fill.

use super::lower::{Lower, too_large};
use super::neighbours::{CellBlock, Neighbours};
use super::{memory, refused};
use crate::Error;
use faer::dyn_stack::MemStack;
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

/// No unknown.
const NONE: usize = usize::MAX;

/// Which degrees of freedom are unknowns, each a block of its own. Their order is that of an approximate minimum degree, which needs no
/// coordinates.
#[derive(Debug)]
pub(crate) struct Kept {
    /// The number of each degree of freedom.
    number: Vec<usize>,
    /// The degree of freedom of each unknown.
    dofs: Vec<usize>,
}

impl Kept {
    /// Of so many degrees of freedom those for which this holds; `dofs` tells those of a cell, of which there are `cells`.
    ///
    /// # Errors
    /// If memory does not suffice, or there are more pairs of unknowns than short indices can tell apart.
    pub fn new<D: Iterator<Item = usize>>(
        len: usize,
        is_kept: impl Fn(usize) -> bool,
        cells: usize,
        dofs: impl Fn(usize) -> D,
    ) -> Result<Self, Error> {
        let as_they_come = Self::of((0..len).filter(|&dof| is_kept(dof)).collect(), len);
        if as_they_come.is_empty() {
            return Ok(as_they_come);
        }
        let blocks = |cell| as_they_come.blocks(dofs(cell));
        let neighbours = Neighbours::new(as_they_come.dofs.len(), cells, &blocks);
        let order = minimum_degree(&neighbours)?;
        let kept = order.iter().map(|&i| as_they_come.dofs[i as usize]);
        Ok(Self::of(kept.collect(), len))
    }

    /// These, of so many.
    fn of(dofs: Vec<usize>, len: usize) -> Self {
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
    /// As [`Lower::new`].
    pub fn matrix(
        &self,
        cells: usize,
        blocks: &dyn Fn(usize) -> Vec<CellBlock>,
    ) -> Result<Lower, Error> {
        Lower::new((0..=self.dofs.len()).collect(), cells, blocks)
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

/// An order of elimination: the unknown that comes first, and so on.
fn minimum_degree(neighbours: &Neighbours) -> Result<Vec<u32>, Error> {
    let n = neighbours.len();
    let earlier = neighbours.earlier();
    // The solver's indices have a sign.
    if earlier.blocks.len() > i32::MAX as usize {
        return Err(too_large(n));
    }
    let columns: Vec<u32> = earlier.begins.iter().map(|&begin| begin as u32).collect();
    let pattern = SymbolicSparseColMatRef::new_checked(n, n, &columns, None, &earlier.blocks);
    let (mut order, mut ranks) = (vec![0; n], vec![0; n]);
    let mut memory = memory(n, amd::order_scratch::<u32>(n, earlier.blocks.len()))?;
    let stack = MemStack::new(&mut memory);
    amd::order(&mut order, &mut ranks, pattern, Default::default(), stack)
        .map_err(|error| refused(n, error))?;
    Ok(order)
}

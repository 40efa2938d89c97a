//! One function of the basis, as a field of its own.

use super::function::with_derivatives;
use super::regge::ReggeSpace;
use crate::field::{Evaluate, TensorField};
use crate::jet::{Jet1, Jet2};
use crate::linalg::Mat;
use crate::scalar::{Number, Real};
use crate::simplex::{JetTable, Points};

/// ψ_i: the Regge function whose i-th coefficient is 1 and all others 0, without the vector of them.
#[derive(Clone, Debug)]
pub struct BasisFunction<const N: usize> {
    space: ReggeSpace<N>,
    index: usize,
}

impl<const N: usize> BasisFunction<N> {
    /// ψ_i; for i beyond the dimension, 0.
    pub fn new(space: &ReggeSpace<N>, index: usize) -> Self {
        Self {
            space: space.clone(),
            index,
        }
    }
}

impl<T: Real, const N: usize> Evaluate<T, N> for BasisFunction<N> {
    type Table = JetTable<T, N>;
    type Local = Vec<f64>;

    fn tabulate(&self, points: &Points) -> Self::Table {
        JetTable::new(self.space.degree(), points)
    }

    fn on_cell(&self, cell: usize) -> Vec<f64> {
        let space = &self.space;
        let slots = space.slots().iter().flatten();
        let is_mine = |slot| space.numbering().of_cell(space.mesh(), cell, slot) == self.index;
        let edges: Vec<f64> = slots
            .map(|&slot| f64::from(u8::from(is_mine(slot))))
            .collect();
        with_derivatives(space, &edges)
    }

    fn jet2(&self, local: &Vec<f64>, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        table.tensor2(block, local)
    }

    fn jet1(&self, local: &Vec<f64>, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        table.tensor1(block, local)
    }

    fn value(&self, local: &Vec<f64>, table: &Self::Table, block: usize) -> Mat<T, N> {
        table.tensor(block, local)
    }

    fn is_constant(&self) -> bool {
        self.space.degree() == 0
    }
}

impl<const N: usize> TensorField<N> for BasisFunction<N> {
    type Scalar = f64;
    type Wide = <f64 as Number>::Wide;
}

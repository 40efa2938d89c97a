//! One function of the basis, as a field of its own.

use super::{ReggeFunction, ReggeSpace, components_from_edges};
use crate::field::TensorField;
use crate::jet::{Jet1, Jet2};
use crate::linalg::Mat;
use crate::scalar::Real;
use crate::simplex::{JetTable, Points};

/// ψ_i: the Regge function whose i-th coefficient is 1 and all others 0, without the vector of them.
#[derive(Clone, Copy, Debug)]
pub struct BasisFunction<'s, const N: usize> {
    space: &'s ReggeSpace<'s, N>,
    index: usize,
}

impl<'s, const N: usize> BasisFunction<'s, N> {
    /// ψ_i; for i beyond the dimension, 0.
    pub fn new(space: &'s ReggeSpace<'s, N>, index: usize) -> Self {
        Self { space, index }
    }

    /// What Regge functions do, for this one.
    fn empty(&self) -> ReggeFunction<'s, f64, N> {
        ReggeFunction {
            space: self.space,
            coefficients: Vec::new(),
        }
    }
}

impl<T: Real, const N: usize> TensorField<T, N> for BasisFunction<'_, N> {
    type Table = JetTable<T, N>;
    type Local = Vec<f64>;

    fn tabulate(&self, points: &Points) -> Self::Table {
        TensorField::<T, N>::tabulate(&self.empty(), points)
    }

    fn on_cell(&self, cell: usize) -> Vec<f64> {
        let space = self.space;
        let slots = space.slots.iter().flatten();
        let is_mine = |slot| space.numbering.of_cell(space.mesh, cell, slot) == self.index;
        let mut local: Vec<f64> = slots
            .map(|&slot| f64::from(u8::from(is_mine(slot))))
            .collect();
        components_from_edges::<f64, N>(&mut local);
        local
    }

    fn jet2(&self, local: &Vec<f64>, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        self.empty().jet2(local, table, block)
    }

    fn jet1(&self, local: &Vec<f64>, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        self.empty().jet1(local, table, block)
    }

    fn value(&self, local: &Vec<f64>, table: &Self::Table, block: usize) -> Mat<T, N> {
        self.empty().value(local, table, block)
    }

    fn is_constant(&self) -> bool {
        self.space.degree == 0
    }
}

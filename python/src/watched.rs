//! Floor 3. A field that tells when a cell is begun: so any loop over cells can be stopped, and its progress told.

use crate::job::Watch;
use regge_curvature::TensorField;
use regge_curvature::field::{Ambient, Evaluate};
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::Mat;
use regge_curvature::scalar::Real;
use regge_curvature::simplex::Points;

/// The same field, watched.
pub struct Watched<'w, A> {
    field: A,
    watch: &'w Watch,
}

impl<'w, A> Watched<'w, A> {
    /// Watched by this watch.
    pub fn new(field: A, watch: &'w Watch) -> Self {
        Self { field, watch }
    }
}

impl<T: Real, const N: usize, A: Evaluate<T, N>> Evaluate<T, N> for Watched<'_, A> {
    type Table = A::Table;
    type Local = A::Local;

    fn tabulate(&self, points: &Points) -> Self::Table {
        self.field.tabulate(points)
    }
    #[inline]
    fn on_cell(&self, cell: usize) -> Self::Local {
        self.watch.step();
        self.field.on_cell(cell)
    }
    #[inline]
    fn jet2(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        self.field.jet2(local, table, block)
    }
    #[inline]
    fn jet1(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        self.field.jet1(local, table, block)
    }
    #[inline]
    fn value(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<T, N> {
        self.field.value(local, table, block)
    }
    fn is_constant(&self) -> bool {
        self.field.is_constant()
    }
    fn ambient(&self) -> Option<&dyn Ambient<N>> {
        self.field.ambient()
    }
}

impl<const N: usize, A: TensorField<N>> TensorField<N> for Watched<'_, A> {
    type Scalar = A::Scalar;
    type Wide = A::Wide;
}

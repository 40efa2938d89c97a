//! Floor 2. Symmetric (0,2)-tensor fields, smooth on each cell, by their jets in the cell's reference coordinates.
//!
//! This is all that the functionals know of a metric g or of its variation σ. A Regge function, a formula, or a
//! combination (1−t) g + t g_h are such fields.

use crate::jet::{Jet1, Jet2, lower};
use crate::linalg::Mat;
use crate::scalar::Real;
use crate::simplex::Points;

/// A piecewise smooth symmetric tensor field with scalar T, by cells.
///
/// Evaluation has three steps, each done as rarely as it can be: once for a set of points
/// ([`TensorField::tabulate`]), once for a cell ([`TensorField::on_cell`]), and for each block of `T::LANES` points.
pub trait TensorField<T: Real, const N: usize>: Sync {
    /// What can be prepared from the points alone.
    type Table: Sync;
    /// What can be prepared from the cell alone.
    type Local;

    /// Prepares points, given by barycentric coordinates in the cell.
    fn tabulate(&self, points: &Points) -> Self::Table;
    /// Prepares a cell.
    fn on_cell(&self, cell: usize) -> Self::Local;

    /// Components `[(i, j)]` in reference coordinates with first and second derivatives at a block of points.
    fn jet2(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N>;

    /// With first derivatives only.
    fn jet1(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        lower(&self.jet2(local, table, block))
    }

    /// The components alone.
    fn value(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<T, N> {
        lower(&self.jet1(local, table, block))
    }

    /// Known to be constant on every cell? Then R and H vanish and need not be computed.
    fn is_constant(&self) -> bool {
        false
    }

    /// The field at the points of ℝ^N, where it has a formula there: what follows curves through the cells needs it.
    fn ambient(&self) -> Option<&dyn Ambient<N>> {
        None
    }
}

/// A symmetric tensor field on a part of ℝ^N, which needs no mesh. Every
/// [`SmoothTensor`](crate::metrics::SmoothTensor) is one.
pub trait Ambient<const N: usize>: Sync {
    /// Components `[(a, b)]` in the coordinates of ℝ^N with first and second derivatives at x; None outside of the
    /// field's domain.
    fn jets_at(&self, x: &[f64; N]) -> Option<Mat<Jet2<f64, N>, N>>;
}

impl<T: Real, const N: usize, A: TensorField<T, N>> TensorField<T, N> for &A {
    type Table = A::Table;
    type Local = A::Local;

    fn tabulate(&self, points: &Points) -> Self::Table {
        A::tabulate(self, points)
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        A::on_cell(self, cell)
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        A::jet2(self, local, table, block)
    }
    fn jet1(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        A::jet1(self, local, table, block)
    }
    fn value(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<T, N> {
        A::value(self, local, table, block)
    }
    fn is_constant(&self) -> bool {
        A::is_constant(self)
    }
    fn ambient(&self) -> Option<&dyn Ambient<N>> {
        A::ambient(self)
    }
}

/// α a + β b.
#[derive(Clone, Copy, Debug)]
pub struct Combination<A, B, T> {
    /// a.
    pub a: A,
    /// b.
    pub b: B,
    /// (α, β); a derivative part in them is a variation: 1 and ε for d/dt of a + t b at t = 0.
    pub factors: (T, T),
}

impl<A, B, T: Real> Combination<A, B, T> {
    /// α a + β b.
    pub fn new(alpha: T, a: A, beta: T, b: B) -> Self {
        Self {
            a,
            b,
            factors: (alpha, beta),
        }
    }

    /// (1−t) a + t b, the segment g̃(t) of the paper.
    pub fn segment(a: A, b: B, t: T) -> Self {
        Self::new(T::one() - t, a, t, b)
    }
}

impl<T: Real, const N: usize, A: TensorField<T, N>, B: TensorField<T, N>> TensorField<T, N>
    for Combination<A, B, T>
{
    type Table = (A::Table, B::Table);
    type Local = (A::Local, B::Local);

    fn tabulate(&self, points: &Points) -> Self::Table {
        (self.a.tabulate(points), self.b.tabulate(points))
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        (self.a.on_cell(cell), self.b.on_cell(cell))
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        let a = self.a.jet2(&local.0, &table.0, block);
        let b = self.b.jet2(&local.1, &table.1, block);
        a.zip_map(&b, |a, b| {
            a.map(|x| self.factors.0 * x) + b.map(|x| self.factors.1 * x)
        })
    }
    fn jet1(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        let a = self.a.jet1(&local.0, &table.0, block);
        let b = self.b.jet1(&local.1, &table.1, block);
        a.zip_map(&b, |a, b| {
            a.map(|x| self.factors.0 * x) + b.map(|x| self.factors.1 * x)
        })
    }
    fn value(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<T, N> {
        let a = self.a.value(&local.0, &table.0, block);
        let b = self.b.value(&local.1, &table.1, block);
        a.zip_map(&b, |a, b| self.factors.0 * a + self.factors.1 * b)
    }
    fn is_constant(&self) -> bool {
        self.a.is_constant() && self.b.is_constant()
    }
}

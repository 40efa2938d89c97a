//! Floor 2. Symmetric (0,2)-tensor fields, smooth on each cell, by their jets in the cell's reference coordinates.
//!
//! This is all that the functionals know of a metric g or of its variation σ. A Regge function, a formula, or a
//! combination (1−t) g + t g_h are such fields.

use crate::jet::{Jet1, Jet2, lower};
use crate::linalg::Mat;
use crate::scalar::{Lift, Number, Real};
use crate::simplex::Points;

/// How a field is evaluated in the scalar T, cell by cell.
///
/// Evaluation has three steps, each done as rarely as it can be: once for a set of points
/// ([`Evaluate::tabulate`]), once for a cell ([`Evaluate::on_cell`]), and for each block of `T::LANES` points.
/// A *block* is the points that one value of T holds: one point for most scalars, four for lanes; the last block of a set is
/// filled up with its last point.
pub trait Evaluate<T: Real, const N: usize>: Sync {
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
}

/// A piecewise smooth symmetric tensor field on the cells of a mesh, and the scalars that functionals of it compute with.
///
/// A field of your own implements [`Evaluate`] for all scalars T and takes `f64` and [`Number::Wide`] of it here:
/// `type Scalar = f64; type Wide = <f64 as Number>::Wide;`. One that knows a single scalar takes it twice.
pub trait TensorField<const N: usize>: Evaluate<Self::Scalar, N> + Evaluate<Self::Wide, N> {
    /// What sums over the mesh are made of: `f64`, or a dual number for derivatives in the field.
    type Scalar: Real<Sum = Self::Scalar>;
    /// The scalar in which quadrature points are evaluated side by side; the same where there is none wider.
    type Wide: Real<Sum = Self::Scalar>;
}

impl<T: Real, const N: usize, A: Evaluate<T, N>> Evaluate<T, N> for &A {
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
}

impl<const N: usize, A: TensorField<N>> TensorField<N> for &A {
    type Scalar = A::Scalar;
    type Wide = A::Wide;
}

/// The same field, evaluated at one point at a time: without lanes.
#[derive(Clone, Copy, Debug)]
pub struct PointByPoint<A>(pub A);

impl<T: Real, const N: usize, A: Evaluate<T, N>> Evaluate<T, N> for PointByPoint<A> {
    type Table = A::Table;
    type Local = A::Local;

    fn tabulate(&self, points: &Points) -> Self::Table {
        self.0.tabulate(points)
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        self.0.on_cell(cell)
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        self.0.jet2(local, table, block)
    }
    fn jet1(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        self.0.jet1(local, table, block)
    }
    fn value(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<T, N> {
        self.0.value(local, table, block)
    }
    fn is_constant(&self) -> bool {
        self.0.is_constant()
    }
}

impl<const N: usize, A: TensorField<N>> TensorField<N> for PointByPoint<A> {
    type Scalar = A::Scalar;
    type Wide = A::Scalar;
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

impl<T, S, const N: usize, A, B> Evaluate<S, N> for Combination<A, B, T>
where
    T: Real + Lift<S>,
    S: Real,
    A: Evaluate<S, N>,
    B: Evaluate<S, N>,
{
    type Table = (A::Table, B::Table);
    type Local = (A::Local, B::Local);

    fn tabulate(&self, points: &Points) -> Self::Table {
        (self.a.tabulate(points), self.b.tabulate(points))
    }
    fn on_cell(&self, cell: usize) -> Self::Local {
        (self.a.on_cell(cell), self.b.on_cell(cell))
    }
    fn jet2(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<S, N>, N> {
        let a = self.a.jet2(&local.0, &table.0, block);
        let b = self.b.jet2(&local.1, &table.1, block);
        let (alpha, beta) = (self.factors.0.lift(), self.factors.1.lift());
        a.zip_map(&b, |a, b| a.map(|x| alpha * x) + b.map(|x| beta * x))
    }
    fn jet1(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<S, N>, N> {
        let a = self.a.jet1(&local.0, &table.0, block);
        let b = self.b.jet1(&local.1, &table.1, block);
        let (alpha, beta) = (self.factors.0.lift(), self.factors.1.lift());
        a.zip_map(&b, |a, b| a.map(|x| alpha * x) + b.map(|x| beta * x))
    }
    fn value(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<S, N> {
        let a = self.a.value(&local.0, &table.0, block);
        let b = self.b.value(&local.1, &table.1, block);
        let (alpha, beta) = (self.factors.0.lift(), self.factors.1.lift());
        a.zip_map(&b, |a, b| alpha * a + beta * b)
    }
    fn is_constant(&self) -> bool {
        self.a.is_constant() && self.b.is_constant()
    }
}

impl<T, const N: usize, A, B> TensorField<N> for Combination<A, B, T>
where
    T: Number,
    A: Evaluate<T, N> + Evaluate<T::Wide, N>,
    B: Evaluate<T, N> + Evaluate<T::Wide, N>,
{
    type Scalar = T;
    type Wide = T::Wide;
}

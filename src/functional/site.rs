//! Where the integrals of one dimension take place: the k-simplices of a cell with a rule on them.

use crate::field::TensorField;
use crate::linalg::Vector;
use crate::mesh::Slot;
use crate::parallel::rows_in_order;
use crate::quadrature::Rule;
use crate::scalar::{Field, Real};
use crate::simplex::{Points, subsets};
use crate::spaces::Lagrange;

/// A rule's weights by blocks; lanes beyond the last point weigh nothing.
pub(super) fn weights<T: Real>(rule: &Rule) -> Vec<T> {
    (0..rule.points().blocks::<T>())
        .map(|b| T::pack(|l| rule.weights().get(b * T::LANES + l).copied().unwrap_or(0.0)))
        .collect()
}

/// The k-simplices of a cell, by place: their vertices, the rule's points seen from the cell.
pub(super) struct Sites<T> {
    /// Local vertices, by place.
    pub vertices: Vec<Vec<usize>>,
    /// The rule's points in the cell, by place.
    pub points: Vec<Points>,
    /// The rule's weights by blocks.
    pub weights: Vec<T>,
    /// The trace basis of the test functions at the points, `[block][α]`.
    pub basis: Vec<Vec<T>>,
    /// The numbering of the trace basis, by place.
    pub slots: Vec<Vec<Slot>>,
}

impl<T: Real> Sites<T> {
    /// The k-simplices of an N-simplex.
    pub fn new<const N: usize>(k: usize, rule: &Rule, space: &Lagrange<N>) -> Self {
        let vertices = subsets(N + 1, k + 1);
        Self {
            points: vertices
                .iter()
                .map(|on| rule.points().embed(on, N + 1))
                .collect(),
            slots: vertices.iter().map(|on| space.trace_slots(on)).collect(),
            weights: weights(rule),
            basis: space.basis(k).tabulate(rule.points()),
            vertices,
        }
    }

    /// A field's tables, by place.
    pub fn tables<const N: usize, G: TensorField<T, N>>(&self, field: &G) -> Vec<G::Table> {
        self.points
            .iter()
            .map(|points| field.tabulate(points))
            .collect()
    }

    /// The local vertices that do not belong to the simplex: the faces of the cell that contain it.
    pub fn opposite<const N: usize>(&self, place: usize) -> Vec<usize> {
        (0..=N)
            .filter(|v| !self.vertices[place].contains(v))
            .collect()
    }

    /// The outward covectors of the faces that contain the simplex.
    pub fn outward<const N: usize>(&self, place: usize) -> Vec<Vector<T, N>> {
        self.opposite::<N>(place)
            .into_iter()
            .map(crate::hypersurface::outward)
            .collect()
    }

    /// acc[α] += density · w · B_α at a block of points.
    #[inline]
    pub fn accumulate(&self, block: usize, density: T, acc: &mut [T]) {
        let weighted = density * self.weights[block];
        for (a, b) in acc.iter_mut().zip(&self.basis[block]) {
            *a += weighted * *b;
        }
    }
}

/// Σ over simplices of one dimension of what `local` adds up for the trace basis there.
///
/// The order of the additions is that of the simplices, whatever the threads do.
pub(super) fn sum_over<T: Real, const N: usize>(
    space: &Lagrange<N>,
    sites: &Sites<T>,
    simplices: impl Iterator<Item = usize>,
    local: impl Fn(usize, &mut [T]) + Sync,
) -> Vec<T::Sum> {
    let mesh = space.mesh();
    let k = sites.vertices[0].len() - 1;
    let simplices: Vec<usize> = simplices.collect();
    let mut sum = vec![T::Sum::zero(); space.len()];
    rows_in_order(
        simplices.len(),
        sites.basis[0].len(),
        T::zero(),
        |index, acc| local(simplices[index], acc),
        |index, acc| {
            let side = mesh.first_side(k, simplices[index]);
            for (dof, value) in space.dofs(side.cell, &sites.slots[side.place]).zip(acc) {
                sum[dof] += value.reduce();
            }
        },
    );
    sum
}

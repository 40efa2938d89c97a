//! Fields as the cells around a simplex see them, and integrals of densities that are made of them.

use crate::harness::each;
use regge_curvature::field::Evaluate;
use regge_curvature::functional::integrate;
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::Mat;
use regge_curvature::mesh::{Mesh, Side};
use regge_curvature::quadrature::Rule;
use regge_curvature::scalar::Real;
use regge_curvature::simplex::{Points, subsets};
use regge_curvature::spaces::Lagrange;

/// A field at the points of a rule on the k-simplices of a cell, by place.
pub struct Seen<'a, T: Real, const N: usize, G: Evaluate<T, N>> {
    field: &'a G,
    tables: Vec<G::Table>,
}

/// The points of a rule on the k-simplices of an N-simplex, by place.
pub fn points_of<const N: usize>(k: usize, rule: &Rule) -> Vec<Points> {
    each(&subsets(N + 1, k + 1), |on| rule.points().embed(on, N + 1))
}

impl<'a, T: Real, const N: usize, G: Evaluate<T, N>> Seen<'a, T, N, G> {
    /// Prepares the points.
    pub fn new(field: &'a G, k: usize, rule: &Rule) -> Self {
        let points = points_of::<N>(k, rule);
        Self {
            field,
            tables: each(&points, |p| field.tabulate(p)),
        }
    }

    /// The components with two derivatives.
    pub fn jet2(&self, side: Side, q: usize) -> Mat<Jet2<T, N>, N> {
        let local = self.field.on_cell(side.cell);
        self.field.jet2(&local, &self.tables[side.place], q)
    }

    /// The components with one derivative.
    pub fn jet1(&self, side: Side, q: usize) -> Mat<Jet1<T, N>, N> {
        let local = self.field.on_cell(side.cell);
        self.field.jet1(&local, &self.tables[side.place], q)
    }

    /// The components.
    pub fn value(&self, side: Side, q: usize) -> Mat<T, N> {
        let local = self.field.on_cell(side.cell);
        self.field.value(&local, &self.tables[side.place], q)
    }
}

/// The library's [`integrate`] against Lagrange's functions, compiled once for each scalar and dimension.
pub fn integral<T: Real, const N: usize>(
    space: &Lagrange<N>,
    k: usize,
    rule: &Rule,
    simplices: &mut dyn Iterator<Item = usize>,
    density: &(dyn Fn(usize, Side, usize) -> T + Sync),
) -> Vec<T::Sum> {
    integrate(space, k, rule, simplices, |simplex, side, q| {
        density(simplex, side, q)
    })
}

/// A quantity at every point of every interior simplex of dimension k: as the first cell sees it, and as the last.
pub fn both_sides<const N: usize>(
    mesh: &Mesh<N>,
    k: usize,
    rule: &Rule,
    q: &dyn Fn(Side, usize) -> Vec<f64>,
) -> [Vec<f64>; 2] {
    let mut sides = [Vec::new(), Vec::new()];
    for simplex in mesh.interior(k) {
        let around: Vec<Side> = mesh.star(k, simplex).collect();
        for p in 0..rule.len() {
            sides[0].extend(q(around[0], p));
            sides[1].extend(q(around[around.len() - 1], p));
        }
    }
    sides
}

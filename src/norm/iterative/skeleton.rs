//! The unknowns of the matrix-free solver: u and û of the interior simplices of dimension < N. Bubbles are condensed.
//!
//! All k-simplices have blocks of one width, in the solver's order: first the vertices' blocks, then the edges', and so on.

use super::order::Order;
use crate::mesh::{Mesh, Numbering};
use crate::norm::hhj::layout::{Layout, own, slopes};

/// Where the unknowns are.
#[derive(Clone, Debug)]
pub(super) struct Skeleton {
    /// The order of cells and simplices: numbers of either are places in it, unless they are said to be the mesh's.
    pub order: Order,
    /// How many unknowns a k-simplex has.
    pub widths: Vec<usize>,
    /// The first unknown of the k-simplices; last, the number of all unknowns.
    pub offsets: Vec<usize>,
    /// How many unknowns of a k-simplex are of u; the others are of û.
    own: Vec<usize>,
    /// Where u is in a solution, and where û begins.
    numbering: Numbering,
}

impl Skeleton {
    /// For u of degree p.
    pub fn new<const N: usize>(mesh: &Mesh<N>, p: usize) -> Self {
        let order = Order::new(mesh);
        let own: Vec<usize> = (0..=N).map(|k| own(k, p)).collect();
        let numbering = Numbering::new(mesh, own.clone());
        let (mut widths, mut offsets) = (Vec::new(), vec![0]);
        for (k, layer) in order.layers.iter().enumerate() {
            widths.push(own[k] + if k == N - 1 { slopes(N, p) } else { 0 });
            offsets.push(offsets[k] + widths[k] * layer.free);
        }
        Self {
            order,
            widths,
            offsets,
            own,
            numbering,
        }
    }

    /// How many unknowns.
    pub fn len(&self) -> usize {
        self.offsets[self.widths.len()]
    }

    /// The first unknown of an interior k-simplex.
    #[inline]
    pub fn first(&self, k: usize, simplex: usize) -> usize {
        self.offsets[k] + simplex * self.widths[k]
    }

    /// The unknowns of a cell's k-simplex, by which of them it is; none if it is in ∂Ω.
    #[inline]
    pub fn of_cell(&self, k: usize, cell: usize, which: usize) -> std::ops::Range<usize> {
        let simplex = self.order.layers[k].free_of_cell(cell, which);
        simplex.map_or(0..0, |simplex| self.of_simplex(k, simplex))
    }

    /// The unknowns of a cell's interior simplices, each with its local index.
    pub fn unknowns<'a>(
        &'a self,
        layout: &'a Layout,
        cell: usize,
    ) -> impl Iterator<Item = (usize, usize)> + 'a {
        layout.blocks.iter().flat_map(move |block| {
            let unknowns = self.of_cell(block.k, cell, block.place);
            unknowns.zip(block.start..)
        })
    }

    /// The unknowns of an interior k-simplex.
    #[inline]
    pub fn of_simplex(&self, k: usize, simplex: usize) -> std::ops::Range<usize> {
        let first = self.first(k, simplex);
        first..first + self.widths[k]
    }

    /// The unknowns of all interior k-simplices.
    pub fn layer<'a, T>(&self, k: usize, x: &'a [T]) -> &'a [T] {
        &x[self.offsets[k]..self.offsets[k + 1]]
    }

    /// The unknowns of all interior k-simplices.
    pub fn layer_mut<'a, T>(&self, k: usize, x: &'a mut [T]) -> &'a mut [T] {
        &mut x[self.offsets[k]..self.offsets[k + 1]]
    }

    /// Where in a solution entry i of the mesh's k-simplex is.
    #[inline]
    fn place(&self, k: usize, simplex: usize, i: usize) -> usize {
        match i.checked_sub(self.own[k]) {
            None => self.numbering.global(k, simplex, i),
            Some(beta) => self.numbering.len() + simplex * (self.widths[k] - self.own[k]) + beta,
        }
    }

    /// Where in a solution the bubbles of a cell are.
    pub fn bubbles(&self, cell: usize) -> std::ops::Range<usize> {
        let k = self.widths.len();
        let first = self.numbering.global(k, self.order.cells[cell] as usize, 0);
        first..first + self.own[k]
    }

    /// The load of the unknowns: û has none.
    pub fn gather(&self, load: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.len()];
        for (k, layer) in self.order.layers.iter().enumerate() {
            for (at, &simplex) in layer.simplices[..layer.free].iter().enumerate() {
                for i in 0..self.own[k] {
                    x[self.first(k, at) + i] = load[self.place(k, simplex as usize, i)];
                }
            }
        }
        x
    }

    /// Writes the unknowns to where a solution has them.
    pub fn scatter(&self, x: &[f64], coefficients: &mut [f64]) {
        for (k, layer) in self.order.layers.iter().enumerate() {
            for (at, &simplex) in layer.simplices[..layer.free].iter().enumerate() {
                for i in 0..self.widths[k] {
                    coefficients[self.place(k, simplex as usize, i)] = x[self.first(k, at) + i];
                }
            }
        }
    }
}

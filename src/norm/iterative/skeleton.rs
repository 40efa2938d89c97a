//! The unknowns of the matrix-free solver: u and û of the interior simplices of dimension < N. Bubbles are condensed.
//!
//! All k-simplices have blocks of one width, in the solver's order: first the vertices' blocks, then the edges', and so on.

use super::order::{Layer, Order};
use crate::mesh::{Mesh, Numbering};
use crate::norm::hhj::layout::{Layout, own, slopes};
use crate::parallel::for_parts;
use std::ops::Range;

/// Interior k-simplices next to each other, which a thread works on.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub k: usize,
    pub simplices: Range<usize>,
    /// All cells that contain one of them are among these.
    pub cells: Range<usize>,
}

/// How many simplices a piece has, but for the last ones of a dimension.
const SIMPLICES: usize = 1024;

/// Where the unknowns are.
#[derive(Clone, Debug)]
pub(super) struct Skeleton {
    /// The order of cells and simplices: numbers of either are places in it, unless they are said to be the mesh's.
    pub order: Order,
    /// How many unknowns a k-simplex has.
    pub widths: Vec<usize>,
    /// The first unknown of the k-simplices; last, the number of all unknowns.
    pub offsets: Vec<usize>,
    /// The simplices that have unknowns, in order.
    pub pieces: Vec<Piece>,
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
            pieces: pieces(&order, &widths),
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
    pub fn of_cell(&self, k: usize, cell: usize, which: usize) -> Range<usize> {
        let simplex = self.order.layers[k].free_of_cell(cell, which);
        simplex.map_or(0..0, |simplex| self.of_simplex(k, simplex))
    }

    /// [`Skeleton::of_cell`] for some cells, what they have of a global x.
    #[inline]
    pub fn of_cells<'a, T>(
        &'a self,
        k: usize,
        cells: Range<usize>,
        which: usize,
        x: &'a [T],
    ) -> impl Iterator<Item = &'a [T]> + 'a {
        let (width, x) = (self.widths[k], &x[self.offsets[k]..]);
        let simplices = self.order.layers[k].free_of_cells(cells, which);
        simplices.map(move |simplex| match simplex {
            Some(simplex) => &x[simplex * width..][..width],
            None => &[],
        })
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
    pub fn of_simplex(&self, k: usize, simplex: usize) -> Range<usize> {
        let first = self.first(k, simplex);
        first..first + self.widths[k]
    }

    /// The unknowns of a piece.
    pub fn of_piece<'a, T>(&self, piece: &Piece, x: &'a [T]) -> &'a [T] {
        let begin = self.first(piece.k, piece.simplices.start);
        &x[begin..self.first(piece.k, piece.simplices.end)]
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
    pub fn bubbles(&self, cell: usize) -> Range<usize> {
        let k = self.widths.len();
        let first = self.numbering.global(k, self.order.cells[cell] as usize, 0);
        first..first + self.own[k]
    }

    /// `work(piece, its unknowns of each list)` for all pieces, by several threads.
    pub fn by_pieces<T: Send, const M: usize>(
        &self,
        lists: [&mut [T]; M],
        work: impl Fn(&Piece, [&mut [T]; M]) + Sync,
    ) {
        let lengths = self.pieces.iter();
        let lengths = lengths.map(|piece| piece.simplices.len() * self.widths[piece.k]);
        for_parts(lists, lengths, |i, lists| work(&self.pieces[i], lists));
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

/// The pieces of the dimensions that have unknowns.
fn pieces(order: &Order, widths: &[usize]) -> Vec<Piece> {
    let layers = order.layers.iter().enumerate();
    let with_unknowns = layers.filter(|(k, _)| widths[*k] > 0);
    let pieces = with_unknowns.flat_map(|(k, layer)| of_layer(k, layer));
    pieces.collect()
}

fn of_layer(k: usize, layer: &Layer) -> impl Iterator<Item = Piece> {
    let piece = move |begin: usize| {
        let simplices = begin..layer.free.min(begin + SIMPLICES);
        let last = simplices.clone().map(|simplex| layer.last(simplex)).max();
        // In their order simplices are met by later and later cells.
        let cells = layer.first(begin).0..last.expect("a piece has simplices") + 1;
        Piece {
            k,
            simplices,
            cells,
        }
    };
    (0..layer.free).step_by(SIMPLICES).map(piece)
}

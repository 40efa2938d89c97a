//! The nodes of P_p on a mesh's simplices of dimension < N, each of which is there once, and who has them.
//!
//! A node belongs to the simplex in whose interior it lies; those in ∂Ω are there too. The simplices that use a node are seen
//! from the first of the cells that have them.

use super::patch::Patch;
use super::slabs::Slabs;
use super::stencil::{Grid, Short};
use crate::linalg::Vector;
use crate::mesh::Mesh;
use crate::norm::iterative::order::Order;
use crate::simplex::{multi_indices, subsets};

/// Where a node is in the splines' lattice: the first of the splines that live there, and where in its box it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot<const N: usize> {
    pub first: u32,
    pub at: [Short; N],
}

/// The nodes of a mesh.
#[derive(Clone, Debug)]
pub(super) struct Nodes<const N: usize> {
    pub spots: Vec<Spot<N>>,
    /// The nodes by the planes of splines that live there.
    pub slabs: Slabs,
    /// By dimension, how many a simplex has inside.
    pub own: Vec<usize>,
    /// The first node of the k-simplices.
    pub offsets: Vec<usize>,
    /// By dimension and by which of a cell's simplices it is.
    blocks: Vec<Vec<Block>>,
    /// Cell by cell, of which of its interior simplices it is the first: a bit a block.
    firsts: Vec<u16>,
}

/// One of a cell's simplices.
#[derive(Clone, Debug, Default)]
struct Block {
    /// The nodes on it, in the order of [`multi_indices`].
    nodes: Vec<Place>,
    /// The cell's simplices that have its own nodes too, with the numbers of these among theirs.
    users: Vec<User>,
}

/// A node as a cell sees it: node `index` of one of its k-simplices.
#[derive(Clone, Copy, Debug)]
struct Place {
    k: usize,
    which: usize,
    index: usize,
}

/// A simplex that has another one's own nodes.
#[derive(Clone, Debug)]
pub(super) struct User {
    pub k: usize,
    pub which: usize,
    bit: u16,
    /// By the other's own nodes.
    pub points: Vec<usize>,
}

impl<const N: usize> Nodes<N> {
    /// The nodes of P_p. By dimension `degrees` are those of the nodes that a simplex uses, divisors of p.
    pub fn new(mesh: &Mesh<N>, order: &Order, p: usize, degrees: &[usize], grid: &Grid<N>) -> Self {
        let inner = |k: usize| {
            let mut inner = multi_indices(k + 1, p);
            inner.retain(|alpha| alpha.iter().all(|&a| a > 0));
            inner
        };
        let inner: Vec<_> = (0..N).map(inner).collect();
        let (mut offsets, mut spots) = (Vec::new(), Vec::new());
        let points = mesh.points().expect("a lattice has points");
        for (k, layer) in order.layers.iter().enumerate() {
            offsets.push(spots.len());
            for &simplex in &layer.simplices {
                let vertices = mesh.vertices(k, simplex as usize);
                for alpha in &inner[k] {
                    let weighted = alpha.iter().zip(vertices);
                    let x = weighted.map(|(&a, &v)| points[v as usize] * (a as f64 / p as f64));
                    spots.push(grid.spot(&x.sum()));
                }
            }
        }
        let whole = Patch::whole(&grid.sides);
        let span = |(node, spot): (usize, &Spot<N>)| {
            let plane = whole.site(spot.first as usize)[N - 1];
            (node as u32, plane, plane + 4)
        };
        let spans = spots.iter().enumerate().map(span).collect();
        Self {
            slabs: Slabs::new(grid.sides[N - 1], spans),
            spots,
            own: inner.iter().map(Vec::len).collect(),
            offsets,
            blocks: blocks::<N>(p, degrees, &inner),
            firsts: firsts(order),
        }
    }

    /// The nodes of one of a cell's k-simplices.
    #[inline]
    pub fn of_block(
        &self,
        order: &Order,
        k: usize,
        cell: usize,
        which: usize,
    ) -> impl Iterator<Item = usize> {
        self.blocks[k][which].nodes.iter().map(move |node| {
            let simplex = order.layers[node.k].of_cell(cell)[node.which] as usize;
            self.offsets[node.k] + simplex * self.own[node.k] + node.index
        })
    }

    /// The interior simplices that have the own nodes of one of a cell's k-simplices, of those that this cell is the first of.
    #[inline]
    pub fn users(&self, k: usize, cell: usize, which: usize) -> impl Iterator<Item = &User> {
        let firsts = self.firsts[cell];
        let users = self.blocks[k][which].users.iter();
        users.filter(move |user| firsts & user.bit != 0)
    }
}

/// What is the same for every cell.
fn blocks<const N: usize>(
    p: usize,
    degrees: &[usize],
    inner: &[Vec<Vec<usize>>],
) -> Vec<Vec<Block>> {
    let mut blocks: Vec<Vec<Block>> = (0..N)
        .map(|k| vec![Block::default(); subsets(N + 1, k + 1).len()])
        .collect();
    let mut bit = 1;
    for (k, &degree) in degrees.iter().enumerate() {
        for (which, vertices) in subsets(N + 1, k + 1).iter().enumerate() {
            for (point, alpha) in multi_indices(k + 1, degree).iter().enumerate() {
                let support = (0..=k).filter(|&i| alpha[i] > 0);
                let support: Vec<usize> = support.collect();
                let on: Vec<usize> = support.iter().map(|&i| vertices[i]).collect();
                let own: Vec<usize> = support.iter().map(|&i| alpha[i] * p / degree).collect();
                let j = on.len() - 1;
                let place = Place {
                    k: j,
                    which: position(&subsets(N + 1, j + 1), &on),
                    index: position(&inner[j], &own),
                };
                blocks[k][which].nodes.push(place);
                let users = &mut blocks[j][place.which].users;
                if users.last().is_none_or(|user| user.bit != bit) {
                    users.push(User {
                        k,
                        which,
                        bit,
                        points: vec![0; inner[j].len()],
                    });
                }
                users.last_mut().expect("one is there").points[place.index] = point;
            }
            bit <<= 1;
        }
    }
    blocks
}

fn position(list: &[Vec<usize>], of: &[usize]) -> usize {
    let found = list.iter().position(|x| x == of);
    found.expect("a node of P_p on a simplex of the cell")
}

/// A bit for each block whose simplex has the cell for its first.
fn firsts(order: &Order) -> Vec<u16> {
    let (mut firsts, mut before) = (vec![0; order.cells.len()], 0);
    for layer in &order.layers {
        for simplex in 0..layer.free {
            let (cell, which) = layer.first(simplex);
            firsts[cell] |= 1 << (before + which);
        }
        before += layer.per_cell();
    }
    firsts
}

impl<const N: usize> Grid<N> {
    /// Where a point is.
    fn spot(&self, x: &Vector<f64, N>) -> Spot<N> {
        let (mut first, mut stride, mut at) = (0, 1, [0.0; N]);
        for axis in 0..N {
            let t = (x[axis] - self.lower[axis]) * self.density[axis];
            let cell = (t.max(0.0) as usize).min(self.sides[axis] - 4);
            at[axis] = (t - cell as f64) as Short;
            first += cell * stride;
            stride *= self.sides[axis];
        }
        let first = first as u32;
        Spot { first, at }
    }
}

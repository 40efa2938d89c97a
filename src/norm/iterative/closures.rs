//! The blocks of bad cells: what all faces, edges and vertices of a cell have together.
//!
//! The energy of a flat cell is large but for affine functions, which cost nothing there. Each of its simplices is stiff by itself, so
//! that the simplices' own blocks hardly see what is affine on it; the block of all of them does. Without these blocks the
//! steps of conjugate gradients follow the worst cell: on a ball of 17 000 tetrahedra, p = 3, 19, 30 and 71 where the least mean
//! ratio is 0.40, 0.31 and 0.20, and over 1000 where it is 0.05; with them, and with what is done for flat cells elsewhere, 15, 15, 22
//! and 34.

use super::packed::{invert, lower, multiply, packed};
use super::skeleton::Skeleton;
use crate::Error;
use crate::mesh::Mesh;
use crate::norm::hhj::Hhj;
use crate::parallel::{collect, in_order};
use nalgebra::DMatrix;
use std::collections::BTreeMap;

/// A cell whose mean ratio is below has a block. Where the least is 0.31 and 0.20 on these balls, 0.4 takes 20 and 27 steps, 0.5 as many
/// as this, and from 0.6 on blocks overlap so much that the smoother's largest eigenvalue grows.
const BAD: f64 = 0.45;
/// At most one cell in so many has a block: where all cells are flat their blocks would take more memory than anything else.
const ONE_IN: usize = 20;

/// The worst cells, by their places in the solver's order, ascending.
pub(super) fn bad_cells(skeleton: &Skeleton) -> Vec<usize> {
    let ratios = &skeleton.order.ratios;
    let mut bad: Vec<usize> = (0..ratios.len()).filter(|&c| ratios[c] < BAD).collect();
    bad.sort_by(|&a, &b| ratios[a].total_cmp(&ratios[b]));
    bad.truncate(ratios.len() / ONE_IN);
    bad.sort_unstable();
    bad
}

/// The bytes of the blocks if all are there that may be, by the number of cells and how many unknowns one has.
pub(super) fn memory(cells: usize, outer: usize) -> f64 {
    (cells / ONE_IN * packed(outer) * size_of::<f64>()) as f64
}

/// Which cells have blocks, and which cells have a share in them.
pub(super) struct Plan {
    cells: Vec<usize>,
    unknowns: Vec<Vec<usize>>,
    /// The closures that a cell shares a vertex with.
    touched: BTreeMap<usize, Vec<usize>>,
}

/// What a cell adds to a block.
pub(super) struct Share {
    closure: usize,
    /// Where in the lower triangle, and what.
    entries: Vec<(usize, f64)>,
}

impl Share {
    pub fn add(self, blocks: &mut [Vec<f64>]) {
        for (at, x) in self.entries {
            blocks[self.closure][at] += x;
        }
    }
}

impl Plan {
    /// For these cells.
    pub fn new<const N: usize>(hhj: &Hhj<N>, skeleton: &Skeleton, cells: Vec<usize>) -> Self {
        let mut touched = BTreeMap::<usize, Vec<usize>>::new();
        let vertices = &skeleton.order.layers[0];
        for (closure, &cell) in cells.iter().enumerate() {
            let places = vertices.of_cell(cell).iter();
            for (near, _) in places.flat_map(|&vertex| vertices.star(vertex as usize)) {
                let list = touched.entry(near).or_default();
                if list.last() != Some(&closure) {
                    list.push(closure);
                }
            }
        }
        let of_cell = |&cell: &usize| {
            let unknowns = skeleton.unknowns(hhj.layout(), cell);
            unknowns.map(|(unknown, _)| unknown).collect()
        };
        let unknowns: Vec<Vec<usize>> = cells.iter().map(of_cell).collect();
        Self {
            cells,
            unknowns,
            touched,
        }
    }

    /// Blocks to which nothing is added yet: their lower triangles.
    pub fn zeros(&self) -> Vec<Vec<f64>> {
        let sizes = self.unknowns.iter().map(Vec::len);
        sizes.map(|n| vec![0.0; packed(n)]).collect()
    }

    /// What a cell adds to the blocks, from its energy without bubbles.
    pub fn shares<const N: usize>(
        &self,
        hhj: &Hhj<N>,
        skeleton: &Skeleton,
        cell: usize,
        energy: &DMatrix<f64>,
    ) -> Vec<Share> {
        let Some(closures) = self.touched.get(&cell) else {
            return Vec::new();
        };
        let own: BTreeMap<usize, usize> = skeleton.unknowns(hhj.layout(), cell).collect();
        let share = |&closure: &usize| {
            let unknowns = self.unknowns[closure].iter().enumerate();
            let common = unknowns.filter_map(|(i, unknown)| Some((i, *own.get(unknown)?)));
            let common: Vec<(usize, usize)> = common.collect();
            let below = |(last, &(i, a)): (usize, &(usize, usize))| {
                let entry =
                    move |&(j, b): &(usize, usize)| (lower(i, j), energy[(a.max(b), a.min(b))]);
                common[..=last].iter().map(entry).collect::<Vec<_>>()
            };
            Share {
                closure,
                entries: common.iter().enumerate().flat_map(below).collect(),
            }
        };
        closures.iter().map(share).collect()
    }

    /// The places of the cells' interior k-simplices.
    pub fn simplices(&self, k: usize, skeleton: &Skeleton) -> impl Iterator<Item = usize> {
        let layer = &skeleton.order.layers[k];
        let places = self.cells.iter().flat_map(|&cell| layer.of_cell(cell));
        places
            .map(|&place| place as usize)
            .filter(|&place| place < layer.free)
    }

    /// The inverses of the blocks.
    ///
    /// # Errors
    /// If rounding makes a block indefinite.
    pub fn inverted<const N: usize>(
        self,
        blocks: &[Vec<f64>],
        mesh: &Mesh<N>,
        skeleton: &Skeleton,
    ) -> Result<Closures, Error> {
        let inverse = |i: usize| {
            let mut inverse = vec![0.0; blocks[i].len()];
            invert(self.unknowns[i].len(), &blocks[i], &mut inverse);
            inverse
        };
        let inverses = collect(blocks.len(), inverse);
        let closures = self.unknowns.into_iter().zip(inverses).zip(self.cells);
        let closure = |((unknowns, inverse), cell): ((_, Vec<f64>), usize)| {
            if inverse.iter().all(|x| x.is_finite()) {
                return Ok(Closure { unknowns, inverse });
            }
            let vertices = mesh.vertices(N, skeleton.order.cells[cell] as usize);
            let reason = format!("the block of the cell {vertices:?} is not positive definite");
            Err(Error::Solver(reason))
        };
        Ok(Closures(closures.map(closure).collect::<Result<_, _>>()?))
    }
}

/// The inverse blocks of some cells.
#[derive(Clone, Debug)]
pub(super) struct Closures(Vec<Closure>);

/// The unknowns of a cell's interior simplices, and their block's inverse: in double precision, for it is small and large.
#[derive(Clone, Debug)]
struct Closure {
    unknowns: Vec<usize>,
    inverse: Vec<f64>,
}

impl Closures {
    /// Adds to some lists what the blocks' inverses make of r, multiplied by a factor.
    pub fn add(&self, factor: f32, r: &[f32], lists: &mut [&mut [f32]]) {
        let image = |i: usize| {
            let Closure { unknowns, inverse } = &self.0[i];
            let r: Vec<f64> = unknowns.iter().map(|&at| f64::from(r[at])).collect();
            let mut image = vec![0.0; r.len()];
            multiply(inverse, &r, &mut image);
            image
        };
        in_order(self.0.len(), image, |i, image| {
            for (&at, x) in self.0[i].unknowns.iter().zip(image) {
                for list in lists.iter_mut() {
                    list[at] += factor * x as f32;
                }
            }
        });
    }
}

//! The walk over the cells: a measure is evaluated once, cell by cell, and paired with as many test spaces as there are.
//!
//! Cells are evaluated in batches and by several threads; their contributions are added up in the order of the cells, so that
//! the sums do not depend on the number of threads. Every sum is a sum over cells: a cell's share of a hinge is
//! (2π − θ_ST) ω_S if it is the first cell around S, and −θ_ST ω_S if it is not; ω_S is the same from all of them.

use super::seen::{Sites, all_sites, weights};
use super::{Rules, Sums};
use crate::mesh::Mesh;
use crate::parallel::rows_in_order;
use crate::scalar::{Field, Real};
use crate::spaces::{TestSpace, Value};

/// Which faces and hinges belong to a measure. Cells do whatever this says, if the measure has a density there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Where {
    /// Those inside.
    Interior,
    /// Those of the boundary.
    Boundary,
}

impl Where {
    fn has(self, interior: bool) -> bool {
        interior == (self == Self::Interior)
    }
}

/// A measure on cells, faces and hinges: what one cell has of its density at a block of points, relative to reference measures.
///
/// `out` has a number for each direction of the test functions' values.
pub(super) trait Density<T: Real, const N: usize>: Sync {
    /// What test functions it can be paired with.
    type Value: Value;
    /// What is prepared for a cell.
    type Local;

    /// Which of the three sums are there at all.
    fn sums(&self) -> [bool; 3];
    /// Is it the same at all points of a hinge?
    fn is_constant_on_hinges(&self) -> bool;
    /// Prepares a cell.
    fn on_cell(&self, cell: usize) -> Self::Local;
    /// In the cell.
    fn in_cell(&self, at: &Self::Local, block: usize, out: &mut [T]);
    /// On the face at this place, as the cell sees it.
    fn on_face(&self, at: &Self::Local, place: usize, block: usize, out: &mut [T]);
    /// At the hinge at this place; `first` if the cell is the first one around it.
    fn at_hinge(&self, at: &Self::Local, place: usize, block: usize, first: bool, out: &mut [T]);
}

/// Where the numbers of one codimension stand among all of a cell: by place, block and direction. What is the same at all points
/// has one block.
#[derive(Clone, Copy)]
struct Part {
    start: usize,
    places: usize,
    blocks: usize,
    directions: usize,
    present: bool,
}

impl Part {
    fn len(&self) -> usize {
        self.places * self.blocks * self.directions
    }
}

/// A density on the cells of a mesh, all of its numbers on a cell at once.
trait CellByCell<T>: Sync {
    fn parts(&self) -> &[Part; 3];
    /// Writes down all numbers of a cell.
    fn evaluate(&self, cell: usize, out: &mut [T]);
}

struct Cells<'a, D, const N: usize> {
    mesh: &'a Mesh<N>,
    density: &'a D,
    on: Where,
    parts: [Part; 3],
}

impl<'a, D, const N: usize> Cells<'a, D, N> {
    fn new<T: Real>(mesh: &'a Mesh<N>, density: &'a D, on: Where, rules: &Rules) -> Self
    where
        D: Density<T, N>,
    {
        let mut blocks =
            [&rules.cells, &rules.faces, &rules.hinges].map(|r| r.points().blocks::<T>());
        if density.is_constant_on_hinges() {
            blocks[2] = 1;
        }
        let (present, places) = (density.sums(), [1, N + 1, N * (N + 1) / 2]);
        let mut start = 0;
        let parts = std::array::from_fn(|c| {
            let part = Part {
                start,
                places: places[c],
                blocks: blocks[c],
                directions: D::Value::directions(N - c),
                present: present[c],
            };
            start += part.len();
            part
        });
        Self {
            mesh,
            density,
            on,
            parts,
        }
    }

    /// Visits the chunks of all places of a codimension, those that do not belong to the measure set to zero.
    fn each_place<T: Real>(
        &self,
        codimension: usize,
        cell: usize,
        out: &mut [T],
        mut visit: impl FnMut(usize, usize, &mut [T]),
    ) {
        let (part, k) = (self.parts[codimension], N - codimension);
        let simplices = self.mesh.simplices_of(cell, k);
        let chunks =
            out[part.start..][..part.len()].chunks_exact_mut(part.blocks * part.directions);
        for (place, chunk) in chunks.enumerate() {
            let simplex = simplices[place] as usize;
            if self.on.has(self.mesh.is_interior(k, simplex)) {
                visit(place, simplex, chunk);
            } else {
                chunk.fill(T::zero());
            }
        }
    }
}

impl<T: Real, D: Density<T, N>, const N: usize> CellByCell<T> for Cells<'_, D, N> {
    fn parts(&self) -> &[Part; 3] {
        &self.parts
    }

    fn evaluate(&self, cell: usize, out: &mut [T]) {
        let (density, at) = (self.density, self.density.on_cell(cell));
        let [cells, faces, hinges] = self.parts;
        if cells.present {
            let chunks = out[..cells.len()].chunks_exact_mut(cells.directions);
            for (block, chunk) in chunks.enumerate() {
                density.in_cell(&at, block, chunk);
            }
        }
        if faces.present && faces.directions > 0 {
            self.each_place(1, cell, out, |place, _, chunk| {
                for (block, chunk) in chunk.chunks_exact_mut(faces.directions).enumerate() {
                    density.on_face(&at, place, block, chunk);
                }
            });
        }
        if hinges.present && hinges.directions > 0 {
            self.each_place(2, cell, out, |place, hinge, chunk| {
                let first = self.mesh.first_side(N - 2, hinge).cell == cell;
                for (block, chunk) in chunk.chunks_exact_mut(hinges.directions).enumerate() {
                    density.at_hinge(&at, place, block, first, chunk);
                }
            });
        }
    }
}

/// The traces of a test space at the points of the rules, and what a cell's numbers give with them.
struct Pairing<T> {
    /// How many functions live on a cell.
    len: usize,
    /// By codimension; None where the measure has no density.
    traces: [Option<Tables<T>>; 3],
}

/// The traces on the simplices of one codimension.
struct Tables<T> {
    /// By block, then by polynomial: weight times value; summed up where one block stands for all.
    basis: Vec<Vec<T>>,
    /// By place, then by direction and polynomial: which function of the cell.
    numbers: Vec<Vec<usize>>,
}

impl<T: Real> Tables<T> {
    fn new<V: Value, const N: usize>(
        space: &dyn TestSpace<N, Value = V>,
        sites: &Sites,
        rule: &crate::quadrature::Rule,
        part: &Part,
    ) -> Self {
        let traces: Vec<_> = sites.vertices.iter().map(|on| space.trace(on)).collect();
        let weights = weights::<T>(rule);
        let mut basis = traces[0].basis.tabulate::<T>(rule.points());
        for (row, weight) in basis.iter_mut().zip(weights) {
            row.iter_mut().for_each(|b| *b *= weight);
        }
        while basis.len() > part.blocks {
            let last = basis.pop().expect("there is a block at least");
            let first = basis[0].iter_mut();
            first.zip(last).for_each(|(sum, b)| *sum += b);
        }
        Self {
            basis,
            numbers: traces.into_iter().map(|trace| trace.numbers).collect(),
        }
    }

    /// Adds the integrals of a cell's densities against the traces, by function of the cell.
    fn add(&self, part: &Part, densities: &[T], acc: &mut [T]) {
        let mut densities = densities[part.start..].iter();
        for numbers in &self.numbers {
            for basis in &self.basis {
                for (numbers, density) in numbers.chunks_exact(basis.len()).zip(&mut densities) {
                    for (&number, b) in numbers.iter().zip(basis) {
                        acc[number] += *density * *b;
                    }
                }
            }
        }
    }
}

impl<T: Real> Pairing<T> {
    fn new<V: Value, const N: usize>(
        space: &dyn TestSpace<N, Value = V>,
        sites: &[Sites; 3],
        rules: &Rules,
        parts: &[Part; 3],
    ) -> Self {
        let rules = [&rules.cells, &rules.faces, &rules.hinges];
        let tables = |c: usize| Tables::new(space, &sites[c], rules[c], &parts[c]);
        Self {
            len: space.cell_len(),
            traces: std::array::from_fn(|c| parts[c].present.then(|| tables(c))),
        }
    }

    /// How long its row is: an entry for each function in each of the sums that are there.
    fn width(&self) -> usize {
        self.len * self.traces.iter().flatten().count()
    }

    /// The three sums' entries for the functions of a cell.
    fn row(&self, parts: &[Part; 3], densities: &[T], acc: &mut Vec<T>, row: &mut [T::Sum]) {
        acc.clear();
        acc.resize(self.width(), T::zero());
        let present = self
            .traces
            .iter()
            .zip(parts)
            .filter_map(|(t, part)| Some((t.as_ref()?, part)));
        for ((traces, part), acc) in present.zip(acc.chunks_exact_mut(self.len)) {
            traces.add(part, densities, acc);
        }
        for (entry, sum) in row.iter_mut().zip(acc) {
            *entry = sum.reduce();
        }
    }
}

/// What a thread needs for a cell.
struct Room<T> {
    densities: Vec<T>,
    acc: Vec<T>,
}

/// ∫ v dμ for the measure μ of this density and every function v of every space, evaluated once.
pub(super) fn pair<T: Real, D: Density<T, N>, const N: usize>(
    mesh: &Mesh<N>,
    density: &D,
    on: Where,
    spaces: &[&dyn TestSpace<N, Value = D::Value>],
    rules: &Rules,
) -> Vec<Sums<T::Sum>> {
    let cells = Cells::new::<T>(mesh, density, on, rules);
    gather::<T, D::Value, N>(mesh.cell_count(), &cells, spaces, rules)
}

/// The same, the kind of density forgotten.
fn gather<T: Real, V: Value, const N: usize>(
    count: usize,
    cells: &dyn CellByCell<T>,
    spaces: &[&dyn TestSpace<N, Value = V>],
    rules: &Rules,
) -> Vec<Sums<T::Sum>> {
    let (sites, parts) = (all_sites(N, rules), cells.parts());
    let pairings: Vec<Pairing<T>> = (spaces.iter())
        .map(|space| Pairing::new(*space, &sites, rules, parts))
        .collect();
    let room = || Room {
        densities: vec![T::zero(); parts.iter().map(Part::len).sum()],
        acc: Vec::new(),
    };
    let on_cell = |cell: usize, mut row: &mut [T::Sum], room: &mut Room<T>| {
        cells.evaluate(cell, &mut room.densities);
        for pairing in &pairings {
            let own = row
                .split_off_mut(..pairing.width())
                .expect("a row has all widths");
            pairing.row(parts, &room.densities, &mut room.acc, own);
        }
    };
    let mut sums: Vec<Sums<T::Sum>> = spaces.iter().map(|s| Sums::zero(s.len())).collect();
    let width = pairings.iter().map(Pairing::width).sum();
    if width == 0 {
        // A measure without any density: R of what is constant.
        return sums;
    }
    let mut dofs = Vec::new();
    let zero = T::Sum::zero();
    rows_in_order(count, width, zero, room, on_cell, |cell, mut row| {
        for ((space, pairing), sums) in spaces.iter().zip(&pairings).zip(&mut sums) {
            let own = row
                .split_off(..pairing.width())
                .expect("a row has all widths");
            dofs.clear();
            space.push_dofs(cell, &mut dofs);
            let lists = [&mut sums.cells, &mut sums.faces, &mut sums.hinges];
            let present = lists
                .into_iter()
                .zip(parts)
                .filter(|(_, part)| part.present);
            for ((sum, _), own) in present.zip(own.chunks_exact(dofs.len())) {
                for (&dof, value) in dofs.iter().zip(own) {
                    sum[dof] += *value;
                }
            }
        }
    });
    sums
}

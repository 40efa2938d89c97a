//! Measures on cells, faces and hinges: what a cell has of their densities.
//!
//! Of a hinge only the first cell around it has any: Θ_S comes from all of them (`defects.rs`), ω_S and traces on S are the same
//! from each.

use super::Rules;
use crate::mesh::Mesh;
use crate::scalar::Real;
use crate::spaces::Value;

/// Which faces and hinges belong to a measure. Cells do whatever this says, if the measure has a density there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Where {
    /// Those inside.
    Interior,
    /// Those of the boundary.
    Boundary,
}

impl Where {
    pub fn has(self, interior: bool) -> bool {
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
    /// At the hinge of this number in the mesh, which is at this place of the cell, the first one around it.
    fn at_hinge(&self, at: &Self::Local, hinge: usize, place: usize, block: usize, out: &mut [T]);
}

/// Where the numbers of one codimension stand among all of a cell: by place, block and direction. What is the same at all points
/// has one block.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub start: usize,
    places: usize,
    pub blocks: usize,
    directions: usize,
    pub present: bool,
}

impl Part {
    pub fn len(&self) -> usize {
        self.places * self.blocks * self.directions
    }
}

/// A density on the cells of a mesh, all of its numbers on a cell at once.
pub(super) trait CellByCell<T>: Sync {
    fn parts(&self) -> &[Part; 3];
    /// Writes down all numbers of a cell.
    fn evaluate(&self, cell: usize, out: &mut [T]);
}

pub(super) struct Cells<'a, D, const N: usize> {
    mesh: &'a Mesh<N>,
    density: &'a D,
    on: Where,
    parts: [Part; 3],
}

impl<'a, D, const N: usize> Cells<'a, D, N> {
    pub fn new<T: Real>(mesh: &'a Mesh<N>, density: &'a D, on: Where, rules: &Rules) -> Self
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
                if self.mesh.first_side(N - 2, hinge).cell != cell {
                    chunk.fill(T::zero());
                    return;
                }
                for (block, chunk) in chunk.chunks_exact_mut(hinges.directions).enumerate() {
                    density.at_hinge(&at, hinge, place, block, chunk);
                }
            });
        }
    }
}

//! Measures on cells, faces and hinges: what a cell has of their densities.
//!
//! What stands on a hinge is Θ_S times something. The angles in Θ_S come from all cells around S, what it is multiplied with
//! (ω_S, traces on S) is the same from each and is taken from the first; `around.rs` puts them together.

use super::Rules;
use crate::formulas::Formulas;
use crate::mesh::Mesh;
use crate::scalar::Real;
use crate::spaces::Value;
use std::f64::consts::PI;

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

/// What the angles around a hinge are subtracted from: 2π inside, π on the boundary.
pub(super) fn full_angle<T: Real>(formulas: &Formulas, on: Where) -> T {
    let halves = match on {
        Where::Interior => formulas.full_angle,
        Where::Boundary => formulas.boundary_angle,
    };
    T::from_f64(PI) * T::from_int(halves)
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
    /// What the angles around a hinge are subtracted from: 2π inside, π on the boundary.
    fn full_angle(&self) -> T;
    /// Prepares a cell.
    fn on_cell(&self, cell: usize) -> Self::Local;
    /// In the cell.
    fn in_cell(&self, at: &Self::Local, block: usize, out: &mut [T]);
    /// On the face at this place, as the cell sees it.
    fn on_face(&self, at: &Self::Local, place: usize, block: usize, out: &mut [T]);
    /// The cell's angle at the hinge at this place. What Θ_S is multiplied with is written to `factors`, if there are any.
    fn at_hinge(
        &self,
        at: &Self::Local,
        place: usize,
        block: usize,
        factors: Option<&mut [T]>,
    ) -> T;
}

/// Where the numbers of one codimension stand among all of a cell: by place, block and direction. What is the same at all points
/// has one block.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub start: usize,
    places: usize,
    pub blocks: usize,
    pub directions: usize,
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
    /// What angles are subtracted from.
    fn full_angle(&self) -> T;
    /// Writes down all numbers of a cell; at its hinges, by place and block, its angle and then the factors, which only the
    /// first cell around a hinge fills in.
    fn evaluate(&self, cell: usize, out: &mut [T], hinges: &mut [T]);
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
            let directions = D::Value::directions(N - c);
            let part = Part {
                start,
                places: places[c],
                blocks: blocks[c],
                directions,
                present: present[c] && directions > 0,
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

    /// Visits the places of a codimension that belong to the measure: place, simplex, chunk.
    fn each_place<T>(
        &self,
        codimension: usize,
        cell: usize,
        chunks: impl Iterator<Item = T>,
        mut visit: impl FnMut(usize, usize, T),
    ) {
        let k = N - codimension;
        let simplices = self.mesh.simplices_of(cell, k).iter();
        for (place, (&simplex, chunk)) in simplices.zip(chunks).enumerate() {
            if self.on.has(self.mesh.is_interior(k, simplex as usize)) {
                visit(place, simplex as usize, chunk);
            }
        }
    }
}

impl<T: Real, D: Density<T, N>, const N: usize> CellByCell<T> for Cells<'_, D, N> {
    fn parts(&self) -> &[Part; 3] {
        &self.parts
    }

    fn full_angle(&self) -> T {
        self.density.full_angle()
    }

    fn evaluate(&self, cell: usize, out: &mut [T], row: &mut [T]) {
        let (density, at) = (self.density, self.density.on_cell(cell));
        let [cells, faces, hinges] = self.parts;
        if cells.present {
            let chunks = out[..cells.len()].chunks_exact_mut(cells.directions);
            for (block, chunk) in chunks.enumerate() {
                density.in_cell(&at, block, chunk);
            }
        }
        if faces.present {
            let out = &mut out[faces.start..][..faces.len()];
            out.fill(T::zero());
            let chunks = out.chunks_exact_mut(faces.blocks * faces.directions);
            self.each_place(1, cell, chunks, |place, _, chunk| {
                for (block, chunk) in chunk.chunks_exact_mut(faces.directions).enumerate() {
                    density.on_face(&at, place, block, chunk);
                }
            });
        }
        if hinges.present {
            let chunks = row.chunks_exact_mut(hinges.blocks * (1 + hinges.directions));
            self.each_place(2, cell, chunks, |place, hinge, chunk| {
                let first = self.mesh.first_side(N - 2, hinge).cell == cell;
                for (block, chunk) in chunk.chunks_exact_mut(1 + hinges.directions).enumerate() {
                    let (angle, factors) = chunk.split_first_mut().expect("an angle at least");
                    *angle = density.at_hinge(&at, place, block, first.then_some(factors));
                }
            });
        }
    }
}

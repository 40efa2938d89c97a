//! Hinges, around which cells meet: all angles are added up before anything is multiplied with them.
//!
//! Θ_S is a small difference of angles. Were each cell's angle multiplied by its own ω_S first, the rounding of every product would
//! be that of an angle of size 2π, and not that of Θ_S.

use super::measure::Part;
use crate::mesh::Mesh;
use crate::scalar::Real;

/// Θ_S at the points of a rule on hinges, and what it is multiplied with.
pub(super) struct Around<T> {
    blocks: usize,
    /// How many numbers a block has: Θ_S and a factor for each direction.
    block: usize,
    /// How many numbers a cell has for all of its hinges.
    width: usize,
    /// By hinge, then by block.
    values: Vec<T>,
}

impl<T: Real> Around<T> {
    /// Before any cell has been seen: Θ_S is the full angle.
    pub fn new<const N: usize>(mesh: &Mesh<N>, part: &Part, full_angle: T) -> Self {
        if !part.present {
            return Self {
                blocks: 0,
                block: 1,
                width: 0,
                values: Vec::new(),
            };
        }
        let (blocks, block) = (part.blocks, 1 + part.directions);
        let mut values = vec![T::zero(); block * blocks * mesh.count(N - 2)];
        for theta in values.iter_mut().step_by(block) {
            *theta = full_angle;
        }
        Self {
            blocks,
            block,
            width: block * blocks * N * (N + 1) / 2,
            values,
        }
    }

    /// How many numbers a cell writes down for its hinges; none where there is no sum over hinges.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Subtracts the angles of a cell, and takes its factors where it is the first around a hinge.
    pub fn add<const N: usize>(&mut self, mesh: &Mesh<N>, cell: usize, row: &[T]) {
        if row.is_empty() {
            return;
        }
        let hinges = mesh.simplices_of(cell, N - 2).iter();
        let len = self.blocks * self.block;
        for (&hinge, row) in hinges.zip(row.chunks_exact(len)) {
            let own = &mut self.values[hinge as usize * len..][..len];
            for (own, row) in (own.chunks_exact_mut(self.block)).zip(row.chunks_exact(self.block)) {
                own[0] -= row[0];
                for (factor, seen) in own[1..].iter_mut().zip(&row[1..]) {
                    // All cells but the first have left zero.
                    *factor += *seen;
                }
            }
        }
    }

    /// Θ_S times the factors, by block and direction.
    pub fn densities(&self, hinge: usize, out: &mut Vec<T>) {
        let len = self.blocks * self.block;
        let own = &self.values[hinge * len..][..len];
        out.clear();
        for block in own.chunks_exact(self.block) {
            out.extend(block[1..].iter().map(|factor| block[0] * *factor));
        }
    }
}

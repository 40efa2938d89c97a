//! Angle defects around hinges: the angles of all cells are added up before anything is multiplied with them.
//!
//! Θ_S is a small difference of angles. Were each cell's angle multiplied by its own ω_S first, the rounding of every product would
//! be that of an angle of size 2π, and not that of Θ_S.

use super::measure::Where;
use super::seen::Seen;
use crate::field::Evaluate;
use crate::mesh::Mesh;
use crate::parallel::rows_in_order;
use crate::scalar::Real;

/// Θ_S at the points of a rule on hinges: `full` − Σ_T θ_ST, with 2π for `full` inside and π on the boundary.
pub(super) struct Defects<T> {
    /// How many blocks of points a hinge has; one stands for all where the metric is constant on cells.
    blocks: usize,
    /// By hinge, then by block. What is not among the hinges asked for is `full`.
    values: Vec<T>,
}

impl<T: Real> Defects<T> {
    /// Of a metric, at the hinges of a mesh that are inside or on the boundary. `blocks` is that of the rule.
    pub fn new<const N: usize, G: Evaluate<T, N>>(
        seen: &Seen<'_, T, N, G>,
        mesh: &Mesh<N>,
        on: Where,
        blocks: usize,
        full: T,
    ) -> Self {
        let blocks = if seen.g.is_constant() { 1 } else { blocks };
        let mut values = vec![full; blocks * mesh.count(N - 2)];
        let wanted = |hinge: u32| on.has(mesh.is_interior(N - 2, hinge as usize));
        let on_cell = |cell: usize, row: &mut [T], (): &mut ()| {
            let (at, hinges) = (seen.on_cell(cell), mesh.simplices_of(cell, N - 2));
            for (place, angles) in row.chunks_exact_mut(blocks).enumerate() {
                if wanted(hinges[place]) {
                    for (block, angle) in angles.iter_mut().enumerate() {
                        *angle = seen.corner(&at, place, block, |corner| corner.angle());
                    }
                }
            }
        };
        let subtract = |cell: usize, row: &[T]| {
            let hinges = mesh.simplices_of(cell, N - 2);
            for (&hinge, angles) in hinges.iter().zip(row.chunks_exact(blocks)) {
                let values = &mut values[hinge as usize * blocks..][..blocks];
                for (value, angle) in values.iter_mut().zip(angles) {
                    *value -= *angle;
                }
            }
        };
        let width = blocks * N * (N + 1) / 2;
        rows_in_order(
            mesh.cell_count(),
            width,
            T::zero(),
            || (),
            on_cell,
            subtract,
        );
        Self { blocks, values }
    }

    /// Θ_S at a block of points.
    #[inline]
    pub fn at(&self, hinge: usize, block: usize) -> T {
        self.values[hinge * self.blocks + block.min(self.blocks - 1)]
    }
}

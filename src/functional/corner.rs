//! Dihedral angles in all cells, and the angle defects that they leave around the hinges.

use super::site::Sites;
use crate::field::TensorField;
use crate::formulas::Formulas;
use crate::hinge::Hinge;
use crate::linalg::{Vector, inverse_and_det};
use crate::mesh::Mesh;
use crate::parallel::rows_in_order;
use crate::scalar::Real;

/// The hinges of a cell, at the points of a rule.
pub(super) struct Corners<'a, T: Real, const N: usize, G: TensorField<T, N>> {
    g: &'a G,
    mesh: &'a Mesh<N>,
    /// Is g constant on cells? Then one block of points says all, and one inverse.
    constant: bool,
    blocks: usize,
    tables: Vec<G::Table>,
    outward: Vec<[Vector<T, N>; 2]>,
}

impl<'a, T: Real, const N: usize, G: TensorField<T, N>> Corners<'a, T, N, G> {
    /// At the points of these sites, which are hinges.
    pub fn new(g: &'a G, mesh: &'a Mesh<N>, sites: &Sites<T>) -> Self {
        let faces_at = |place: usize| {
            let nu = sites.outward::<N>(place);
            [nu[0], nu[1]]
        };
        let constant = g.is_constant();
        Self {
            g,
            mesh,
            constant,
            blocks: if constant { 1 } else { sites.weights.len() },
            tables: sites.tables(g),
            outward: (0..sites.vertices.len()).map(faces_at).collect(),
        }
    }

    /// How long a row is: θ_ST and ω_S by hinge of the cell, then by block.
    pub fn width(&self) -> usize {
        2 * self.outward.len() * self.blocks
    }

    /// Fills the row of a cell, the interior hinges of it.
    pub fn fill<K: Formulas>(&self, cell: usize, local: &G::Local, row: &mut [T]) {
        let hinges = self.mesh.simplices_of(cell, N - 2);
        let inverse_at = |place: usize, block: usize| {
            inverse_and_det(&self.g.value(local, &self.tables[place], block))
        };
        let everywhere = self.constant.then(|| inverse_at(0, 0));
        for (place, chunk) in row.chunks_exact_mut(2 * self.blocks).enumerate() {
            if !self.mesh.is_interior(N - 2, hinges[place] as usize) {
                continue;
            }
            let [a, b] = &self.outward[place];
            for (block, pair) in chunk.chunks_exact_mut(2).enumerate() {
                let (inverse, det) = everywhere.unwrap_or_else(|| inverse_at(place, block));
                let corner = Hinge::new(&inverse, [a, b]);
                let (sin, cos) = K::dihedral(&corner);
                pair[0] = T::angle(sin, cos);
                pair[1] = corner.omega_s(det);
            }
        }
    }

    /// Θ_S = 2π and ω_S = 0, before any cell is seen.
    pub fn before(&self) -> Defects<T> {
        let start = [T::from_f64(std::f64::consts::TAU), T::zero()];
        Defects {
            blocks: self.blocks,
            values: vec![start; self.blocks * self.mesh.count(N - 2)],
        }
    }
}

/// Θ_S = 2π − Σ_T θ_ST, point by point, and ω_S as the first cell around S has it.
pub(super) struct Defects<T> {
    blocks: usize,
    /// By hinge, then by block.
    values: Vec<[T; 2]>,
}

impl<T: Real> Defects<T> {
    /// At the points of sites that are hinges. On the boundary they mean nothing.
    pub fn new<K: Formulas, const N: usize, G: TensorField<T, N>>(
        g: &G,
        mesh: &Mesh<N>,
        sites: &Sites<T>,
    ) -> Self {
        let corners = Corners::new(g, mesh, sites);
        let mut defects = corners.before();
        rows_in_order(
            mesh.cell_count(),
            corners.width(),
            T::zero(),
            |cell, row| corners.fill::<K>(cell, &g.on_cell(cell), row),
            |cell, row| defects.subtract(mesh, cell, row),
        );
        defects
    }

    /// Takes the angles of a cell into account; cells come in ascending order.
    pub fn subtract<const N: usize>(&mut self, mesh: &Mesh<N>, cell: usize, row: &[T]) {
        let hinges = mesh.simplices_of(cell, N - 2);
        for (chunk, &hinge) in row.chunks_exact(2 * self.blocks).zip(hinges) {
            let first = mesh.first_side(N - 2, hinge as usize).cell == cell;
            let values = &mut self.values[hinge as usize * self.blocks..][..self.blocks];
            for (value, pair) in values.iter_mut().zip(chunk.chunks_exact(2)) {
                value[0] -= pair[0];
                if first {
                    value[1] = pair[1];
                }
            }
        }
    }

    /// (Θ_S, ω_S) at a block of points.
    pub fn at(&self, hinge: usize, block: usize) -> (T, T) {
        let [defect, omega] = self.values[hinge * self.blocks + block.min(self.blocks - 1)];
        (defect, omega)
    }
}

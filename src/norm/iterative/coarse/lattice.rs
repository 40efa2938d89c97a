//! Meshes that are a cube's lattice up to a displacement of the inner vertices, as [`Mesh::cube`] makes them.

use crate::linalg::Vector;
use crate::mesh::Mesh;

/// How far inner vertices may be from their places, in every coordinate and in cells of the lattice.
pub(super) const REACH: f64 = 0.45;

/// `side`^N equal boxes, each cut into N! cells; vertices numbered with the first coordinate running fastest.
#[derive(Clone, Debug)]
pub(in crate::norm) struct Lattice<const N: usize> {
    /// How many boxes a side.
    pub side: usize,
    /// The corner with the least coordinates.
    pub lower: Vector<f64, N>,
    /// The edges of a box.
    pub steps: Vector<f64, N>,
}

impl<const N: usize> Lattice<N> {
    /// The lattice of a mesh, if it has one.
    pub fn of(mesh: &Mesh<N>) -> Option<Self> {
        let points = mesh.points()?;
        let side = (points.len() as f64).powf(1.0 / N as f64).round() as usize - 1;
        let boxes = side.checked_pow(N as u32)?;
        if side == 0
            || (side + 1).pow(N as u32) != points.len()
            || boxes * (1..=N).product::<usize>() != mesh.cell_count()
        {
            return None;
        }
        let lower = points[0];
        let steps = (points[points.len() - 1] - lower) / side as f64;
        let lattice = Self { side, lower, steps };
        let fits = steps.iter().all(|s| *s > 0.0) && lattice.fits(mesh, points);
        fits.then_some(lattice)
    }

    /// Where a vertex belongs.
    fn index(&self, mut vertex: usize) -> [usize; N] {
        std::array::from_fn(|_| {
            let digit = vertex % (self.side + 1);
            vertex /= self.side + 1;
            digit
        })
    }

    fn fits(&self, mesh: &Mesh<N>, points: &[Vector<f64, N>]) -> bool {
        let near = |(vertex, x): (usize, &Vector<f64, N>)| {
            let reach = if mesh.is_interior(0, vertex) {
                REACH
            } else {
                1e-9
            };
            let at = self.index(vertex);
            (0..N).all(|i| ((x[i] - self.lower[i]) / self.steps[i] - at[i] as f64).abs() <= reach)
        };
        // Each cell within one box: its vertices are at most 1 above the first in every coordinate.
        let compact = |cell: usize| {
            let vertices = mesh.vertices(N, cell);
            let base = self.index(vertices[0] as usize);
            vertices.iter().all(|&v| {
                let at = self.index(v as usize);
                (0..N).all(|i| at[i] == base[i] || at[i] == base[i] + 1)
            })
        };
        points.iter().enumerate().all(near) && (0..mesh.cell_count()).all(compact)
    }
}

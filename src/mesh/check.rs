//! What a list of cells must satisfy to be a mesh.

use super::incidence::{self, Layer};
use super::{Chart, Mesh, Side};
use crate::Error;
use crate::linalg::Mat;

impl<const N: usize> Mesh<N> {
    /// Cells have volume, and neighbours lie on different sides of their common face.
    pub(super) fn check_orientation(&self) -> Result<(), Error> {
        let volumes: Vec<f64> = (0..self.cell_count())
            .map(|c| self.relative_volume(c))
            .collect();
        // A simplex that is flat to this part of a cube on its longest edge is degenerate in f64.
        if let Some(cell) = volumes.iter().position(|v| v.is_nan() || v.abs() < 1e-12) {
            return Err(Error::Cell {
                cell,
                reason: format!(
                    "degenerate: volume over (longest edge)^{N} is {:e}",
                    volumes[cell]
                ),
            });
        }
        if matches!(self.chart, Chart::Cells(_)) {
            return Ok(());
        }
        for face in self.interior_faces() {
            let sides: Vec<Side> = self.star(N - 1, face).collect();
            // The volume's sign as seen from the face: face vertices first, the opposite vertex last.
            let seen = |s: &Side| {
                if s.place.is_multiple_of(2) {
                    volumes[s.cell]
                } else {
                    -volumes[s.cell]
                }
            };
            if seen(&sides[0]) * seen(&sides[1]) > 0.0 {
                return Err(Error::Cell {
                    cell: sides[1].cell,
                    reason: format!(
                        "inverted: it lies on the same side of the face {:?} as cell {}",
                        self.vertices(N - 1, face),
                        sides[0].cell
                    ),
                });
            }
        }
        Ok(())
    }

    /// det(∂x/∂ξ) over the N-th power of the longest edge from corner 0.
    fn relative_volume(&self, cell: usize) -> f64 {
        self.jacobian(cell).map_or(f64::NAN, |j| {
            let longest = (0..N).map(|i| j.column(i).norm()).fold(0.0, f64::max);
            determinant(&j) / longest.powi(N as i32)
        })
    }
}

/// det of a general matrix.
fn determinant<const N: usize>(a: &Mat<f64, N>) -> f64 {
    nalgebra::DMatrix::from_fn(N, N, |i, j| a[(i, j)]).determinant()
}

/// The cells with ascending vertices, if they are possible cells at all.
pub(super) fn sorted_cells<const N: usize>(
    vertices: usize,
    cells: &[Vec<usize>],
) -> Result<Vec<u32>, Error> {
    let mut used = vec![false; vertices];
    let mut sorted = Vec::with_capacity(cells.len() * (N + 1));
    for (cell, list) in cells.iter().enumerate() {
        let mut list = list.clone();
        list.sort_unstable();
        let refuse = |reason: String| Err(Error::Cell { cell, reason });
        if list.len() != N + 1 {
            return refuse(format!(
                "has {} vertices, a {N}-simplex has {}",
                list.len(),
                N + 1
            ));
        }
        if let Some(pair) = list.windows(2).find(|p| p[0] == p[1]) {
            return refuse(format!("vertex {} is repeated", pair[0]));
        }
        if list[N] >= vertices {
            return refuse(format!(
                "vertex {} does not exist: there are {vertices}",
                list[N]
            ));
        }
        for v in list {
            used[v] = true;
            sorted.push(v as u32);
        }
    }
    match used.iter().position(|u| !u) {
        Some(vertex) => Err(Error::Vertex {
            vertex,
            reason: "belongs to no cell".into(),
        }),
        None => Ok(sorted),
    }
}

/// Two cells a face at the most, and stars that are connected through faces.
pub(super) fn check_manifold<const N: usize>(layers: &[Layer]) -> Result<(), Error> {
    let faces = &layers[N - 1];
    for f in 0..faces.interior.len() {
        let star = &faces.stars.entries[faces.stars.offsets[f]..faces.stars.offsets[f + 1]];
        if star.len() > 2 {
            return Err(Error::NotAManifold {
                simplex: faces.vertices[f * N..(f + 1) * N]
                    .iter()
                    .map(|&v| v as usize)
                    .collect(),
                cell: star[2].0 as usize,
                reason: format!("{} cells share this face", star.len()),
            });
        }
    }
    match incidence::pinched(N, layers) {
        Some((simplex, cell)) => Err(Error::NotAManifold {
            simplex,
            cell,
            reason: "its cells are not connected through the faces that contain it".into(),
        }),
        None => Ok(()),
    }
}

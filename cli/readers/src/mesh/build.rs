//! From what a file says to a mesh of known dimension, every refusal at its place in the file.

use super::lattice::Sorted;
use super::{Curved, MeshFile, hanging};
use crate::error::{InputError, Place};
use nalgebra::SVector;
use regge_curvature::Error;
use regge_curvature::linalg::{inverse_and_det, symmetric};
use regge_curvature::mesh::Mesh;
use regge_curvature::spaces::Immersion;
use std::collections::HashMap;

/// The square of a cell's volume over (longest edge)^N that is none: a hundred roundings of the determinant.
const FLAT: f64 = 1e-14;

impl MeshFile {
    /// A refusal at a vertex.
    fn at_vertex(&self, vertex: usize, reason: String) -> InputError {
        let place = self.vertex_places.get(vertex).copied();
        InputError::new(&self.file, place.unwrap_or(Place::Whole), reason)
    }

    /// The place of a cell.
    fn cell_place(&self, cell: usize) -> Place {
        self.cell_places.get(cell).copied().unwrap_or(Place::Whole)
    }

    /// The library's refusal, where it is about the file.
    fn refuse(&self, error: &Error) -> InputError {
        let place = match error {
            Error::Cell { cell, .. } | Error::NotAManifold { cell, .. } => self.cell_place(*cell),
            Error::Vertex { vertex, .. } => self
                .vertex_places
                .get(*vertex)
                .copied()
                .unwrap_or(Place::Whole),
            _ => Place::Whole,
        };
        let advice = match error {
            Error::Vertex { .. } => ": remove it from the file",
            _ => "",
        };
        InputError::new(&self.file, place, format!("{error}{advice}"))
    }

    /// Has the file coordinates?
    pub fn has_coordinates(&self) -> bool {
        !self.coordinates.is_empty()
    }

    /// The triangulation of a domain in ℝ^N.
    ///
    /// # Errors
    /// Names the vertex or cell that is no part of such a mesh: not finite, duplicated, hanging, unused, degenerate,
    /// inverted, not a manifold there.
    pub fn mesh<const N: usize>(&self) -> Result<Mesh<N>, InputError> {
        if !self.has_coordinates() {
            let reason = "has no coordinates, which a formula needs: give edge lengths instead";
            return Err(InputError::new(&self.file, Place::Whole, reason));
        }
        let points = self.points::<N>()?;
        self.check_duplicates(&points)?;
        match Mesh::new(points, &self.cells) {
            Ok(mesh) => {
                let outer = (0..mesh.count(N - 1)).filter(|&f| !mesh.is_interior(N - 1, f));
                let mut faces = Vec::new();
                for face in outer {
                    faces.extend(mesh.vertices(N - 1, face).iter().map(|v| *v as usize));
                }
                self.check_hanging(N, &faces)?;
                Ok(mesh)
            }
            Err(error) => {
                if matches!(error, Error::NotAManifold { .. }) {
                    self.check_hanging(N, &hanging::boundary_faces(&self.cells))?;
                }
                Err(self.refuse(&error))
            }
        }
    }

    /// `faces` has the vertices of the faces of the boundary.
    fn check_hanging(&self, dimension: usize, faces: &[usize]) -> Result<(), InputError> {
        let places = hanging::Places {
            coordinates: &self.coordinates,
            width: self.width,
            dimension,
        };
        let Some((vertex, face)) = places.hanging(faces) else {
            return Ok(());
        };
        let reason = format!(
            "vertex {vertex} hangs: it lies in the face {face:?} without being a vertex of it; split the cell there"
        );
        Err(self.at_vertex(vertex, reason))
    }

    /// The manifold that has its metric from the points of the file: a domain in ℝ^N, or a surface in space.
    ///
    /// # Errors
    /// Names the cell or vertex that is no part of such a manifold, or that is degenerate.
    fn surface<const N: usize>(&self) -> Result<Mesh<N>, InputError> {
        if !self.has_coordinates() {
            let reason = "has no coordinates: give the edge lengths (--lengths)";
            return Err(InputError::new(&self.file, Place::Whole, reason));
        }
        if self.width == N && self.curved.is_none() {
            return self.mesh();
        }
        self.check_finite()?;
        let mesh = self.abstract_mesh()?;
        if self.curved.is_some() {
            return Ok(mesh);
        }
        match self.flat_cell::<N>() {
            None => Ok(mesh),
            Some((cell, det)) => {
                let volume = det.max(0.0).sqrt();
                let reason = format!(
                    "cell {cell} is degenerate: its volume over (longest edge)^{N} is {volume:.1e}; remove it"
                );
                Err(InputError::new(&self.file, self.cell_place(cell), reason))
            }
        }
    }

    /// The manifold with its points in space: straight or curved cells.
    ///
    /// # Errors
    /// Names the cell or vertex that is no part of a manifold, or that is degenerate.
    pub fn immersion<const N: usize>(&self) -> Result<Immersion<N>, InputError> {
        let mesh = self.surface::<N>()?;
        let made = match &self.curved {
            None => Immersion::straight(&mesh, self.width, self.coordinates.clone()),
            Some(curved) => {
                let points = curved.sorted(&self.cells);
                let size = points.len() / mesh.cell_count();
                let nodes = |cell: usize| &points[cell * size..(cell + 1) * size];
                Immersion::through(&mesh, curved.order, 3, nodes)
            }
        };
        made.map_err(|error| self.refuse(&error))
    }

    fn check_finite(&self) -> Result<(), InputError> {
        match self.coordinates.iter().position(|x| !x.is_finite()) {
            None => Ok(()),
            Some(at) => {
                let reason = format!("a coordinate is {}", self.coordinates[at]);
                Err(self.at_vertex(at / self.width, reason))
            }
        }
    }

    /// The first cell whose volume is none, with the square of its volume over (longest edge)^N: det of the Gram matrix of its
    /// edges, as the kernel sees the cell.
    fn flat_cell<const N: usize>(&self) -> Option<(usize, f64)> {
        let point = |v: usize| &self.coordinates[v * self.width..(v + 1) * self.width];
        let relative = |cell: &Vec<usize>| {
            let edge = |i: usize, c: usize| point(cell[i + 1])[c] - point(cell[0])[c];
            let dot = |i, j| (0..self.width).map(|c| edge(i, c) * edge(j, c)).sum();
            let gram = symmetric::<f64, N>(dot);
            let longest = (0..N).map(|i| gram[(i, i)]).fold(0.0, f64::max);
            inverse_and_det(&(gram / longest)).1
        };
        let all = self.cells.iter().map(relative).enumerate();
        let mut flat = all.filter(|(_, det)| det.is_nan() || *det < FLAT);
        flat.next()
    }

    /// The complex alone: lengths need no coordinates, and where there are some they need not be in ℝ^N.
    ///
    /// # Errors
    /// Names the cell or vertex that is no part of a manifold.
    pub fn abstract_mesh<const N: usize>(&self) -> Result<Mesh<N>, InputError> {
        let mesh = Mesh::new_abstract(self.vertices, &self.cells);
        mesh.map_err(|error| self.refuse(&error))
    }

    /// The first N coordinates; the others must vanish.
    fn points<const N: usize>(&self) -> Result<Vec<SVector<f64, N>>, InputError> {
        let mut points = Vec::with_capacity(self.vertices);
        for (vertex, x) in self.coordinates.chunks_exact(self.width).enumerate() {
            if let Some(off) = x[N..]
                .iter()
                .find(|x| **x != height(&self.coordinates, N, self.width))
            {
                let reason = format!(
                    "vertex {vertex} has z = {off}: a formula in two coordinates needs a mesh in one plane z = const"
                );
                return Err(self.at_vertex(vertex, reason));
            }
            points.push(SVector::from_column_slice(&x[..N]));
        }
        Ok(points)
    }

    fn check_duplicates<const N: usize>(
        &self,
        points: &[SVector<f64, N>],
    ) -> Result<(), InputError> {
        let mut seen = HashMap::with_capacity(points.len());
        for (vertex, x) in points.iter().enumerate() {
            // −0 and 0 are one place.
            let key: [u64; N] = std::array::from_fn(|i| (x[i] + 0.0).to_bits());
            if let Some(first) = seen.insert(key, vertex) {
                let reason = format!(
                    "vertex {vertex} is where vertex {first} is, at {:?}: merge the duplicated nodes",
                    x.as_slice()
                );
                return Err(self.at_vertex(vertex, reason));
            }
        }
        Ok(())
    }
}

impl Curved {
    /// The nodes of each cell in the order of the library, the cell's vertices ascending.
    fn sorted(&self, cells: &[Vec<usize>]) -> Vec<f64> {
        let mut sorted = Sorted::new(cells[0].len() - 1, self.order);
        let mut points = Vec::with_capacity(self.points.len());
        let size = self.points.len() / cells.len();
        for (cell, mine) in cells.iter().zip(self.points.chunks_exact(size)) {
            for &place in sorted.places(cell) {
                points.extend_from_slice(&mine[3 * place..][..3]);
            }
        }
        points
    }
}

/// The height of the plane z = const that the first vertex lies in.
fn height(coordinates: &[f64], n: usize, width: usize) -> f64 {
    if n < width { coordinates[n] } else { 0.0 }
}

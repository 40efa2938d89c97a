//! From what a file says to a mesh of known dimension, every refusal at its place in the file.

use super::{MeshFile, hanging};
use crate::error::{InputError, Place};
use nalgebra::SVector;
use regge_curvature::Error;
use regge_curvature::mesh::Mesh;
use std::collections::HashMap;

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
        match Mesh::new(points.clone(), &self.cells) {
            Ok(mesh) => {
                let outer = (0..mesh.count(N - 1)).filter(|&f| !mesh.is_interior(N - 1, f));
                let corners = |f| {
                    let vertices = mesh.vertices(N - 1, f);
                    std::array::from_fn(|i| vertices[i] as usize)
                };
                self.check_hanging(&points, &outer.map(corners).collect::<Vec<_>>())?;
                Ok(mesh)
            }
            Err(error) => {
                if matches!(error, Error::NotAManifold { .. }) {
                    self.check_hanging(&points, &hanging::boundary_faces(&self.cells))?;
                }
                Err(self.refuse(&error))
            }
        }
    }

    fn check_hanging<const N: usize>(
        &self,
        points: &[SVector<f64, N>],
        boundary: &[[usize; N]],
    ) -> Result<(), InputError> {
        let Some((vertex, face)) = hanging::hanging(points, boundary) else {
            return Ok(());
        };
        let reason = format!(
            "vertex {vertex} hangs: it lies in the face {face:?} without being a vertex of it; split the cell there"
        );
        Err(self.at_vertex(vertex, reason))
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

/// The height of the plane z = const that the first vertex lies in.
fn height(coordinates: &[f64], n: usize, width: usize) -> f64 {
    if n < width { coordinates[n] } else { 0.0 }
}

//! Floor 0. Delaunay's triangulation, by Bowyer's and Watson's insertion of one point after the other.

use regge_curvature::Error;
use regge_curvature::linalg::{Mat, Vector, inverse_and_det};
use regge_curvature::mesh::Mesh;
use std::collections::BTreeMap;

/// A simplex with its circumscribed sphere.
#[derive(Clone, Debug)]
struct Cell<const N: usize> {
    vertices: Vec<usize>,
    centre: Vector<f64, N>,
    /// The square of the radius.
    square: f64,
}

/// A triangulation that has Delaunay's property: no vertex is inside the sphere of a cell.
#[derive(Clone, Debug)]
pub struct Delaunay<const N: usize> {
    points: Vec<Vector<f64, N>>,
    cells: Vec<Cell<N>>,
}

/// Cells are flat if their volume is less than that of a cube with sides of this share of theirs.
const FLAT: f64 = 1e-6;

impl<const N: usize> Delaunay<N> {
    /// The convex hull, as a mesh that has the property already.
    ///
    /// # Errors
    /// If the mesh has no coordinates.
    pub fn new(hull: &Mesh<N>) -> Result<Self, Error> {
        let points = hull.points().ok_or(Error::NoCoordinates("a hull"))?;
        let mut all = Self {
            points: points.to_vec(),
            cells: Vec::new(),
        };
        for cell in 0..hull.cell_count() {
            let vertices = hull.vertices(N, cell).iter().map(|v| *v as usize);
            all.cells.extend(all.cell(vertices.collect()));
        }
        Ok(all)
    }

    /// The cell of these vertices; none if they lie in a hyperplane.
    fn cell(&self, vertices: Vec<usize>) -> Option<Cell<N>> {
        let first = self.points[vertices[0]];
        let edges: [Vector<f64, N>; N] =
            std::array::from_fn(|i| self.points[vertices[i + 1]] - first);
        let longest = edges.iter().map(|e| e.norm()).fold(0.0, f64::max);
        let rows = Mat::<f64, N>::from_fn(|i, j| edges[i][j]);
        let volume = inverse_and_det(&(rows * rows.transpose()))
            .1
            .max(0.0)
            .sqrt();
        if volume <= (FLAT * longest).powi(N as i32) {
            return None;
        }
        // Where the distances from all vertices are the same: 2 eᵢ·c = |eᵢ|², from the first one.
        let half = Vector::<f64, N>::from_fn(|i, _| 0.5 * edges[i].norm_squared());
        let from_first = rows.try_inverse()? * half;
        Some(Cell {
            vertices,
            centre: first + from_first,
            square: from_first.norm_squared(),
        })
    }

    /// One more vertex, anywhere in the hull, its boundary included.
    pub fn insert(&mut self, point: Vector<f64, N>) {
        let inside = |cell: &Cell<N>| (cell.centre - point).norm_squared() < cell.square;
        let (gone, kept) = std::mem::take(&mut self.cells)
            .into_iter()
            .partition::<Vec<_>, _>(inside);
        self.cells = kept;
        // The faces of the hole: those of one cell only.
        let mut faces: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
        for cell in &gone {
            for left_out in 0..=N {
                let mut face = cell.vertices.clone();
                face.remove(left_out);
                face.sort_unstable();
                *faces.entry(face).or_default() += 1;
            }
        }
        let new = self.points.len();
        self.points.push(point);
        for (mut face, count) in faces {
            if count == 1 {
                // A face of the hull that the point lies on gives no cell.
                face.push(new);
                self.cells.extend(self.cell(face));
            }
        }
    }

    /// As a mesh.
    ///
    /// # Errors
    /// If the cells are none.
    pub fn mesh(self) -> Result<Mesh<N>, Error> {
        let cells: Vec<Vec<usize>> = self.cells.into_iter().map(|cell| cell.vertices).collect();
        Mesh::new(self.points, &cells)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use regge_curvature::mesh::SplitMix64;

    /// Points in a square and a cube, some of them on its boundary: no vertex is in the sphere of a cell, and the volumes add up.
    fn is_delaunay<const N: usize>(count: usize) {
        let mut all = Delaunay::<N>::new(&Mesh::cube(1).unwrap()).unwrap();
        let mut random = SplitMix64::new(7);
        for number in 0..count {
            let mut point = Vector::<f64, N>::from_fn(|_, _| random.symmetric());
            if number % 3 == 0 {
                point[number % N] = 1.0;
            }
            all.insert(point);
        }
        for cell in &all.cells {
            for (vertex, point) in all.points.iter().enumerate() {
                let square = (cell.centre - point).norm_squared();
                let outside = square > cell.square * (1.0 - 1e-9);
                assert!(outside || cell.vertices.contains(&vertex));
            }
        }
        let mesh = all.mesh().unwrap();
        let stretch = |cell: usize| {
            let jacobian = mesh.jacobian(cell).unwrap();
            inverse_and_det(&(jacobian.transpose() * jacobian)).1.sqrt()
        };
        let whole: f64 = (0..mesh.cell_count()).map(stretch).sum();
        let factorial: f64 = (1..=N).map(|i| i as f64).product();
        assert!(
            (whole / factorial - 2.0_f64.powi(N as i32)).abs() < 1e-10,
            "{whole}"
        );
        assert_eq!(mesh.count(0), count + (1 << N));
    }

    #[test]
    fn no_vertex_is_in_a_sphere() {
        is_delaunay::<2>(60);
        is_delaunay::<3>(40);
    }
}

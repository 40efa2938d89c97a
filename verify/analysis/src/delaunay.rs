//! Floor 0. Delaunay's triangulation, by Bowyer's and Watson's insertion of one point after the other.
//!
//! Points are rounded to a lattice so fine that it moves them by less than 10⁻⁵ for N ≤ 4, and so coarse that the two determinants which decide
//! everything fit into 128 bits: they are exact, and what four points of a face of the hull have to do with a circle, or whether a
//! cell is flat, is not left to rounding.

use regge_curvature::Error;
use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::mesh::Mesh;
use std::collections::BTreeMap;

/// A point of the lattice.
type Place<const N: usize> = [i64; N];

/// A simplex with its circumscribed sphere.
#[derive(Clone, Debug)]
struct Cell<const N: usize> {
    vertices: Vec<usize>,
    /// Is the determinant of the edges from the first vertex positive?
    is_positive: bool,
    centre: Vector<f64, N>,
    /// The square of the radius.
    square: f64,
    /// Is the cell so flat that the two above may be wrong?
    is_flat: bool,
}

/// A triangulation that has Delaunay's property: no vertex is inside the sphere of a cell.
#[derive(Clone, Debug)]
pub struct Delaunay<const N: usize> {
    /// Lattice points on a unit of length.
    unit: f64,
    places: Vec<Place<N>>,
    cells: Vec<Cell<N>>,
}

/// A cell whose volume is less than this share of the product of its edges is flat: the condition of its edges is at most the reciprocal.
const FLAT: f64 = 1e-4;

/// Of other cells the floating point sphere decides if a point is farther from it than this, relatively: rounding is 10⁻¹⁶ times the
/// condition.
const NEAR: f64 = 1e-8;

/// A determinant, by its first row.
fn determinant(rows: &[Vec<i128>], columns: &[usize]) -> i128 {
    let Some((first, others)) = rows.split_first() else {
        return 1;
    };
    let term = |(place, column): (usize, &usize)| {
        let mut rest = columns.to_vec();
        rest.remove(place);
        let sign = if place.is_multiple_of(2) { 1 } else { -1 };
        sign * first[*column] * determinant(others, &rest)
    };
    columns.iter().enumerate().map(term).sum()
}

impl<const N: usize> Delaunay<N> {
    /// The convex hull, as a mesh that has the property already; its points have coordinates from [−1, 1].
    ///
    /// # Errors
    /// If the mesh has no coordinates.
    pub fn new(hull: &Mesh<N>) -> Result<Self, Error> {
        let points = hull.points().ok_or(Error::NoCoordinates("a hull"))?;
        let mut all = Self {
            unit: Self::finest(),
            places: Vec::new(),
            cells: Vec::new(),
        };
        all.places = points.iter().map(|point| all.place(point)).collect();
        for cell in 0..hull.cell_count() {
            let vertices = hull.vertices(N, cell).iter().map(|v| *v as usize);
            all.cells.extend(all.cell(vertices.collect()));
        }
        Ok(all)
    }

    /// The largest power of two for which determinants fit. Differences of coordinates are below 2u = d; a determinant has (N+1)!
    /// terms, each at most d^N times the N d² that is a square of a length.
    fn finest() -> f64 {
        let factorial: usize = (1..=N + 1).product();
        let bits = 126.0 - ((N * factorial) as f64).log2();
        2.0_f64.powi((bits / (N + 2) as f64).floor() as i32 - 1)
    }

    fn place(&self, point: &Vector<f64, N>) -> Place<N> {
        std::array::from_fn(|i| (self.unit * point[i]).round() as i64)
    }

    fn point(&self, vertex: usize) -> Vector<f64, N> {
        Vector::from_fn(|i, _| self.places[vertex][i] as f64 / self.unit)
    }

    /// From one place to another, exactly.
    fn difference(to: &Place<N>, from: &Place<N>) -> Vec<i128> {
        let coordinates = to.iter().zip(from);
        coordinates.map(|(a, b)| i128::from(a - b)).collect()
    }

    /// The cell of these vertices; none if they lie in a hyperplane.
    fn cell(&self, vertices: Vec<usize>) -> Option<Cell<N>> {
        let first = &self.places[vertices[0]];
        let edge = |v: &usize| Self::difference(&self.places[*v], first);
        let exact: Vec<Vec<i128>> = vertices[1..].iter().map(edge).collect();
        let volume = determinant(&exact, &std::array::from_fn::<_, N, _>(|i| i));
        let start = self.point(vertices[0]);
        let edges: [Vector<f64, N>; N] =
            std::array::from_fn(|i| self.point(vertices[i + 1]) - start);
        let rows = Mat::<f64, N>::from_fn(|i, j| edges[i][j]);
        // Where the distances from all vertices are the same: 2 eᵢ·c = |eᵢ|², from the first one.
        let half = Vector::<f64, N>::from_fn(|i, _| 0.5 * edges[i].norm_squared());
        let from_first = rows.try_inverse().map_or(half, |inverse| inverse * half);
        let product: f64 = edges.iter().map(|e| e.norm()).product();
        let share = volume.unsigned_abs() as f64 / self.unit.powi(N as i32) / product;
        (volume != 0).then(|| Cell {
            vertices,
            is_positive: volume > 0,
            centre: start + from_first,
            square: from_first.norm_squared(),
            is_flat: share < FLAT,
        })
    }

    /// Is a place inside the sphere of a cell? Decided exactly where it is near.
    fn has_inside(&self, cell: &Cell<N>, place: &Place<N>, point: &Vector<f64, N>) -> bool {
        let square = (cell.centre - point).norm_squared();
        if !cell.is_flat && (square - cell.square).abs() > NEAR * cell.square {
            return square < cell.square;
        }
        let lifted = |vertex: &usize| {
            let mut row = Self::difference(&self.places[*vertex], place);
            row.push(row.iter().map(|x| x * x).sum());
            row
        };
        let rows: Vec<Vec<i128>> = cell.vertices.iter().map(lifted).collect();
        let columns: Vec<usize> = (0..=N).collect();
        let det = determinant(&rows, &columns);
        // For the centre the last column is constant, and the determinant that of the edges times (−1)^N.
        det != 0 && (det > 0) == (cell.is_positive == N.is_multiple_of(2))
    }

    /// One more vertex, anywhere in the hull, its boundary included.
    pub fn insert(&mut self, point: Vector<f64, N>) {
        let (new, place) = (self.places.len(), self.place(&point));
        self.places.push(place);
        let point = self.point(new);
        let cells = std::mem::take(&mut self.cells);
        let inside = |cell: &Cell<N>| self.has_inside(cell, &place, &point);
        let (gone, kept) = cells.into_iter().partition::<Vec<_>, _>(inside);
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
        let points = (0..self.places.len()).map(|vertex| self.point(vertex));
        let points = points.collect();
        let cells: Vec<Vec<usize>> = self.cells.into_iter().map(|cell| cell.vertices).collect();
        Mesh::new(points, &cells)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use regge_curvature::linalg::inverse_and_det;
    use regge_curvature::mesh::SplitMix64;

    /// Points in a square and a cube, some of them on its boundary: no vertex is in the sphere of a cell, and the volumes add up.
    fn is_delaunay<const N: usize>(points: &[Vector<f64, N>]) {
        let mut all = Delaunay::<N>::new(&Mesh::cube(1).unwrap()).unwrap();
        points.iter().for_each(|point| all.insert(*point));
        for cell in &all.cells {
            for vertex in 0..all.places.len() {
                let square = (cell.centre - all.point(vertex)).norm_squared();
                let outside = square > cell.square * (1.0 - 1e-9);
                assert!(outside || cell.vertices.contains(&vertex));
            }
        }
        let count = points.len();
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

    fn at_random<const N: usize>(count: usize) {
        let mut random = SplitMix64::new(7);
        let point = |number: usize| {
            let mut point = Vector::<f64, N>::from_fn(|_, _| random.symmetric());
            if number.is_multiple_of(3) {
                point[number % N] = 1.0;
            }
            point
        };
        is_delaunay(&(0..count).map(point).collect::<Vec<_>>());
    }

    #[test]
    fn no_vertex_is_in_a_sphere() {
        at_random::<2>(60);
        at_random::<3>(40);
        at_random::<4>(12);
    }

    /// Lattices, whose points lie on common spheres by the dozen.
    #[test]
    fn points_on_a_sphere_are_no_trouble() {
        fn lattice<const N: usize>(side: usize) {
            let points = (0..(side + 1).pow(N as u32)).map(|number| {
                let digit = |i: usize| number / (side + 1).pow(i as u32) % (side + 1);
                Vector::<f64, N>::from_fn(|i, _| 2.0 * digit(i) as f64 / side as f64 - 1.0)
            });
            let inner = points.filter(|p| p.iter().any(|x| x.abs() < 1.0));
            is_delaunay(&inner.collect::<Vec<_>>());
        }
        lattice::<2>(6);
        lattice::<3>(4);
    }
}

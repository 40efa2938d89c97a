//! Floor 2. Triangulations 𝒯 of N-manifolds: 𝒯^k for all k, who contains whom, what is interior.
//!
//! Cells are lists of vertices, kept in ascending order. Coordinates are optional: curvature needs only how the
//! cells hang together and a metric on each. Where there are coordinates, they belong to the vertices of a
//! domain in ℝ^N, or cell by cell to a quotient of ℝ^N (a torus).

mod check;
#[cfg(feature = "serde")]
mod document;
mod generate;
mod incidence;
mod numbering;
mod perturb;
mod shape;

#[cfg(feature = "serde")]
pub(crate) use document::Version;
pub use numbering::{Numbering, Slot};
pub use perturb::SplitMix64;

use crate::Error;
use crate::linalg::{Mat, Vector};
use check::{check_manifold, sorted_cells};
use incidence::Layer;
use std::sync::Arc;

/// Where the vertices are in ℝ^N.
#[derive(Clone, Debug, PartialEq)]
enum Chart<const N: usize> {
    /// Nowhere: an abstract manifold.
    Abstract,
    /// One point a vertex.
    Vertices(Arc<[Vector<f64, N>]>),
    /// N+1 points a cell, in the order of its vertices: a manifold with several charts.
    Cells(Arc<[Vector<f64, N>]>),
}

/// How the simplices of a mesh hang together.
#[derive(Debug)]
struct Complex {
    cells: Vec<u32>,
    layers: Vec<Layer>,
}

/// A triangulated N-manifold, with or without boundary.
///
/// A mesh is a handle: a clone shares the tables, so that spaces and functions own the mesh that they stand on.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "document::Document", into = "document::Document")
)]
pub struct Mesh<const N: usize> {
    complex: Arc<Complex>,
    chart: Chart<N>,
}

/// Meshes are the same if they have the same cells in the same order, and the same coordinates.
impl<const N: usize> PartialEq for Mesh<N> {
    fn eq(&self, other: &Self) -> bool {
        let (one, two) = (&self.complex, &other.complex);
        (Arc::ptr_eq(one, two) || one.cells == two.cells) && self.chart == other.chart
    }
}

/// A cell seen from one of its subsimplices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Side {
    /// The cell.
    pub cell: usize,
    /// Which of the cell's k-simplices it is, in the order of [`crate::simplex::subsets`].
    pub place: usize,
}

impl<const N: usize> Mesh<N> {
    /// The triangulation of a domain in ℝ^N: a point for each vertex, N+1 vertices for each cell, in any order.
    ///
    /// # Errors
    /// Names the cell or vertex that is not finite, out of range, repeated, unused, degenerate, on the wrong side
    /// of a face (overlapping its neighbour), or not part of a manifold.
    pub fn new(points: Vec<Vector<f64, N>>, cells: &[Vec<usize>]) -> Result<Self, Error> {
        for (vertex, p) in points.iter().enumerate() {
            if p.iter().any(|x| !x.is_finite()) {
                let reason = format!("coordinates {:?} are not finite", p.as_slice());
                return Err(Error::Vertex { vertex, reason });
            }
        }
        let mut mesh = Self::new_abstract(points.len(), cells)?;
        mesh.chart = Chart::Vertices(points.into());
        mesh.check_orientation()?;
        Ok(mesh)
    }

    /// A manifold without coordinates.
    ///
    /// # Errors
    /// As [`Mesh::new`], as far as no coordinates are needed.
    pub fn new_abstract(vertices: usize, cells: &[Vec<usize>]) -> Result<Self, Error> {
        if N < 2 || cells.is_empty() {
            return Err(Error::Input(format!(
                "a mesh needs N ≥ 2 and a cell; here N = {N}, {} cells",
                cells.len()
            )));
        }
        let sorted = sorted_cells::<N>(vertices, cells)?;
        let mut layers = incidence::layers(N, &sorted, vertices)?;
        check_manifold::<N>(&layers)?;
        incidence::mark_boundary(N, &mut layers);
        Ok(Self {
            complex: Arc::new(Complex {
                cells: sorted,
                layers,
            }),
            chart: Chart::Abstract,
        })
    }

    /// A manifold with N+1 points for each cell, in the order of the vertices that were given for it.
    ///
    /// # Errors
    /// As [`Mesh::new`]; the points of neighbours need not agree.
    pub fn with_cell_charts(
        vertices: usize,
        cells: &[Vec<usize>],
        corners: &[Vec<Vector<f64, N>>],
    ) -> Result<Self, Error> {
        let mut mesh = Self::new_abstract(vertices, cells)?;
        let mut points = Vec::with_capacity(mesh.complex.cells.len());
        for (cell, (vertices, corners)) in cells.iter().zip(corners).enumerate() {
            if corners.len() != N + 1 || corners.iter().flatten().any(|x| !x.is_finite()) {
                return Err(Error::Cell {
                    cell,
                    reason: format!("needs {} finite corners", N + 1),
                });
            }
            let mut order: Vec<usize> = (0..=N).collect();
            order.sort_by_key(|&i| vertices[i]);
            points.extend(order.into_iter().map(|i| corners[i]));
        }
        if points.len() != mesh.complex.cells.len() {
            return Err(Error::Input(
                "as many lists of corners as cells are needed".into(),
            ));
        }
        mesh.chart = Chart::Cells(points.into());
        mesh.check_orientation()?;
        Ok(mesh)
    }

    /// How many k-simplices, k = 0…N.
    pub fn count(&self, k: usize) -> usize {
        if k == N {
            self.complex.cells.len() / (N + 1)
        } else {
            self.complex.layers[k].interior.len()
        }
    }

    /// How many cells.
    pub fn cell_count(&self) -> usize {
        self.count(N)
    }

    /// The ascending vertices of a k-simplex.
    pub fn vertices(&self, k: usize, simplex: usize) -> &[u32] {
        let list = if k == N {
            &self.complex.cells
        } else {
            &self.complex.layers[k].vertices
        };
        &list[simplex * (k + 1)..(simplex + 1) * (k + 1)]
    }

    /// The k-simplices of a cell, in the order of [`crate::simplex::subsets`] of its vertices, k < N.
    #[inline]
    pub fn simplices_of(&self, cell: usize, k: usize) -> &[u32] {
        let layer = &self.complex.layers[k];
        &layer.of_cell[cell * layer.per_cell..(cell + 1) * layer.per_cell]
    }

    /// The simplex that is at this place in [`Mesh::simplices_of`].
    #[inline]
    pub(crate) fn simplex_of(&self, cell: usize, k: usize, place: usize) -> usize {
        let layer = &self.complex.layers[k];
        debug_assert!(place < layer.per_cell, "a place of another cell");
        layer.of_cell[cell * layer.per_cell + place] as usize
    }

    /// The cells that contain a k-simplex, ascending, k < N.
    pub fn star(&self, k: usize, simplex: usize) -> impl ExactSizeIterator<Item = Side> + '_ {
        let stars = &self.complex.layers[k].stars;
        stars.entries[stars.offsets[simplex]..stars.offsets[simplex + 1]]
            .iter()
            .map(|&(cell, place)| Side {
                cell: cell as usize,
                place: place as usize,
            })
    }

    /// The first cell that contains a k-simplex, k ≤ N.
    #[inline]
    pub fn first_side(&self, k: usize, simplex: usize) -> Side {
        if k == N {
            return Side {
                cell: simplex,
                place: 0,
            };
        }
        let stars = &self.complex.layers[k].stars;
        let (cell, place) = stars.entries[stars.offsets[simplex]];
        Side {
            cell: cell as usize,
            place: place as usize,
        }
    }

    /// Is a k-simplex interior, that is not contained in the boundary? Cells are.
    #[inline]
    pub fn is_interior(&self, k: usize, simplex: usize) -> bool {
        k == N || self.complex.layers[k].interior[simplex]
    }

    /// The interior k-simplices 𝒯̊^k.
    pub fn interior(&self, k: usize) -> impl Iterator<Item = usize> + '_ {
        (0..self.count(k)).filter(move |&s| self.is_interior(k, s))
    }

    /// The interior faces: two cells each.
    pub fn interior_faces(&self) -> impl Iterator<Item = usize> + '_ {
        self.interior(N - 1)
    }

    /// The interior hinges.
    pub fn interior_hinges(&self) -> impl Iterator<Item = usize> + '_ {
        self.interior(N - 2)
    }

    /// No boundary at all?
    pub fn is_closed(&self) -> bool {
        self.complex.layers[N - 1].interior.iter().all(|&i| i)
    }

    /// Σ_k (−1)^k |𝒯^k|.
    pub fn euler_characteristic(&self) -> i64 {
        (0..=N)
            .map(|k| {
                if k.is_multiple_of(2) {
                    self.count(k) as i64
                } else {
                    -(self.count(k) as i64)
                }
            })
            .sum()
    }

    /// Has every cell its place in ℝ^N?
    pub fn has_coordinates(&self) -> bool {
        !matches!(self.chart, Chart::Abstract)
    }

    /// The points of the vertices, where the mesh lies in ℝ^N as a whole.
    pub fn points(&self) -> Option<&[Vector<f64, N>]> {
        match &self.chart {
            Chart::Vertices(points) => Some(points),
            _ => None,
        }
    }

    /// The i-th corner of a cell (its vertices ascending), if there are coordinates.
    pub fn corner(&self, cell: usize, i: usize) -> Option<Vector<f64, N>> {
        match &self.chart {
            Chart::Abstract => None,
            Chart::Vertices(points) => {
                Some(points[self.complex.cells[cell * (N + 1) + i] as usize])
            }
            Chart::Cells(points) => Some(points[cell * (N + 1) + i]),
        }
    }

    /// Column i is corner i+1 minus corner 0: ∂x/∂ξ of the reference coordinates, if there are coordinates.
    pub fn jacobian(&self, cell: usize) -> Option<Mat<f64, N>> {
        let origin = self.corner(cell, 0)?;
        let mut jacobian = Mat::<f64, N>::zeros();
        for i in 0..N {
            jacobian.set_column(i, &(self.corner(cell, i + 1)? - origin));
        }
        Some(jacobian)
    }
}

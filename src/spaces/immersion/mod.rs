//! Surfaces and solids by their points: continuous maps F: 𝒯 → ℝ^m that are polynomial on each cell.
//!
//! F has degree k on a cell; in Bernstein's basis its coefficients are control points f_α ∈ ℝ^m, those of a Lagrange space of
//! degree k. What F makes of a mesh is a Regge metric: g = F*δ, g_ij = ∂_i F · ∂_j F, is a polynomial of degree 2(k − 1) in
//! each cell, and since F is continuous, its tangential-tangential components are. [`Immersion::metric`] is that metric
//! exactly, and [`Immersed`] the one that a formula on ℝ^m leaves on the surface.

mod metric;
mod pull_back;

pub use pull_back::Immersed;

use super::lagrange::Lagrange;
use crate::Error;
use crate::mesh::Mesh;
use crate::simplex::{Bernstein, multi_indices};
use nalgebra::DMatrix;

/// How far, relative to the longest side of a cell's box, the points of two cells on a common simplex may be apart.
const APART: f64 = 1e-9;

/// A continuous map F from a mesh to ℝ^m, polynomial of degree k on each cell.
#[derive(Clone, Debug)]
pub struct Immersion<const N: usize> {
    space: Lagrange<N>,
    /// m.
    width: usize,
    /// f_α, m numbers for each function of the space.
    control: Vec<f64>,
}

impl<const N: usize> Immersion<N> {
    /// Straight cells, k = 1: m = `width` coordinates for each vertex, one vertex after the other.
    ///
    /// # Errors
    /// If there are too few or too many coordinates, or one is not finite.
    ///
    /// ```
    /// use regge_curvature::{Mesh, spaces::Immersion};
    /// # fn main() -> Result<(), regge_curvature::Error> {
    /// // The boundary of a tetrahedron in space: its squared edge lengths are a metric of degree 0.
    /// let mesh = Mesh::<2>::simplex_boundary()?;
    /// let points = vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    /// let g = Immersion::straight(&mesh, 3, points)?.metric();
    /// assert_eq!(g.coefficients(), [1.0, 1.0, 1.0, 2.0, 2.0, 2.0]);
    /// # Ok(())
    /// # }
    /// ```
    pub fn straight(mesh: &Mesh<N>, width: usize, points: Vec<f64>) -> Result<Self, Error> {
        let space = Lagrange::new(mesh, 1);
        if width < N || points.len() != width * space.len() {
            let (n, vertices) = (points.len(), space.len());
            return Err(Error::Input(format!(
                "{n} numbers are not {width} coordinates for each of {vertices} vertices of dimension {N}"
            )));
        }
        if let Some(at) = points.iter().position(|x| !x.is_finite()) {
            let reason = format!("a coordinate is {}", points[at]);
            let vertex = at / width;
            return Err(Error::Vertex { vertex, reason });
        }
        Ok(Self {
            space,
            width,
            control: points,
        })
    }

    /// Cells of degree k through given points: `nodes(cell)` lists F(α/k), m = `width` numbers for each α in the order of
    /// [`multi_indices`] of N+1 variables, the cell's vertices ascending.
    ///
    /// # Errors
    /// Names the first cell with too few or too many points, with one that is not finite, or with points on a face that are not
    /// those of its neighbour.
    pub fn through<'n>(
        mesh: &Mesh<N>,
        degree: usize,
        width: usize,
        nodes: impl Fn(usize) -> &'n [f64],
    ) -> Result<Self, Error> {
        let space = Lagrange::new(mesh, degree);
        let size = space.cell_len();
        let to_control = from_nodes(N, space.degree());
        let mut control = vec![f64::NAN; width * space.len()];
        for cell in 0..mesh.cell_count() {
            let refuse = |reason: String| Err(Error::Cell { cell, reason });
            let points = nodes(cell);
            if width < N || points.len() != width * size {
                let n = points.len();
                return refuse(format!("{n} numbers are not {size} points of ℝ^{width}"));
            }
            if let Some(x) = points.iter().find(|x| !x.is_finite()) {
                return refuse(format!("a coordinate is {x}"));
            }
            let points = DMatrix::from_row_slice(size, width, points);
            let local = &to_control * &points;
            let near = APART * (0..width).map(|c| spread(&points, c)).fold(0.0, f64::max);
            for (i, dof) in space.cell_dofs(cell).enumerate() {
                for c in 0..width {
                    let (known, mine) = (&mut control[width * dof + c], local[(i, c)]);
                    if known.is_nan() {
                        *known = mine;
                    } else if (*known - mine).abs() > near {
                        return refuse(
                            "its points on a face are not those of its neighbour".into(),
                        );
                    }
                }
            }
        }
        Ok(Self {
            space,
            width,
            control,
        })
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh<N> {
        self.space.mesh()
    }

    /// k.
    pub fn degree(&self) -> usize {
        self.space.degree()
    }

    /// m.
    pub fn width(&self) -> usize {
        self.width
    }

    /// The control points f_α of a cell, in the order of [`multi_indices`], m numbers each.
    pub fn local(&self, cell: usize) -> Vec<f64> {
        let mut local = Vec::with_capacity(self.width * self.space.cell_len());
        self.fill_local(cell, &mut local);
        local
    }

    fn fill_local(&self, cell: usize, local: &mut Vec<f64>) {
        local.clear();
        for dof in self.space.cell_dofs(cell) {
            local.extend_from_slice(&self.control[self.width * dof..][..self.width]);
        }
    }

    /// F at the point of a cell with these barycentric coordinates, the cell's vertices ascending.
    pub fn point(&self, cell: usize, lambda: &[f64]) -> Vec<f64> {
        let (basis, local) = (self.space.basis(N), self.local(cell));
        let mut x = vec![0.0; self.width];
        for (i, f) in local.chunks_exact(self.width).enumerate() {
            let b = basis.value(i, lambda);
            for (x, f) in x.iter_mut().zip(f) {
                *x += b * f;
            }
        }
        x
    }
}

/// How long a coordinate's range is.
fn spread(points: &DMatrix<f64>, column: usize) -> f64 {
    points.column(column).max() - points.column(column).min()
}

/// The matrix that makes control points from the points F(α/k): the inverse of B_β(α/k).
fn from_nodes(n: usize, degree: usize) -> DMatrix<f64> {
    let (basis, nodes) = (Bernstein::new(n + 1, degree), multi_indices(n + 1, degree));
    let values = DMatrix::from_fn(nodes.len(), nodes.len(), |node, alpha| {
        let lambda: Vec<f64> = nodes[node]
            .iter()
            .map(|&a| a as f64 / degree as f64)
            .collect();
        basis.value(alpha, &lambda)
    });
    let inverse = values.try_inverse();
    inverse
        .expect("polynomials of degree k are determined by their values on the lattice of order k")
}

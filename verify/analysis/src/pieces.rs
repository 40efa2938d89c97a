//! Floor 1. A mesh and the same cells apart: what is bilinear is taken from the library cell by cell.
//!
//! The library's forms are sums over a whole mesh. On cells that share no vertex the sum for a basis function of one cell is
//! that cell's own contribution, so that a form's small matrices come from the code in use, and are summed up here.

use crate::best::HELD;
use crate::local::local_function;
use nalgebra::DMatrix;
use regge_curvature::Error;
use regge_curvature::linalg::{Mat, Vector, inverse_and_det};
use regge_curvature::mesh::Mesh;
use regge_curvature::spaces::{Lagrange, ReggeFunction, ReggeSpace, TestSpace};

/// A mesh with coordinates, and its cells apart, in the same order.
#[derive(Clone, Debug)]
pub struct Pieces<const N: usize> {
    /// The mesh.
    pub mesh: Mesh<N>,
    apart: Mesh<N>,
}

impl<const N: usize> Pieces<N> {
    /// Takes a mesh apart.
    ///
    /// # Errors
    /// If it has no coordinates.
    pub fn new(mesh: Mesh<N>) -> Result<Self, Error> {
        let (mut points, mut cells) = (Vec::new(), Vec::new());
        for cell in 0..mesh.cell_count() {
            let start = points.len();
            for i in 0..=N {
                let corner = mesh.corner(cell, i);
                points.push(corner.ok_or(Error::NoCoordinates("the analysis"))?);
            }
            cells.push((start..points.len()).collect());
        }
        let apart = Mesh::new(points, &cells)?;
        Ok(Self { mesh, apart })
    }

    /// The diameter of a cell, in ℝ^N.
    pub fn diameter(&self, cell: usize) -> f64 {
        diameter(&self.mesh, cell, &(0..=N).collect::<Vec<_>>())
    }

    /// Columns: an orthonormal basis of ℝ^N in the reference coordinates of a cell.
    pub fn euclidean_frame(&self, cell: usize) -> Mat<f64, N> {
        euclidean_frame(&self.mesh, cell)
    }

    /// The Regge space of degree r on the cells apart.
    pub fn regge_apart(&self, degree: usize) -> ReggeSpace<N> {
        ReggeSpace::new(&self.apart, degree)
    }

    /// The small matrices, cell by cell, of a bilinear form of σ of degree r (rows) and v of degree p (columns): `form` is
    /// the library's, which gives the sums for all v.
    pub fn matrices(
        &self,
        [r, p]: [usize; 2],
        form: &dyn Fn(&ReggeFunction<f64, N>, &Lagrange<N>) -> Vec<f64>,
    ) -> Result<Vec<DMatrix<f64>>, Error> {
        let (tensors, functions) = (self.regge_apart(r), Lagrange::new(&self.apart, p));
        let cells = self.mesh.cell_count();
        let (rows, columns) = (TestSpace::cell_len(&tensors), functions.cell_len());
        let mut all = vec![DMatrix::zeros(rows, columns); cells];
        for k in 0..rows {
            let sums = form(&local_function(&tensors, k)?, &functions);
            for (cell, matrix) in all.iter_mut().enumerate() {
                for (j, dof) in functions.cell_dofs(cell).enumerate() {
                    matrix[(k, j)] = sums[dof];
                }
            }
        }
        Ok(all)
    }
}

/// The largest distance of two of these corners of a cell.
pub fn diameter<const N: usize>(mesh: &Mesh<N>, cell: usize, corners: &[usize]) -> f64 {
    let at = |i: usize| -> Vector<f64, N> { mesh.corner(cell, i).expect("there are coordinates") };
    let pairs = corners
        .iter()
        .flat_map(|a| corners.iter().map(move |b| (*a, *b)));
    pairs.fold(0.0, |max: f64, (a, b)| max.max((at(a) - at(b)).norm()))
}

/// Columns: an orthonormal basis of ℝ^N in the reference coordinates of a cell.
pub fn euclidean_frame<const N: usize>(mesh: &Mesh<N>, cell: usize) -> Mat<f64, N> {
    let jacobian = mesh.jacobian(cell).expect("there are coordinates");
    jacobian
        .try_inverse()
        .expect("cells of a mesh are not flat")
}

/// |det ∂x/∂ξ| of a cell: N! times its volume.
pub fn stretch<const N: usize>(mesh: &Mesh<N>, cell: usize) -> f64 {
    let jacobian = mesh.jacobian(cell).expect("there are coordinates");
    inverse_and_det(&(jacobian.transpose() * jacobian)).1.sqrt()
}

/// max_T h_T/ρ_T, ρ_T the radius of the inscribed ball. Paper: section 4, C_0.
pub fn shape_regularity<const N: usize>(mesh: &Mesh<N>) -> f64 {
    let all: Vec<usize> = (0..=N).collect();
    let of = |cell: usize| {
        // The rows of J⁻¹ are ∇λ_i, one over the heights; 1/ρ is the sum of their lengths.
        let inverse = euclidean_frame(mesh, cell);
        let first: Vector<f64, N> = inverse.transpose() * Vector::repeat(-1.0);
        let others: f64 = inverse.row_iter().map(|row| row.norm()).sum();
        diameter(mesh, cell, &all) * (first.norm() + others)
    };
    (0..mesh.cell_count()).map(of).fold(0.0, f64::max)
}

/// Unknowns: those of σ first, then those of v, of which those on the boundary are held.
#[derive(Clone, Debug)]
pub struct Unknowns<const N: usize> {
    /// The space of σ.
    pub tensors: ReggeSpace<N>,
    /// The space of v.
    pub functions: Lagrange<N>,
    has_tensors: bool,
    has_functions: bool,
    /// The number of each dof of v; held ones have none.
    numbers: Vec<usize>,
}

impl<const N: usize> Unknowns<N> {
    /// For σ of degree r and v of degree p.
    pub fn new(mesh: &Mesh<N>, [r, p]: [usize; 2]) -> Self {
        let functions = Lagrange::new(mesh, p);
        let mut next = 0;
        let number = |dof| {
            let free = functions.vanishes_on_boundary(dof);
            next += usize::from(free);
            if free { next - 1 } else { HELD }
        };
        Self {
            tensors: ReggeSpace::new(mesh, r),
            numbers: (0..functions.len()).map(number).collect(),
            functions,
            has_tensors: true,
            has_functions: true,
        }
    }

    /// How many.
    pub fn len(&self) -> usize {
        let free = self
            .numbers
            .iter()
            .filter(|number| **number != HELD)
            .count();
        self.start() + usize::from(self.has_functions) * free
    }

    /// The first of v.
    fn start(&self) -> usize {
        usize::from(self.has_tensors) * self.tensors.len()
    }

    /// Never.
    pub fn is_empty(&self) -> bool {
        false
    }

    /// Without those of v.
    pub fn tensors_only(self) -> Self {
        Self {
            has_functions: false,
            ..self
        }
    }

    /// Without those of σ.
    pub fn functions_only(self) -> Self {
        Self {
            has_tensors: false,
            ..self
        }
    }

    /// Those of σ on a cell.
    pub fn of_tensors(&self, cell: usize) -> Vec<usize> {
        let mut dofs = Vec::new();
        self.tensors.push_dofs(cell, &mut dofs);
        dofs
    }

    /// Those of v on a cell.
    pub fn of_functions(&self, cell: usize) -> Vec<usize> {
        let start = self.start();
        let unknown = |dof: usize| match self.numbers[dof] {
            HELD => HELD,
            number => start + number,
        };
        self.functions.cell_dofs(cell).map(unknown).collect()
    }
}

//! How much memory the commands for files take.

use super::super::common::Common;
use regge_curvature::norm::{Census, Kind};
use regge_curvature::project::Projection;
use regge_curvature::simplex::binomial;
use regge_readers::mesh::MeshFile;
use regge_terminal::Stop;

/// Bytes of a mesh with its file and its report, a cell, by dimension: what was measured as the peak with everything written, and a
/// tenth more. (10⁶ triangles took 577 MB, 384 000 tetrahedra 295, 98 304 cells of dimension 4 107, 122 880 of dimension 5 209.)
const A_CELL: [f64; 6] = [0.0, 0.0, 620.0, 800.0, 1000.0, 1700.0];

/// Bytes of a coefficient of a cell: of the metric, and of what it is interpolated by (12 for averages, where N = 3).
const A_COEFFICIENT: f64 = 16.0;

/// Bytes of a test function that is listed with its sums and its simplex (168 and 178 for Regge functions of degree 1 and 2).
const A_FUNCTION: f64 = 190.0;

/// What is listed beside the mesh, function by function.
#[derive(Clone, Copy)]
pub enum Listed {
    /// Nothing that a mesh has not anyway.
    Vertices,
    /// Lagrange functions of a degree, onto which the curvature is projected.
    Lagrange(usize),
    /// Regge functions of a degree.
    Regge(usize),
}

impl Listed {
    /// Bytes for a mesh with so many simplices.
    fn memory(self, census: &Census) -> f64 {
        // How many functions belong to a simplex of dimension k, the vertices of which they all charge.
        let on: &dyn Fn(usize) -> usize = match self {
            Self::Vertices => return 0.0,
            Self::Lagrange(q) => &move |k| binomial(q - 1, k),
            Self::Regge(r) => &move |k| binomial(k + 1, 2) * binomial(r + 1, k),
        };
        let counts = census.simplices.iter().enumerate();
        let functions: usize = counts.map(|(k, count)| count * on(k)).sum();
        let projected = match self {
            Self::Lagrange(q) => Projection::memory(&census.simplices, q),
            _ => 0.0,
        };
        A_FUNCTION * functions as f64 + projected
    }
}

/// Refuses a mesh whose curvature needs more memory than there is.
pub fn check(
    common: &Common,
    mesh: &MeshFile,
    degree: usize,
    listed: Listed,
    norm: Option<&str>,
) -> Result<(), Stop> {
    let (n, cells) = (mesh.dimension, mesh.cells.len() as f64);
    let a_cell = A_CELL
        .get(n)
        .or(A_CELL.last())
        .expect("a list with entries");
    let coefficients = (binomial(n + 1, 2) * binomial(degree + n, n)) as f64;
    let census = like_a_cube(n, cells);
    let mut need = 2e7 + cells * (a_cell + A_COEFFICIENT * coefficients) + listed.memory(&census);
    if let Some(kind) = norm.and_then(Kind::<2>::named) {
        need += (kind.memory)(&census, (kind.degree)(degree));
    }
    let what = format!("{}: {} cells", mesh.file.display(), mesh.cells.len());
    common
        .memory
        .check(&what, need, "a coarser mesh or a lower degree needs less")
}

/// About as many simplices as a cube's mesh with so many cells has.
fn like_a_cube(n: usize, cells: f64) -> Census {
    let in_a_box: usize = (1..=n).product();
    let side = (cells / in_a_box as f64).powf(1.0 / n as f64);
    let mut census = Census::cube(n, side.ceil().max(1.0) as usize);
    census.cube = false;
    census
}

//! How much memory the commands for files take.

use super::super::common::Common;
use regge_curvature::norm::{Census, Kind};
use regge_curvature::simplex::binomial;
use regge_readers::mesh::MeshFile;
use regge_terminal::Stop;

/// Bytes of a mesh with its file and its report, a cell, by dimension. For N = 2 a tenth more than the 811 MB that 10⁶ triangles took
/// at their peak with everything written; for N ≥ 3 a guess by how many faces and hinges a cell has, which nobody has measured.
const A_CELL: [f64; 6] = [0.0, 0.0, 900.0, 2500.0, 6000.0, 15000.0];

/// Refuses a mesh whose curvature needs more memory than there is.
pub fn check(
    common: &Common,
    mesh: &MeshFile,
    degree: usize,
    norm: Option<&str>,
) -> Result<(), Stop> {
    let (n, cells) = (mesh.dimension, mesh.cells.len() as f64);
    let a_cell = A_CELL
        .get(n)
        .or(A_CELL.last())
        .expect("a list with entries");
    let coefficients = binomial(n + 1, 2) * binomial(degree + n, n);
    let mut need = 2e7 + cells * (a_cell + 32.0 * coefficients as f64);
    if let Some(kind) = norm.and_then(Kind::<2>::named) {
        // About as many simplices as a cube's mesh with so many cells has.
        let side = (cells / if n == 2 { 2.0 } else { 6.0 }).powf(1.0 / n as f64);
        let mut census = Census::cube(n, side.ceil().max(1.0) as usize);
        census.cube = false;
        need += (kind.memory)(&census, (kind.degree)(degree));
    }
    let what = format!("{}: {} cells", mesh.file.display(), mesh.cells.len());
    common
        .memory
        .check(&what, need, "a coarser mesh or a lower degree needs less")
}

//! The meshes of the settings.

use crate::harness::{Shape, list};
use regge_analysis::families::delaunay;
use regge_curvature::Error;
use regge_curvature::linalg::Vector;
use regge_curvature::mesh::Mesh;

impl Shape {
    /// The mesh.
    pub fn mesh<const N: usize>(self) -> Mesh<N> {
        let mesh = match self {
            Self::Single => Mesh::single(),
            Self::Alfeld => Mesh::alfeld(),
            Self::Cube(side) => {
                Mesh::cube(side).and_then(|m| m.perturbed(0.2 / side as f64, side as u64))
            }
            Self::Delaunay(side) => delaunay(side, 1),
            Self::Stretched => stretched(),
            Self::Torus(side) => Mesh::torus(side),
            Self::Sphere => Mesh::simplex_boundary(),
            Self::Oracle(number) => Ok(regge_oracle::case(number).mesh()),
        };
        // N ≥ 2 and side ≥ 1 (3 on a torus); a tenth of a cell inverts nothing.
        mesh.expect("every shape is a mesh")
    }
}

/// How much cells are pressed together: Delaunay's thirtyfold; Alfeld's, which are flat when N = 4, sixfold. A metric has the
/// components of one with eigenvalues 1 and 1/900 on cells that are not.
pub const fn pressed(dimension: usize) -> f64 {
    if dimension < 4 { 30.0 } else { 6.0 }
}

/// Delaunay's cells, or Alfeld's where N = 4, pressed together along (1, 2, …, N).
fn stretched<const N: usize>() -> Result<Mesh<N>, Error> {
    let mesh = if N < 4 {
        delaunay(1, 1)
    } else {
        Mesh::alfeld()
    }?;
    let points = mesh.points().ok_or(Error::NoCoordinates("a mesh"))?;
    let along = Vector::<f64, N>::from_fn(|i, _| (i + 1) as f64).normalize();
    let less = 1.0 - 1.0 / pressed(N);
    let image = |x: &Vector<f64, N>| x - along * (along.dot(x) * less);
    let cells = list(mesh.cell_count(), |c| {
        let vertices = mesh.vertices(N, c).iter();
        vertices.map(|v| *v as usize).collect()
    });
    Mesh::new(points.iter().map(image).collect(), &cells)
}

/// The mesh without its connections: every cell has vertices of its own. A Regge function there is one without
/// tangential-tangential continuity here.
pub fn torn<const N: usize>(mesh: &Mesh<N>) -> Mesh<N> {
    let count = mesh.cell_count();
    let vertices = count * (N + 1);
    let cells = list(count, |c| list(N + 1, |i| c * (N + 1) + i));
    if mesh.corner(0, 0).is_some() {
        let corner = |c, i| {
            mesh.corner(c, i)
                .expect("a mesh has all coordinates or none")
        };
        let corners = list(count, |c| list(N + 1, |i| corner(c, i)));
        Mesh::with_cell_charts(vertices, &cells, &corners)
    } else {
        Mesh::new_abstract(vertices, &cells)
    }
    .expect("single cells are a mesh")
}

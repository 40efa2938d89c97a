//! The meshes of the settings.

use crate::harness::{Shape, list};
use regge_analysis::families::delaunay;
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
            Self::Torus(side) => Mesh::torus(side),
            Self::Sphere => Mesh::simplex_boundary(),
            Self::Oracle(number) => Ok(regge_oracle::case(number).mesh()),
        };
        // N ≥ 2 and side ≥ 1 (3 on a torus); a tenth of a cell inverts nothing.
        mesh.expect("every shape is a mesh")
    }
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

//! The meshes of the settings.

use crate::harness::Shape;
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
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count())
        .map(|c| (c * (N + 1)..(c + 1) * (N + 1)).collect())
        .collect();
    let corners: Option<Vec<Vec<_>>> = (0..mesh.cell_count())
        .map(|c| (0..=N).map(|i| mesh.corner(c, i)).collect())
        .collect();
    let vertices = mesh.cell_count() * (N + 1);
    match corners {
        Some(corners) => Mesh::with_cell_charts(vertices, &cells, &corners),
        None => Mesh::new_abstract(vertices, &cells),
    }
    .expect("single cells are a mesh")
}

//! The readers on bytes in memory, as far as the command line goes with them: what is fuzzed.
//!
//! Nothing is returned: what counts is that nothing panics, hangs, or takes more memory than it should.

use super::expression::Expression;
use super::lengths::lengths_from;
use super::mesh::{MeshFile, mesh_from};
use super::metric::metric_from;
use regge_curvature::jet::Jet2;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::SmoothTensor;
use std::path::Path;

const FILE: &str = "trial";

/// A mesh file, and the meshes that are built from it.
pub fn mesh(bytes: &[u8]) {
    mesh_called(FILE, bytes);
}

/// [`mesh`] of a file with a name: its ending tells of formats that have no beginning.
pub fn mesh_called(name: &str, bytes: &[u8]) {
    let Ok(file) = mesh_from(Path::new(name), bytes) else {
        return;
    };
    match file.dimension {
        2 => built::<2>(&file),
        3 => built::<3>(&file),
        4 => built::<4>(&file),
        5 => built::<5>(&file),
        _ => {}
    }
}

fn built<const N: usize>(file: &MeshFile) {
    let _ = file.mesh::<N>();
    let _ = file.abstract_mesh::<N>();
    // The metric of its own points, if it is one.
    if let Ok(immersion) = file.immersion::<N>() {
        let _ = immersion.metric();
    }
    let _ = file.cell_groups();
}

/// A metric file, and its value with derivatives at a point.
pub fn metric(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    let Ok(file) = metric_from(Path::new(FILE), text) else {
        return;
    };
    match file.dimension {
        2 => _ = file.metric().at(&point::<2>()),
        3 => _ = file.metric().at(&point::<3>()),
        _ => {}
    }
}

fn point<const N: usize>() -> [Jet2<f64, N>; N] {
    std::array::from_fn(|m| Jet2::coordinate(0.3 - 0.5 * m as f64, m))
}

/// A table of the edge lengths of a tetrahedron's boundary.
pub fn lengths(bytes: &[u8]) {
    if let Ok(mesh) = Mesh::<2>::simplex_boundary() {
        let _ = lengths_from(Path::new(FILE), bytes, &mesh);
    }
}

/// A formula, and its value with derivatives at a point.
pub fn expression(bytes: &[u8]) {
    if let Ok(formula) = Expression::parse(&String::from_utf8_lossy(bytes), 2) {
        let _ = formula.at(&point::<2>());
    }
}

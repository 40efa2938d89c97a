//! Stanford's PLY for surfaces with numbers at their vertices, which MeshLab, Blender and trimesh open.

use crate::curvature::Fields;
use std::io::{self, Write};

/// What is written at vertices, as far as there is such a field.
const NAMES: [&str; 3] = ["area", "K_integral", "K"];

/// Writes the triangles with area, ∫K and K at their vertices, as bytes, the least significant first. NaN is where there is none.
///
/// # Errors
/// Those of `out`.
pub fn write(fields: &Fields, out: &mut dyn Write) -> io::Result<()> {
    let shown: Vec<_> = NAMES
        .iter()
        .filter_map(|name| fields.on_points.iter().find(|field| field.0 == *name))
        .collect();
    let (points, cells) = (fields.points.len() / 3, fields.cells.len() / 3);
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\ncomment regge {}: K is the Gauss curvature R/2\nelement vertex {points}\n",
        env!("CARGO_PKG_VERSION")
    )?;
    for name in ["x", "y", "z"]
        .iter()
        .chain(shown.iter().map(|field| &field.0))
    {
        writeln!(out, "property double {name}")?;
    }
    write!(
        out,
        "element face {cells}\nproperty list uchar int vertex_indices\nend_header\n"
    )?;
    for (vertex, point) in fields.points.chunks_exact(3).enumerate() {
        for x in point {
            out.write_all(&x.to_le_bytes())?;
        }
        for field in &shown {
            out.write_all(&field.1[vertex].to_le_bytes())?;
        }
    }
    for cell in fields.cells.chunks_exact(3) {
        out.write_all(&[3])?;
        for vertex in cell {
            out.write_all(&vertex.to_le_bytes())?;
        }
    }
    Ok(())
}

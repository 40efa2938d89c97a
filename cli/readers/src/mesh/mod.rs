//! Meshes from files: Gmsh 2.2 and 4.1, our own JSON, and the formats of surfaces: OBJ, PLY, STL, OFF, VTK, MEDIT.

mod build;
mod cursor;
mod formats;
mod gmsh;
mod hanging;
mod json;
mod kinds;
mod lattice;
mod soup;
#[cfg(test)]
mod tests;
mod unused;

use super::error::{Fault, InputError, Place, bytes_of};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// A mesh file that has been read, of whatever dimension, with the places of its parts.
#[derive(Clone, Debug)]
pub struct MeshFile {
    /// The file.
    pub file: PathBuf,
    /// N.
    pub dimension: usize,
    /// How many vertices.
    pub vertices: usize,
    /// Coordinates, `width` of them for each vertex in the order of the file; none for an abstract manifold.
    pub coordinates: Vec<f64>,
    /// How many coordinates a vertex has: N, or 3 in Gmsh's files.
    pub width: usize,
    /// N+1 vertices a cell, by their index in the file.
    pub cells: Vec<Vec<usize>>,
    /// The physical groups.
    pub groups: Vec<Group>,
    /// The geometry of cells with curved edges; none where they are straight.
    pub curved: Option<Curved>,
    /// What was done to the file's contents that its author may want to know, a line each.
    pub notes: Vec<String>,
    vertex_places: Vec<Place>,
    cell_places: Vec<Place>,
}

/// Cells of order k > 1 by the places of their nodes.
#[derive(Clone, Debug)]
pub struct Curved {
    /// k.
    pub order: usize,
    /// The nodes of each cell in Gmsh's order, three coordinates each.
    points: Vec<f64>,
    /// Which points of the file are nodes but no corners of cells.
    nodes: Vec<bool>,
}

/// A physical group of Gmsh's: what has been given one tag.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Group {
    /// The dimension of its members.
    pub dimension: usize,
    /// Its tag.
    pub tag: i32,
    /// Its name, if it has one.
    pub name: Option<String>,
    /// Its cells, if its members are cells.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub cells: Vec<u32>,
    /// The vertices of its members, if they are of a lower dimension.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub simplices: Vec<Vec<usize>>,
}

impl MeshFile {
    /// For each cell the tag of its first group; 0 where it has none.
    pub fn cell_groups(&self) -> Vec<i32> {
        let mut tags = vec![0; self.cells.len()];
        for group in self.groups.iter().rev() {
            for &cell in &group.cells {
                tags[cell as usize] = group.tag;
            }
        }
        tags
    }
}

/// Reads a mesh, in the format that the file's beginning shows: JSON ({), Gmsh ($MeshFormat), PLY, OFF, VTK, MEDIT, STL, OBJ; for the
/// last two the ending of its name counts as well.
///
/// # Errors
/// Names the file, the line or byte, and what is wrong.
pub fn read_mesh(file: &Path) -> Result<MeshFile, InputError> {
    mesh_from(file, &bytes_of(file)?)
}

/// [`read_mesh`] of a file that is in memory.
pub(super) fn mesh_from(file: &Path, bytes: &[u8]) -> Result<MeshFile, InputError> {
    // Editors of Windows put a mark before the text.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let parsed = match bytes.iter().find(|b| !b.is_ascii_whitespace()) {
        Some(b'{') => json::parse(bytes),
        Some(b'$') => gmsh::parse(bytes),
        _ => match formats::reader(file, bytes) {
            Some(parse) => parse(bytes),
            None => Err(Fault::new(
                Place::Whole,
                "is no mesh: none of Gmsh ($MeshFormat), JSON ({), OBJ, PLY, STL, OFF, VTK, MEDIT",
            )),
        },
    };
    let mesh = parsed.map_err(|fault| fault.of(file))?;
    Ok(MeshFile {
        file: file.into(),
        ..mesh
    })
}

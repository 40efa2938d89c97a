//! The formats of surfaces and solids beside Gmsh's: which one a file is in, and its reader.

mod lines;
mod medit;
mod obj;
mod off;
mod ply;
mod stl;
#[cfg(test)]
mod tests;
mod vtk;
#[cfg(test)]
mod written;

use super::MeshFile;
use crate::error::Fault;
use std::path::Path;

/// A reader of one format; the file's name is added by the caller.
pub type Reader = fn(&[u8]) -> Result<MeshFile, Fault>;

/// The reader for a file, by its beginning; where that says nothing (OBJ, STL), by its name's ending too.
pub fn reader(file: &Path, bytes: &[u8]) -> Option<Reader> {
    let text = bytes.trim_ascii_start();
    let first: Vec<u8> = text
        .iter()
        .take_while(|b| !b.is_ascii_whitespace())
        .take(64)
        .map(u8::to_ascii_lowercase)
        .collect();
    let ending = file.extension().map(|e| e.to_ascii_lowercase());
    let ends = |name: &str| ending.as_ref().is_some_and(|e| e == name);
    match first.as_slice() {
        b"ply" => Some(ply::parse),
        b"meshversionformatted" => Some(medit::parse),
        b"#" if text.starts_with(b"# vtk DataFile") => Some(vtk::legacy),
        word if word.starts_with(b"<?xml") || word.starts_with(b"<vtkfile") => Some(vtk::xml),
        word if off::begins(word) => Some(off::parse),
        _ if ends("obj") => Some(obj::parse),
        _ if ends("stl") || stl::is_binary(bytes) => Some(stl::parse),
        b"solid" => Some(stl::parse),
        b"#" | b"v" | b"vn" | b"vt" | b"f" | b"g" | b"o" | b"s" | b"mtllib" | b"usemtl" => {
            Some(obj::parse)
        }
        _ if ends("mesh") => Some(medit::parse),
        _ if ends("meshb") => Some(medit::refuse_binary),
        _ => None,
    }
}

/// How many corners a polygon has, in words.
fn polygon(corners: usize) -> String {
    match corners {
        4 => "a quadrilateral".into(),
        5 => "a pentagon".into(),
        6 => "a hexagon".into(),
        n => format!("a polygon with {n} corners"),
    }
}

/// What is said of a face that is no triangle.
fn no_triangle(corners: usize) -> String {
    match corners {
        0..=2 => format!("a face with {corners} corners: remove it"),
        n => format!(
            "{}: only triangles have a metric by their edges; triangulate the surface before",
            polygon(n)
        ),
    }
}

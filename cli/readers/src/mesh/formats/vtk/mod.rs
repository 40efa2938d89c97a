//! VTK's formats: legacy files as text and bytes, and XML files of unstructured grids (.vtu) and surfaces (.vtp).

mod arrays;
mod legacy;
mod tags;
mod xml;

pub use legacy::parse as legacy;
pub use xml::parse as xml;

use super::super::soup::Soup;
use super::no_triangle;
use crate::error::{Fault, Place};

/// VTK's number for a polygon, which may be a triangle.
const POLYGON: u8 = 7;

/// Adds a cell by VTK's number for its kind.
fn add(soup: &mut Soup, place: Place, kind: u8, points: Vec<usize>) -> Result<(), Fault> {
    let corners = points.len();
    match (kind, corners) {
        (5 | POLYGON, 3) => soup.triangles.push(place, points),
        (10, 4) => soup.tetrahedra.push(place, points),
        // Nothing, points and lines.
        (0..=4 | 21 | 35 | 68, _) => {}
        (5, _) | (10, _) => {
            let reason = format!("a simplex with {corners} points");
            return Err(Fault::new(place, reason));
        }
        (POLYGON, _) => return Err(Fault::new(place, no_triangle(corners))),
        (8 | 9, _) => return Err(Fault::new(place, no_triangle(4))),
        _ => {
            let reason = format!(
                "{} (type {kind}): triangles and tetrahedra with straight edges only",
                name(kind)
            );
            return Err(Fault::new(place, reason));
        }
    }
    Ok(())
}

fn name(kind: u8) -> &'static str {
    match kind {
        6 => "a strip of triangles",
        11 => "a voxel",
        12 => "a hexahedron",
        13 => "a wedge",
        14 => "a pyramid",
        22 | 34 => "a triangle of order 2",
        23 | 28 | 70 => "a quadrilateral of higher order",
        24 => "a tetrahedron of order 2",
        42 => "a polyhedron",
        69 => "a triangle of higher order",
        71 => "a tetrahedron of higher order",
        _ => "a cell of another kind",
    }
}

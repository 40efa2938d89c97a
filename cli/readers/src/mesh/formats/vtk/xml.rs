//! XML files: unstructured grids and surfaces, in one piece or several.

use super::super::super::MeshFile;
use super::super::super::soup::Soup;
use super::arrays::{Storage, numbers};
use super::tags::{Tag, Tags};
use super::{POLYGON, add};
use crate::error::{Fault, Place};

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let mut tags = Tags::new(bytes);
    let Some(root) = tags.next_tag()?.filter(|tag| tag.name == "VTKFile") else {
        return Err(Fault::new(
            Place::Line(1),
            "an XML file that is none of VTK's",
        ));
    };
    let surface = match root.expect("type")? {
        "UnstructuredGrid" => false,
        "PolyData" => true,
        other => {
            let reason =
                format!("a file of type {other}: UnstructuredGrid and PolyData can be read");
            return Err(Fault::new(root.place, reason));
        }
    };
    let storage = storage(bytes, &root)?;
    let mut soup = Soup::new();
    while let Some(tag) = tags.next_tag()? {
        match tag.name {
            "Piece" => piece(&mut tags, &tag, surface, &storage, &mut soup)?,
            // What follows may be bytes.
            "AppendedData" => break,
            _ => {}
        }
    }
    soup.finish()
}

/// How arrays are stored.
fn storage<'a>(bytes: &'a [u8], root: &Tag<'_>) -> Result<Storage<'a>, Fault> {
    let compressed = match root.get("compressor") {
        None => false,
        Some("vtkZLibDataCompressor") => true,
        Some(other) => {
            let reason = format!("arrays compressed by {other}: zlib can be read");
            return Err(Fault::new(root.place, reason));
        }
    };
    let mark = b"<AppendedData";
    let start = bytes.windows(mark.len()).position(|w| w == mark);
    let appended = match start {
        None => None,
        Some(start) => {
            let tag = Tags::new(&bytes[start..]).next_tag()?;
            let tag = tag.expect("the mark that was found");
            let coded = tag.expect("encoding")? == "base64";
            let behind = &bytes[start + tag.end..];
            let data = behind.iter().position(|b| *b == b'_');
            data.map(|data| (&behind[data + 1..], coded))
        }
    };
    Ok(Storage {
        big_endian: root.get("byte_order") == Some("BigEndian"),
        long: root.get("header_type") == Some("UInt64"),
        compressed,
        appended,
        most: (1 << 20) + 8 * bytes.len(),
    })
}

/// The arrays of a piece that make a mesh.
#[derive(Default)]
struct Arrays {
    points: Vec<f64>,
    connectivity: Vec<f64>,
    offsets: Vec<f64>,
    types: Option<Vec<f64>>,
    strips: usize,
}

fn piece(
    tags: &mut Tags<'_>,
    piece: &Tag<'_>,
    surface: bool,
    storage: &Storage<'_>,
    soup: &mut Soup,
) -> Result<(), Fault> {
    let mut arrays = Arrays::default();
    let mut section = "";
    loop {
        let Some(tag) = tags.next_tag()? else {
            return Err(Fault::new(
                piece.place,
                "a Piece without an end: the file may be truncated",
            ));
        };
        match (tag.name, section) {
            ("/Piece", _) => break,
            ("Points" | "Cells" | "Polys" | "Strips", _) => section = tag.name,
            ("/Points" | "/Cells" | "/Polys" | "/Strips", _) => section = "",
            ("DataArray", "Points") => {
                if tag.get("NumberOfComponents") != Some("3") {
                    return Err(Fault::new(
                        tag.place,
                        "points with other than three coordinates",
                    ));
                }
                arrays.points = numbers(&tag, tags.text(), storage)?;
            }
            ("DataArray", "Cells" | "Polys") => {
                let list = match tag.expect("Name")? {
                    "connectivity" => &mut arrays.connectivity,
                    "offsets" => &mut arrays.offsets,
                    // Polygons are all of one kind.
                    "types" if !surface => arrays.types.insert(Vec::new()),
                    _ => continue,
                };
                *list = numbers(&tag, tags.text(), storage)?;
            }
            ("DataArray", "Strips") => {
                arrays.strips += numbers(&tag, tags.text(), storage)?.len();
            }
            _ => {}
        }
    }
    let cells = if surface {
        "NumberOfPolys"
    } else {
        "NumberOfCells"
    };
    let (points, cells) = (piece.number("NumberOfPoints")?, piece.number(cells)?);
    arrays.check(piece.place, points, cells, surface)?;
    arrays.add_to(soup, piece.place)
}

impl Arrays {
    fn check(&self, place: Place, points: usize, cells: usize, surface: bool) -> Result<(), Fault> {
        let types = self.types.as_ref().map_or(0, Vec::len);
        let expected = [
            ("coordinates", self.points.len(), points.saturating_mul(3)),
            ("offsets", self.offsets.len(), cells),
            ("types", types, if surface { 0 } else { cells }),
            ("points of strips of triangles", self.strips, 0),
        ];
        for (what, found, stated) in expected {
            if found != stated {
                let reason = format!("{found} {what}, the Piece should have {stated}");
                return Err(Fault::new(place, reason));
            }
        }
        Ok(())
    }

    fn add_to(&self, soup: &mut Soup, place: Place) -> Result<(), Fault> {
        let (before, points) = (soup.len(), self.points.len() / 3);
        for (point, x) in self.points.chunks_exact(3).enumerate() {
            if let Some(x) = x.iter().find(|x| !x.is_finite()) {
                return Err(Fault::new(
                    place,
                    format!("a coordinate of point {point} is {x}"),
                ));
            }
            soup.point(place, x);
        }
        let mut start = 0;
        for (cell, end) in self.offsets.iter().enumerate() {
            let list = self.connectivity.get(start..*end as usize);
            let index = |x: &f64| {
                (0.0..points as f64)
                    .contains(x)
                    .then_some(before + *x as usize)
            };
            let list: Option<Vec<usize>> = list.and_then(|list| list.iter().map(index).collect());
            let Some(list) = list else {
                let reason = format!("cell {cell} names a point that does not exist");
                return Err(Fault::new(place, reason));
            };
            let kind = self
                .types
                .as_ref()
                .map_or(POLYGON, |types| types[cell] as u8);
            add(soup, place, kind, list)
                .map_err(|fault| Fault::new(place, format!("cell {cell} is {}", fault.reason)))?;
            start = *end as usize;
        }
        Ok(())
    }
}

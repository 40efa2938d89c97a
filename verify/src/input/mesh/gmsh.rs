//! Gmsh's format, versions 2.2 and 4.1, as text and binary.

use super::MeshFile;
use super::cursor::{Cursor, Encoding};
use super::elements::{Kind, kind};
use crate::input::error::{Fault, Place};
use std::collections::{HashMap, HashSet};
use std::path::PathBuf;

/// What has been read so far.
#[derive(Default)]
struct Reader {
    old: bool,
    index: HashMap<u64, usize>,
    coordinates: Vec<f64>,
    vertex_places: Vec<Place>,
    triangles: Vec<(Place, Vec<u64>)>,
    tetrahedra: Vec<(Place, Vec<u64>)>,
}

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let cursor = &mut Cursor::new(bytes);
    let mut reader = Reader::default();
    reader.header(cursor)?;
    while !cursor.is_at_end() {
        let section = cursor.word()?;
        match section {
            "$Nodes" if reader.old => reader.nodes_2(cursor)?,
            "$Nodes" => reader.nodes_4(cursor)?,
            "$Elements" if reader.old => reader.elements_2(cursor)?,
            "$Elements" => reader.elements_4(cursor)?,
            _ => {
                skip(cursor, section)?;
                continue;
            }
        }
        expect(cursor, &section.replace('$', "$End"))?;
    }
    reader.finish()
}

/// Passes over a section that is not needed.
fn skip(cursor: &mut Cursor<'_>, section: &str) -> Result<(), Fault> {
    let Some(name) = section.strip_prefix('$') else {
        return Err(cursor.fault(format!("'{section}' where a section is expected")));
    };
    let end = format!("$End{name}");
    if cursor.skip_past(end.as_bytes()) {
        return Ok(());
    }
    Err(cursor.fault(format!("{end} is missing: the file may be truncated")))
}

fn expect(cursor: &mut Cursor<'_>, word: &str) -> Result<(), Fault> {
    let found = cursor.word()?;
    match found == word {
        true => Ok(()),
        false => Err(cursor.fault(format!("'{found}' where {word} is expected"))),
    }
}

impl Reader {
    /// $MeshFormat: version, text or binary, the size of a number.
    fn header(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        expect(cursor, "$MeshFormat")?;
        self.old = match cursor.word()? {
            "2.2" => true,
            "4.1" => false,
            other => {
                let reason = format!("version {other} of Gmsh's format; 2.2 and 4.1 can be read");
                return Err(cursor.fault(reason));
            }
        };
        let binary = cursor.spelled::<u8>("0 (text) or 1 (binary)")? != 0;
        if cursor.spelled::<u8>("the size of a number")? != 8 {
            return Err(cursor.fault("numbers of other than 8 bytes"));
        }
        if binary {
            cursor.finish_line();
            cursor.encoding = Encoding::Binary { big_endian: false };
            let big_endian = match cursor.int("1")? {
                1 => false,
                0x0100_0000 => true,
                _ => return Err(cursor.fault("the byte order cannot be told")),
            };
            cursor.encoding = Encoding::Binary { big_endian };
        }
        expect(cursor, "$EndMeshFormat")
    }

    fn node(&mut self, place: Place, tag: u64, x: [f64; 3]) -> Result<(), Fault> {
        if self.index.insert(tag, self.vertex_places.len()).is_some() {
            return Err(Fault::new(place, format!("node {tag} is given twice")));
        }
        self.vertex_places.push(place);
        self.coordinates.extend(x);
        Ok(())
    }

    fn nodes_2(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let count: u64 = cursor.spelled("the number of nodes")?;
        cursor.finish_line();
        for _ in 0..count {
            cursor.align();
            let place = cursor.place();
            let tag = tag(cursor, "a node's number")?;
            let x = [
                cursor.coordinate()?,
                cursor.coordinate()?,
                cursor.coordinate()?,
            ];
            self.node(place, tag, x)?;
        }
        Ok(())
    }

    fn nodes_4(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        cursor.finish_line();
        let blocks = cursor.size("the number of blocks")?;
        for what in ["the number of nodes", "the least tag", "the largest tag"] {
            cursor.size(what)?;
        }
        for _ in 0..blocks {
            let dimension = cursor.int("a block's dimension")?;
            cursor.int("a block's tag")?;
            let parametric = cursor.int("0 or 1")? != 0;
            let count = cursor.count("the number of nodes of a block")?;
            let mut tags = Vec::new();
            for _ in 0..count {
                tags.push(cursor.size("a node's tag")?);
            }
            let extra = if parametric { dimension.clamp(0, 3) } else { 0 };
            for tag in tags {
                cursor.align();
                let place = cursor.place();
                let x = [
                    cursor.coordinate()?,
                    cursor.coordinate()?,
                    cursor.coordinate()?,
                ];
                for _ in 0..extra {
                    cursor.coordinate()?;
                }
                self.node(place, tag, x)?;
            }
        }
        Ok(())
    }

    /// Text: one element a line. Binary: blocks of elements with one header.
    fn elements_2(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        let total: u64 = cursor.spelled("the number of elements")?;
        cursor.finish_line();
        let ascii = cursor.encoding == Encoding::Ascii;
        let mut done = 0;
        while done < total {
            cursor.align();
            if ascii {
                cursor.int("an element's number")?;
            }
            let kind = element(cursor)?;
            let block = if ascii {
                1
            } else {
                cursor.int("a number of elements")?.max(1)
            };
            let tags = cursor.int("a number of tags")?;
            for _ in 0..block {
                let place = cursor.place();
                if !ascii {
                    cursor.int("an element's number")?;
                }
                for _ in 0..tags {
                    cursor.int("a tag")?;
                }
                self.element(cursor, place, kind, tag)?;
            }
            done += u64::from(block.unsigned_abs());
        }
        Ok(())
    }

    fn elements_4(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Fault> {
        cursor.finish_line();
        let blocks = cursor.size("the number of blocks")?;
        for what in ["the number of elements", "the least tag", "the largest tag"] {
            cursor.size(what)?;
        }
        for _ in 0..blocks {
            cursor.int("a block's dimension")?;
            cursor.int("a block's tag")?;
            let kind = element(cursor)?;
            let count = cursor.count("the number of elements of a block")?;
            for _ in 0..count {
                cursor.align();
                let place = cursor.place();
                cursor.size("an element's tag")?;
                self.element(cursor, place, kind, |cursor, what| cursor.size(what))?;
            }
        }
        Ok(())
    }

    /// The nodes of one element.
    fn element(
        &mut self,
        cursor: &mut Cursor<'_>,
        place: Place,
        kind: Kind,
        node: fn(&mut Cursor<'_>, &str) -> Result<u64, Fault>,
    ) -> Result<(), Fault> {
        let mut nodes = Vec::with_capacity(kind.nodes());
        for _ in 0..kind.nodes() {
            nodes.push(node(cursor, "a node of the element")?);
        }
        match kind {
            Kind::Triangle => self.triangles.push((place, nodes)),
            Kind::Tetrahedron => self.tetrahedra.push((place, nodes)),
            Kind::Passed(_) | Kind::Refused(_) => {}
        }
        Ok(())
    }

    fn finish(self) -> Result<MeshFile, Fault> {
        if let Some(place) = self.lost_triangle() {
            let reason =
                "a triangle that is no face of a tetrahedron: the mesh is of mixed dimension";
            return Err(Fault::new(place, reason));
        }
        let dimension = if self.tetrahedra.is_empty() { 2 } else { 3 };
        let elements = match dimension {
            2 => self.triangles,
            _ => self.tetrahedra,
        };
        if elements.is_empty() {
            return Err(Fault::new(
                Place::Whole,
                "there is no triangle and no tetrahedron",
            ));
        }
        let (mut cells, mut cell_places) = (Vec::new(), Vec::new());
        for (place, nodes) in elements {
            let find = |tag: &u64| match self.index.get(tag) {
                Some(index) => Ok(*index),
                None => Err(Fault::new(place, format!("node {tag} does not exist"))),
            };
            cells.push(nodes.iter().map(find).collect::<Result<_, _>>()?);
            cell_places.push(place);
        }
        Ok(MeshFile {
            file: PathBuf::new(),
            dimension,
            vertices: self.vertex_places.len(),
            coordinates: self.coordinates,
            width: 3,
            cells,
            vertex_places: self.vertex_places,
            cell_places,
        })
    }

    /// In a mesh of tetrahedra: a triangle that is not a face of one.
    fn lost_triangle(&self) -> Option<Place> {
        if self.tetrahedra.is_empty() || self.triangles.is_empty() {
            return None;
        }
        let mut faces = HashSet::new();
        for (_, nodes) in &self.tetrahedra {
            for out in 0..4 {
                let mut face: Vec<u64> = (0..4).filter(|i| *i != out).map(|i| nodes[i]).collect();
                face.sort_unstable();
                faces.insert(face);
            }
        }
        let lost = |nodes: &[u64]| {
            let mut face = nodes.to_vec();
            face.sort_unstable();
            !faces.contains(&face)
        };
        self.triangles.iter().find(|t| lost(&t.1)).map(|t| t.0)
    }
}

/// A 32-bit tag.
fn tag(cursor: &mut Cursor<'_>, what: &str) -> Result<u64, Fault> {
    let tag = cursor.int(what)?;
    u64::try_from(tag).map_err(|_| cursor.fault(format!("{what} is {tag}")))
}

/// An element's type, if such can be read.
fn element(cursor: &mut Cursor<'_>) -> Result<Kind, Fault> {
    let number = cursor.int("an element's type")?;
    match kind(number) {
        Some(Kind::Refused(name)) => Err(cursor.fault(format!(
            "a {name} (type {number}): triangles and tetrahedra with straight edges only"
        ))),
        Some(kind) => Ok(kind),
        None => Err(cursor.fault(format!("an element of unknown type {number}"))),
    }
}

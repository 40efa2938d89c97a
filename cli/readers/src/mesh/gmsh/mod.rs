//! Gmsh's format, versions 2.2 and 4.1, as text and binary.

mod elements;
mod groups;
mod nodes;

use super::cursor::{Cursor, Encoding};
use super::kinds::{Kind, kind};
use super::{Curved, MeshFile};
use crate::error::{Fault, Place};
use elements::Simplices;
use groups::Groups;
use nodes::Nodes;
use std::path::PathBuf;

/// What has been read so far.
struct Reader {
    old: bool,
    nodes: Nodes,
    /// Points, lines, triangles and tetrahedra.
    simplices: [Simplices; 4],
    groups: Groups,
}

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let cursor = &mut Cursor::new(bytes);
    let old = header(cursor)?;
    let mut reader = Reader {
        old,
        nodes: Nodes::default(),
        simplices: [1, 2, 3, 4].map(Simplices::new),
        groups: Groups::new(old),
    };
    while !cursor.is_at_end() {
        let section = cursor.word()?;
        match section {
            "$Nodes" if reader.old => reader.nodes.read_2(cursor)?,
            "$Nodes" => reader.nodes.read_4(cursor)?,
            "$Elements" if reader.old => reader.elements_2(cursor)?,
            "$Elements" => reader.elements_4(cursor)?,
            "$PhysicalNames" => reader.groups.names(cursor)?,
            "$Entities" if !reader.old => reader.groups.entities(cursor)?,
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

/// $MeshFormat: version, text or binary, the size of a number. Is it version 2.2?
fn header(cursor: &mut Cursor<'_>) -> Result<bool, Fault> {
    expect(cursor, "$MeshFormat")?;
    let old = match cursor.word()? {
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
    expect(cursor, "$EndMeshFormat")?;
    Ok(old)
}

impl Reader {
    fn finish(mut self) -> Result<MeshFile, Fault> {
        let [_, _, triangles, tetrahedra] = &self.simplices;
        if let Some(place) = elements::lost_triangle(triangles, tetrahedra) {
            let reason =
                "a triangle that is no face of a tetrahedron: the mesh is of mixed dimension";
            return Err(Fault::new(place, reason));
        }
        let dimension = if tetrahedra.is_empty() { 2 } else { 3 };
        if self.old {
            for (k, simplices) in self.simplices.iter_mut().enumerate() {
                simplices.merge(k != dimension)?;
            }
        }
        let elements = &self.simplices[dimension];
        if elements.is_empty() {
            return Err(Fault::new(
                Place::Whole,
                "there is no triangle and no tetrahedron",
            ));
        }
        let cells = (0..elements.len())
            .map(|i| elements.vertices(i, &self.nodes))
            .collect::<Result<_, _>>()?;
        let curved = self.curved(dimension)?;
        let groups = self
            .groups
            .collect(&self.simplices, &self.nodes, dimension)?;
        let [_, _, mut triangles, mut tetrahedra] = self.simplices;
        let elements = if dimension == 2 {
            &mut triangles
        } else {
            &mut tetrahedra
        };
        let mut mesh = MeshFile {
            file: PathBuf::new(),
            dimension,
            curved,
            vertices: self.nodes.len(),
            width: 3,
            cells,
            groups,
            notes: Vec::new(),
            cell_places: std::mem::take(&mut elements.places),
            coordinates: self.nodes.coordinates,
            vertex_places: self.nodes.places,
        };
        mesh.drop_unused();
        Ok(mesh)
    }
}

impl Reader {
    /// The places of all nodes of curved cells.
    fn curved(&self, dimension: usize) -> Result<Option<Curved>, Fault> {
        let (cells, nodes) = (&self.simplices[dimension], &self.nodes);
        if cells.order == 1 {
            return Ok(None);
        }
        let mut points = Vec::new();
        let mut used = vec![false; nodes.len()];
        for i in 0..cells.len() {
            let corners = cells.vertices(i, nodes)?;
            let further = cells.further(i, nodes)?;
            for node in corners
                .into_iter()
                .chain(further.iter().map(|&node| node as usize))
            {
                points.extend_from_slice(&nodes.coordinates[3 * node..][..3]);
            }
            further.iter().for_each(|&node| used[node as usize] = true);
        }
        Ok(Some(Curved {
            order: cells.order,
            points,
            nodes: used,
        }))
    }
}

/// An element's type, if such can be read.
fn element(cursor: &mut Cursor<'_>) -> Result<Kind, Fault> {
    let number = cursor.int("an element's type")?;
    match kind(number) {
        Some(Kind::Refused(name)) => Err(cursor.fault(format!(
            "a {name} (type {number}): triangles and tetrahedra up to order 4 can be read"
        ))),
        Some(kind) => Ok(kind),
        None => Err(cursor.fault(format!("an element of unknown type {number}"))),
    }
}

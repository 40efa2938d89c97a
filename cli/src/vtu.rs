//! VTK's XML format for unstructured grids (.vtu), which ParaView opens: arrays as bytes behind the XML.

use crate::curvature::Fields;
use std::io::{self, Write};

/// VTK's numbers for a vertex, a line, a triangle and a tetrahedron.
const KINDS: [u8; 4] = [1, 3, 5, 10];

/// An array of the file: its name, its type, how many components, its bytes.
struct Array<'a> {
    name: &'a str,
    kind: &'static str,
    components: usize,
    data: Data<'a>,
}

/// What an array holds.
enum Data<'a> {
    Doubles(&'a [f64]),
    Ints(&'a [u32]),
    Tags(&'a [i32]),
    /// The ends of lists of one length.
    Ends(usize, usize),
    /// One byte, so many times.
    Bytes(u8, usize),
}

impl Data<'_> {
    fn bytes(&self) -> u64 {
        (match self {
            Self::Doubles(list) => 8 * list.len(),
            Self::Ints(list) => 4 * list.len(),
            Self::Tags(list) => 4 * list.len(),
            Self::Ends(_, count) => 8 * count,
            Self::Bytes(_, count) => *count,
        }) as u64
    }

    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        match self {
            Self::Doubles(list) => list
                .iter()
                .try_for_each(|x| out.write_all(&x.to_le_bytes())),
            Self::Ints(list) => list
                .iter()
                .try_for_each(|x| out.write_all(&x.to_le_bytes())),
            Self::Tags(list) => list
                .iter()
                .try_for_each(|x| out.write_all(&x.to_le_bytes())),
            Self::Ends(length, count) => (1..=*count as u64)
                .try_for_each(|i| out.write_all(&(i * *length as u64).to_le_bytes())),
            Self::Bytes(byte, count) => (0..*count).try_for_each(|_| out.write_all(&[*byte])),
        }
    }
}

/// Writes mesh and fields.
///
/// # Errors
/// Those of `out`.
pub fn write(fields: &Fields, out: &mut dyn Write) -> io::Result<()> {
    let corners = fields.dimension + 1;
    let cells = fields.cells.len() / corners;
    let kind = KINDS[fields.dimension];
    let double = |name, components, list| Array {
        name,
        kind: "Float64",
        components,
        data: Data::Doubles(list),
    };
    let on_points = fields.on_points.iter().map(|f| double(f.0, 1, &f.1));
    let mut on_cells: Vec<Array<'_>> = fields
        .on_cells
        .iter()
        .map(|f| double(f.0, 1, &f.1))
        .collect();
    on_cells.push(array("physical_group", "Int32", Data::Tags(&fields.groups)));
    let sections: [(&str, Vec<Array<'_>>); 4] = [
        ("PointData", on_points.collect()),
        ("CellData", on_cells),
        ("Points", vec![double("Points", 3, &fields.points)]),
        (
            "Cells",
            vec![
                array("connectivity", "UInt32", Data::Ints(&fields.cells)),
                array("offsets", "UInt64", Data::Ends(corners, cells)),
                array("types", "UInt8", Data::Bytes(kind, cells)),
            ],
        ),
    ];
    head(&sections, fields.points.len() / 3, cells, out)?;
    for array in sections.iter().flat_map(|section| &section.1) {
        out.write_all(&array.data.bytes().to_le_bytes())?;
        array.data.write(out)?;
    }
    out.write_all(b"\n  </AppendedData>\n</VTKFile>\n")
}

fn array<'a>(name: &'a str, kind: &'static str, data: Data<'a>) -> Array<'a> {
    Array {
        name,
        kind,
        components: 1,
        data,
    }
}

/// The XML up to the bytes.
fn head(
    sections: &[(&str, Vec<Array<'_>>)],
    points: usize,
    cells: usize,
    out: &mut dyn Write,
) -> io::Result<()> {
    writeln!(
        out,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" \
         byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n    \
         <Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"
    )?;
    let mut offset = 0;
    for (section, arrays) in sections {
        writeln!(out, "      <{section}>")?;
        for array in arrays {
            writeln!(
                out,
                "        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" \
                 format=\"appended\" offset=\"{offset}\"/>",
                array.kind, array.name, array.components
            )?;
            offset += 8 + array.data.bytes();
        }
        writeln!(out, "      </{section}>")?;
    }
    write!(
        out,
        "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_"
    )
}

//! MEDIT's `.mesh` as text: sections with a keyword, a count and rows of numbers.

use super::super::MeshFile;
use super::super::cursor::Cursor;
use super::super::soup::{Listed, Soup};
use crate::error::{Fault, Place};

/// Cells that are no simplices with straight edges, by keyword.
const REFUSED: [(&str, &str); 9] = [
    ("Quadrilaterals", "quadrilaterals"),
    ("Hexahedra", "hexahedra"),
    ("Prisms", "prisms"),
    ("Pyramids", "pyramids"),
    ("TrianglesP2", "triangles of order 2"),
    ("TrianglesP3", "triangles of order 3"),
    ("TrianglesP4", "triangles of order 4"),
    ("TetrahedraP2", "tetrahedra of order 2"),
    ("TetrahedraP3", "tetrahedra of order 3"),
];

/// The binary variant.
pub fn refuse_binary(_: &[u8]) -> Result<MeshFile, Fault> {
    let reason = "the binary variant of MEDIT's format: write it as text (.mesh)";
    Err(Fault::new(Place::Whole, reason))
}

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let mut cursor = Cursor::new(bytes);
    cursor.comment = Some(b'#');
    cursor.keyword("MeshVersionFormatted")?;
    cursor.spelled::<u8>("the format's version")?;
    let mut soup = Soup::new();
    soup.width = 0;
    while !cursor.is_at_end() {
        let place = cursor.aligned();
        let keyword = cursor.word()?;
        match keyword {
            "End" => break,
            "Dimension" => match cursor.spelled::<usize>("2 or 3")? {
                width @ (2 | 3) => soup.width = width,
                other => {
                    return Err(Fault::new(place, format!("dimension {other}, not 2 or 3")));
                }
            },
            "Vertices" => vertices(&mut cursor, &mut soup, place)?,
            "Triangles" => cells(&mut cursor, 3, &mut soup.triangles)?,
            "Tetrahedra" => cells(&mut cursor, 4, &mut soup.tetrahedra)?,
            other => pass(&mut cursor, other, place)?,
        }
    }
    soup.finish()
}

fn vertices(cursor: &mut Cursor<'_>, soup: &mut Soup, place: Place) -> Result<(), Fault> {
    if soup.width == 0 {
        return Err(Fault::new(place, "Vertices before Dimension"));
    }
    for _ in 0..cursor.count("the number of vertices")? {
        let (place, mut x) = (cursor.aligned(), [0.0; 3]);
        for x in &mut x[..soup.width] {
            *x = cursor.coordinate()?;
        }
        reference(cursor)?;
        soup.point(place, &x[..soup.width]);
    }
    Ok(())
}

fn cells(cursor: &mut Cursor<'_>, corners: usize, listed: &mut Listed) -> Result<(), Fault> {
    for _ in 0..cursor.count("the number of cells")? {
        let (place, mut points) = (cursor.aligned(), Vec::with_capacity(corners));
        for _ in 0..corners {
            let vertex: usize = cursor.spelled("a vertex")?;
            // Counted from 1.
            let index = vertex.checked_sub(1);
            points.push(index.ok_or_else(|| Fault::new(place, "vertex 0 does not exist"))?);
        }
        listed.tags.push(reference(cursor)?);
        listed.push(place, points);
    }
    Ok(())
}

/// The number that each row ends with.
fn reference(cursor: &mut Cursor<'_>) -> Result<i32, Fault> {
    cursor.spelled("a reference, a whole number,")
}

/// Passes over a section: numbers, up to the next keyword.
fn pass(cursor: &mut Cursor<'_>, keyword: &str, place: Place) -> Result<(), Fault> {
    if !keyword.starts_with(|c: char| c.is_ascii_alphabetic()) {
        let reason = format!("'{keyword}' where a keyword is expected");
        return Err(Fault::new(place, reason));
    }
    let refused = REFUSED.iter().find(|(name, _)| *name == keyword);
    if let Some((_, what)) = refused {
        if cursor.spelled::<u64>("a count")? > 0 {
            let reason = format!("{what}: triangles and tetrahedra with straight edges only");
            return Err(Fault::new(place, reason));
        }
        return Ok(());
    }
    while !cursor.is_at_end()
        && !cursor
            .peek()?
            .starts_with(|c: char| c.is_ascii_alphabetic())
    {
        cursor.word()?;
    }
    Ok(())
}

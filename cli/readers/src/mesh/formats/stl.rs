//! STL: triangles by the places of their corners, as text or as bytes. Corners at one place are one vertex.

use super::super::MeshFile;
use super::super::cursor::{Cursor, Encoding};
use super::super::soup::{Listed, Soup};
use super::no_triangle;
use crate::error::{Fault, Place};
use std::collections::HashMap;

/// A binary file has 80 bytes of anything, a count, and 50 bytes a triangle.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// Is its length that of a binary file? Some of them begin with `solid` as well.
pub fn is_binary(bytes: &[u8]) -> bool {
    let count = bytes.get(80..HEAD).and_then(|b| b.try_into().ok());
    let length = count.map(|count| HEAD + TRIANGLE * u32::from_le_bytes(count) as usize);
    length == Some(bytes.len()) && bytes.len() > HEAD
}

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let text = bytes.trim_ascii_start();
    let is_text = text.len() >= 5 && text[..5].eq_ignore_ascii_case(b"solid");
    let mut corners = Vec::new();
    match (is_binary(bytes), is_text) {
        (true, _) => binary(bytes, &mut corners)?,
        (false, true) => ascii(bytes, &mut corners)?,
        (false, false) => {
            let reason = format!(
                "{} bytes: neither text (solid) nor 84 bytes and 50 for each triangle: the file may be truncated",
                bytes.len()
            );
            return Err(Fault::new(Place::Whole, reason));
        }
    }
    welded(&corners).finish()
}

/// A triangle's corners, and where it stands.
type Corners = ([[f64; 3]; 3], Place);

fn binary(bytes: &[u8], all: &mut Vec<Corners>) -> Result<(), Fault> {
    let mut cursor = Cursor::new(bytes);
    cursor.encoding = Encoding::Binary { big_endian: false };
    cursor.skip(HEAD);
    for _ in 0..(bytes.len() - HEAD) / TRIANGLE {
        let place = cursor.place();
        // The normal comes first; it is told by the corners as well.
        cursor.skip(12);
        let mut corners = [[0.0; 3]; 3];
        for x in corners.as_flattened_mut() {
            *x = cursor.single()?;
        }
        cursor.skip(2);
        all.push((corners, place));
    }
    Ok(())
}

fn ascii(bytes: &[u8], all: &mut Vec<Corners>) -> Result<(), Fault> {
    let mut cursor = Cursor::new(bytes);
    while !cursor.is_at_end() {
        cursor.keyword("solid")?;
        cursor.finish_line();
        loop {
            let place = cursor.aligned();
            let word = cursor.word()?;
            if word.eq_ignore_ascii_case("endsolid") {
                cursor.finish_line();
                break;
            }
            if !word.eq_ignore_ascii_case("facet") {
                let reason = format!("'{word}' where facet or endsolid is expected");
                return Err(Fault::new(place, reason));
            }
            all.push((facet(&mut cursor)?, place));
        }
    }
    Ok(())
}

fn facet(cursor: &mut Cursor<'_>) -> Result<[[f64; 3]; 3], Fault> {
    cursor.keyword("normal")?;
    for _ in 0..3 {
        // Of triangles without area it may be anything.
        cursor.word()?;
    }
    cursor.keyword("outer")?;
    cursor.keyword("loop")?;
    let mut corners = [[0.0; 3]; 3];
    for corner in &mut corners {
        cursor.keyword("vertex")?;
        for x in corner {
            *x = cursor.coordinate()?;
        }
    }
    let place = cursor.aligned();
    if cursor.peek()?.eq_ignore_ascii_case("vertex") {
        return Err(Fault::new(place, no_triangle(4)));
    }
    cursor.keyword("endloop")?;
    cursor.keyword("endfacet")?;
    Ok(corners)
}

/// Corners at the same place, to the bit, are one vertex; a triangle two of whose corners are one is an edge, and left out.
fn welded(all: &[Corners]) -> Soup {
    let (mut soup, mut triangles) = (Soup::new(), Listed::default());
    let mut vertices: HashMap<[u64; 3], usize> = HashMap::with_capacity(all.len() / 2);
    let mut flat = 0;
    for (corners, place) in all {
        let points = corners.map(|x| {
            // −0 and 0 are one place.
            let key = x.map(|x| (x + 0.0).to_bits());
            *vertices.entry(key).or_insert_with(|| {
                soup.point(*place, &x);
                soup.len() - 1
            })
        });
        let [a, b, c] = points;
        match a == b || b == c || a == c {
            true => flat += 1,
            false => triangles.push(*place, points.to_vec()),
        }
    }
    let (corners, vertices) = (3 * all.len(), soup.len());
    soup.notes.push(format!(
        "{corners} corners were welded to {vertices} vertices"
    ));
    if flat > 0 {
        let reason = format!("{flat} triangles with two corners at one place were left out");
        soup.notes.push(reason);
    }
    soup.triangles = triangles;
    soup
}

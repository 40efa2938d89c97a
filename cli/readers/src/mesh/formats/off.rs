//! Geomview's OFF: counts, points, faces. Colours and normals behind them are passed over.

use super::super::MeshFile;
use super::super::soup::Soup;
use super::lines::Lines;
use super::no_triangle;
use crate::error::{Fault, Place};

/// Is it the first word of such a file, in small letters? Texture (st), colours (c) and normals (n) may come before, 4 is for
/// points in four dimensions.
pub fn begins(word: &[u8]) -> bool {
    let marks = word.strip_suffix(b"off");
    marks.is_some_and(|marks| marks.len() <= 5 && marks.iter().all(|b| b"stcn4".contains(b)))
}

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let mut lines = Lines::new(bytes);
    let mut line = lines.expect_line()?;
    let head = line.word().unwrap_or_default();
    if head.contains('4') || head.starts_with('n') {
        return Err(line.fault(format!("{head}: points with other than three coordinates")));
    }
    // The counts may stand on the first line.
    if line.left() == 0 {
        line = lines.expect_line()?;
    }
    let vertices: usize = line.spelled("the number of vertices (binary OFF cannot be read)")?;
    let faces: usize = line.spelled("the number of faces")?;
    for (what, count) in [("vertices", vertices), ("faces", faces)] {
        if count > bytes.len() {
            return Err(line.fault(format!("{count} {what}, more than the file can hold")));
        }
    }
    let mut soup = Soup::new();
    for _ in 0..vertices {
        let mut line = lines.expect_line()?;
        let x = line.point()?;
        soup.point(line.place, &x);
    }
    for _ in 0..faces {
        let mut line = lines.expect_line()?;
        let corners: usize = line.spelled("the number of a face's corners")?;
        if corners != 3 {
            return Err(line.fault(no_triangle(corners)));
        }
        let mut points = Vec::with_capacity(3);
        for _ in 0..3 {
            points.push(line.spelled("a vertex")?);
        }
        soup.triangles.push(line.place, points);
    }
    if let Some(line) = lines.next_line()? {
        return Err(line.fault("more lines than the counts at the beginning say"));
    }
    match soup.len() {
        0 => Err(Fault::new(Place::Whole, "there are no points")),
        _ => soup.finish(),
    }
}

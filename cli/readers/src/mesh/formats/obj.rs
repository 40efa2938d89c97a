//! Wavefront's OBJ: `v x y z` and `f i j k`, vertices counted from 1, or from the last one backwards.

use super::super::MeshFile;
use super::super::soup::Soup;
use super::lines::{Line, Lines};
use super::no_triangle;
use crate::error::Fault;

/// Statements that say nothing of the surface: normals, textures, names, materials, lines and points.
const PASSED: [&str; 20] = [
    "vn",
    "vt",
    "g",
    "o",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "l",
    "p",
    "usemap",
    "maplib",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "cg",
    "vc",
];
/// Those of free-form curves and surfaces.
const FREE_FORM: [&str; 14] = [
    "vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv",
    "sp", "con",
];

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let (mut soup, mut lines) = (Soup::new(), Lines::new(bytes));
    while let Some(mut line) = lines.next_line()? {
        match line.word() {
            Some("v") => {
                let (given, x) = (line.left(), line.point()?);
                // A fourth number alone is a weight; six or seven numbers are a colour behind the place.
                if given == 4 && line.spelled::<f64>("a weight")? != 1.0 {
                    return Err(line.fault("a point with a weight: export plain coordinates"));
                }
                soup.point(line.place, &x);
            }
            Some("f" | "fo") => face(&mut line, &mut soup)?,
            Some(word) if PASSED.contains(&word) => {}
            Some(word) if FREE_FORM.contains(&word) => {
                let reason = format!("{word}, a free-form curve or surface: export triangles");
                return Err(line.fault(reason));
            }
            word => {
                let short: String = word.unwrap_or("").chars().take(40).collect();
                return Err(line.fault(format!("'{short}' is no statement of an OBJ file")));
            }
        }
    }
    soup.finish()
}

fn face(line: &mut Line<'_>, soup: &mut Soup) -> Result<(), Fault> {
    if line.left() != 3 {
        return Err(line.fault(no_triangle(line.left())));
    }
    let mut points = Vec::with_capacity(3);
    for _ in 0..3 {
        let corner = line.word().expect("three words are left");
        // Place, texture and normal.
        let place = corner.split('/').next().unwrap_or(corner);
        let index: Option<i64> = place.parse().ok();
        let index = index.and_then(|index| match index {
            1.. => usize::try_from(index - 1).ok(),
            _ => (soup.len() as i64).checked_add(index)?.try_into().ok(),
        });
        match index.filter(|index| *index != soup.len()) {
            Some(index) => points.push(index),
            None => {
                let short: String = corner.chars().take(40).collect();
                return Err(line.fault(format!("'{short}' names no vertex given before")));
            }
        }
    }
    soup.triangles.push(line.place, points);
    Ok(())
}

//! One surface, the boundary of a tetrahedron, in every format; and what is no surface, at its line.

use super::super::{MeshFile, mesh_from};
use crate::error::{InputError, Place};
use std::fmt::Write;
use std::path::Path;

const POINTS: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.5, 0.0],
    [0.0, 0.0, -0.25],
];
const CELLS: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

fn read(name: &str, bytes: &[u8]) -> Result<MeshFile, InputError> {
    mesh_from(Path::new(name), bytes)
}

/// Lines of a table of numbers.
fn rows<T: ToString, const N: usize>(table: &[[T; N]], before: &str) -> String {
    let row = |row: &[T; N]| row.iter().map(T::to_string).collect::<Vec<_>>().join(" ");
    table
        .iter()
        .map(|r| format!("{before}{}\n", row(r)))
        .collect()
}

fn from_one() -> Vec<[usize; 3]> {
    CELLS.iter().map(|c| c.map(|v| v + 1)).collect()
}

fn obj() -> String {
    format!(
        "# a comment\nmtllib none.mtl\no tetra\n{}vn 0 0 1\n{}",
        rows(&POINTS, "v "),
        rows(&from_one(), "f ")
    )
}

fn off() -> String {
    format!(
        "OFF # surface\n4 4 0\n\n{}{}",
        rows(&POINTS, ""),
        rows(&CELLS, "3 ")
    )
}

fn medit() -> String {
    let numbered =
        |list: &[String]| -> String { list.iter().map(|l| format!("{l} 7\n")).collect() };
    let lines = |text: String| text.lines().map(str::to_owned).collect::<Vec<_>>();
    format!(
        "MeshVersionFormatted 2\nDimension 3\n# points\nVertices 4\n{}Corners\n1\n2\nTriangles 4\n{}Quadrilaterals 0\nEnd\n",
        numbered(&lines(rows(&POINTS, ""))),
        numbered(&lines(rows(&from_one(), "")))
    )
}

fn stl() -> String {
    let mut text = String::from("solid tetra hedron\n");
    for cell in CELLS {
        text += "facet normal 0 0 0\n outer loop\n";
        text += &rows(&cell.map(|v| POINTS[v]), "  vertex ");
        text += " endloop\nendfacet\n";
    }
    text + "endsolid tetra hedron\n"
}

fn stl_bytes() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    // Some programs begin binary files with this word as well.
    bytes[..5].copy_from_slice(b"solid");
    bytes.extend(4u32.to_le_bytes());
    for cell in CELLS {
        bytes.extend([0u8; 12]);
        for x in cell.map(|v| POINTS[v]).as_flattened() {
            bytes.extend((*x as f32).to_le_bytes());
        }
        bytes.extend([0u8; 2]);
    }
    bytes
}

const PLY: &str = "comment none\nelement vertex 4\nproperty double x\nproperty uchar red\nproperty double y\n\
property float z\nelement face 4\nproperty list uchar int vertex_indices\nproperty short flags\nend_header\n";

fn ply() -> String {
    let mut text = format!("ply\nformat ascii 1.0\n{PLY}");
    for [x, y, z] in POINTS {
        let _ = writeln!(text, "{x} 255 {y} {z}");
    }
    for [a, b, c] in CELLS {
        let _ = writeln!(text, "3 {a} {b} {c} -1");
    }
    text
}

fn ply_bytes(big: bool) -> Vec<u8> {
    let order = if big { "big" } else { "little" };
    let mut bytes = format!("ply\r\nformat binary_{order}_endian 1.0\r\n{PLY}").into_bytes();
    let mut put = |mut part: Vec<u8>| {
        // Written most significant first here.
        if !big {
            part.reverse();
        }
        bytes.extend(part);
    };
    for [x, y, z] in POINTS {
        put(x.to_be_bytes().to_vec());
        put(vec![255]);
        put(y.to_be_bytes().to_vec());
        put((z as f32).to_be_bytes().to_vec());
    }
    for cell in CELLS {
        put(vec![3]);
        for v in cell {
            put((v as i32).to_be_bytes().to_vec());
        }
        put((-1i16).to_be_bytes().to_vec());
    }
    bytes
}

/// The edges' squared lengths, which do not depend on how a format numbers its vertices.
fn lengths(file: &MeshFile) -> Vec<f64> {
    let mut all: Vec<f64> = Vec::new();
    for cell in &file.cells {
        for [i, j] in [[0, 1], [0, 2], [1, 2]] {
            let point = |v: usize| &file.coordinates[3 * cell[v]..][..3];
            let pairs = point(i).iter().zip(point(j));
            all.push(pairs.map(|(a, b)| (a - b) * (a - b)).sum());
        }
    }
    all
}

#[test]
fn every_format_has_the_same_surface() {
    let by_hand = read("m.obj", obj().as_bytes()).expect("OBJ");
    assert_eq!(by_hand.coordinates, POINTS.concat());
    assert_eq!(by_hand.cells, CELLS);
    let backwards = obj().replace("f 1 3 2", "f -4/1/1 -2//2\\\n-3/7");
    let all: [(&str, Vec<u8>); 10] = [
        ("m.obj", backwards.into_bytes()),
        ("unnamed", obj().into_bytes()),
        ("m.off", off().into_bytes()),
        (
            "m.off",
            off().replace("OFF # surface\n", "COFF ").into_bytes(),
        ),
        ("m.ply", ply().into_bytes()),
        ("m.ply", ply_bytes(true)),
        ("m.ply", ply_bytes(false)),
        ("m.stl", stl().into_bytes()),
        ("unnamed", stl_bytes()),
        ("m.mesh", medit().into_bytes()),
    ];
    for (name, bytes) in all {
        let file = read(name, &bytes).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(
            (file.dimension, file.vertices, file.width),
            (2, 4, 3),
            "{name}"
        );
        assert_eq!(lengths(&file), lengths(&by_hand), "{name}");
        let surface = file
            .immersion::<2>()
            .unwrap_or_else(|error| panic!("{error}"));
        let mesh = surface.mesh();
        assert!(mesh.is_closed() && mesh.euler_characteristic() == 2);
        let welded = file.notes == ["12 corners were welded to 4 vertices"];
        assert_eq!(
            welded,
            bytes.starts_with(b"solid"),
            "{name}: {:?}",
            file.notes
        );
    }
    let groups = read("m.mesh", medit().as_bytes()).expect("MEDIT").groups;
    assert_eq!(
        (groups.len(), groups[0].tag, groups[0].cells.len()),
        (1, 7, 4)
    );
}

#[test]
fn points_of_no_triangle_are_left_out_and_counted() {
    let text = obj()
        .replace("v 1 0 0", "v 9 9 9\nv 1 0 0")
        .replace("vn 0", "v 8 8 8\nvn 0");
    let shifted = text
        .replace("f 1 3 2", "f 1 4 3")
        .replace("f 1 2 4", "f 1 3 5")
        .replace("f 2 3 4", "f 3 4 5")
        .replace("f 3 1 4", "f 4 1 5");
    let file = read("m.obj", shifted.as_bytes()).expect("OBJ");
    assert_eq!(
        file.notes,
        ["2 of 6 nodes belong to no cell and are left out; vertices are counted without them"]
    );
    assert_eq!(file.coordinates, POINTS.concat());
    assert_eq!(file.cells, CELLS);
}

/// A change to a file, where it is refused, and why.
#[test]
fn what_is_no_surface_is_refused_at_its_line() {
    for (name, text, from, to, line, expected) in [
        (
            "m.obj",
            obj(),
            "f 1 3 2",
            "f 1 3 2 4",
            9,
            "a quadrilateral: only triangles",
        ),
        (
            "m.obj",
            obj(),
            "f 1 3 2",
            "f 1 3 2 4 1 2 3",
            9,
            "a polygon with 7 corners",
        ),
        (
            "m.obj",
            obj(),
            "f 1 3 2",
            "f 1 3",
            9,
            "a face with 2 corners",
        ),
        ("m.obj", obj(), "f 1 3 2", "f 1 3 9", 9, "point 8"),
        (
            "m.obj",
            obj(),
            "f 1 3 2",
            "f 1 3 0",
            9,
            "'0' names no vertex",
        ),
        (
            "m.obj",
            obj(),
            "f 1 3 2",
            "f 1 3 -5",
            9,
            "'-5' names no vertex",
        ),
        ("m.obj", obj(), "f 1 3 2", "f 1 3 3", 9, "repeated"),
        ("m.obj", obj(), "v 1 0 0", "v 1 0", 5, "the line ends"),
        ("m.obj", obj(), "v 1 0 0", "v 1 0 nan", 5, "NaN"),
        ("m.obj", obj(), "v 1 0 0", "v 1 0 0 0.5", 5, "weight"),
        ("m.obj", obj(), "vn 0", "surf 0", 8, "free-form"),
        (
            "m.obj",
            obj(),
            "vn 0",
            "vector 0",
            8,
            "'vector' is no statement",
        ),
        (
            "m.obj",
            obj(),
            "v 1 0 0",
            "v 0 3 0",
            9,
            "cell 0 is degenerate",
        ),
        (
            "m.obj",
            obj(),
            "f 1 2 4",
            "f 1 3 4",
            12,
            "3 cells share this face",
        ),
        ("m.off", off(), "3 0 2 1", "4 0 2 1 3", 8, "a quadrilateral"),
        ("m.off", off(), "3 0 2 1", "3 0 2 4", 8, "point 4"),
        ("m.off", off(), "4 4 0", "4 5 0", 11, "ends too early"),
        ("m.off", off(), "4 4 0", "4 3 0", 11, "more lines"),
        (
            "m.off",
            off(),
            "4 4 0",
            "99999 4 0",
            2,
            "more than the file",
        ),
        ("m.off", off(), "OFF", "4OFF", 1, "three coordinates"),
        (
            "m.ply",
            ply(),
            "3 0 2 1",
            "4 0 2 1 3",
            17,
            "a quadrilateral",
        ),
        ("m.ply", ply(), "3 0 2 1", "3 0 2 1.5", 17, "1.5 where"),
        ("m.ply", ply(), "1 255 0 0", "inf 255 0 0", 14, "inf"),
        (
            "m.ply",
            ply(),
            "property double y",
            "property double w",
            4,
            "x, y, z",
        ),
        (
            "m.ply",
            ply(),
            "property double y",
            "property complex y",
            7,
            "'complex'",
        ),
        (
            "m.ply",
            ply(),
            "element face 4",
            "element face 3",
            20,
            "more than the header",
        ),
        (
            "m.ply",
            ply(),
            "element face 4",
            "element face 9999999",
            9,
            "more than the file",
        ),
        ("m.stl", stl(), "vertex 1 0 0", "vertex 1 0 x", 6, "'x'"),
        (
            "m.stl",
            stl(),
            " endloop",
            " vertex 0 0 0\n endloop",
            7,
            "a quadrilateral",
        ),
        ("m.stl", stl(), "endfacet", "endfact", 8, "'endfact'"),
        (
            "m.mesh",
            medit(),
            "Quadrilaterals 0",
            "Quadrilaterals 1\n1 2 3 4 0",
            17,
            "quadrilaterals",
        ),
        ("m.mesh", medit(), "1 3 2 7", "1 3 5 7", 13, "point 4"),
        ("m.mesh", medit(), "1 3 2 7", "0 3 2 7", 13, "vertex 0"),
        (
            "m.mesh",
            medit(),
            "Dimension 3",
            "Dimension 4",
            2,
            "dimension 4",
        ),
    ] {
        let changed = text.replacen(from, to, 1);
        assert_ne!(changed, text, "{from}");
        let refused = read(name, changed.as_bytes()).and_then(|file| file.immersion::<2>());
        let error = refused.expect_err(to);
        assert!(error.reason.contains(expected), "{to}: {error}");
        assert_eq!(error.place, Place::Line(line), "{to}: {error}");
    }
}

#[test]
fn no_truncation_is_taken_for_a_surface_and_none_panics() {
    let all = [
        ("m.off", off().into_bytes()),
        ("m.ply", ply().into_bytes()),
        ("m.ply", ply_bytes(true)),
        ("m.ply", ply_bytes(false)),
        ("m.stl", stl().into_bytes()),
        ("m.stl", stl_bytes()),
    ];
    for (name, bytes) in all {
        // The last word but the solid's name, or the last number but two of its digits.
        let whole = bytes.len() - if name == "m.stl" { 22 } else { 3 };
        for end in 0..whole {
            assert!(read(name, &bytes[..end]).is_err(), "{name} cut at {end}");
        }
    }
    // Formats without counts may end anywhere.
    for (name, bytes) in [("m.obj", obj()), ("m.mesh", medit())] {
        for end in 0..bytes.len() {
            let _ = read(name, &bytes.as_bytes()[..end]);
        }
    }
}

#[test]
fn triangles_without_area_are_no_part_of_a_welded_surface() {
    let flat = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 0 -0\nendloop\nendfacet\n";
    let text = stl().replace(
        "facet normal 0 0 0\n outer",
        &format!("{flat}facet normal 0 0 0\n outer"),
    );
    let file = read("m.stl", text.as_bytes()).expect("STL");
    assert_eq!(file.cells.len(), 4);
    assert_eq!(
        file.notes,
        [
            "24 corners were welded to 4 vertices",
            "4 triangles with two corners at one place were left out"
        ]
    );
}

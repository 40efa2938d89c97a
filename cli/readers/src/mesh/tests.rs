use super::*;

const NODES: [[f64; 3]; 5] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.5, 0.5, 0.0],
];
const CELLS: [[u64; 3]; 4] = [[1, 2, 5], [2, 3, 5], [3, 4, 5], [4, 1, 5]];

/// The square of four triangles, in version 2.2 or 4.1, as text.
fn text(old: bool) -> String {
    let nodes: Vec<String> = NODES
        .iter()
        .map(|[x, y, z]| format!("{x} {y} {z}"))
        .collect();
    if old {
        let nodes: String = nodes
            .iter()
            .enumerate()
            .map(|(i, x)| format!("{} {x}\n", i + 1))
            .collect();
        let cells: String = (CELLS.iter().enumerate())
            .map(|(i, [a, b, c])| format!("{} 2 2 7 1 {a} {b} {c}\n", i + 2))
            .collect();
        return format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"all\"\n$EndPhysicalNames\n$Nodes\n5\n{nodes}$EndNodes\n$Elements\n5\n1 15 2 0 1 1\n{cells}$EndElements\n"
        );
    }
    let cells: String = (CELLS.iter().enumerate())
        .map(|(i, [a, b, c])| format!("{} {a} {b} {c}\n", i + 2))
        .collect();
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 5 1 5\n2 1 0 5\n1\n2\n3\n4\n5\n{}\n$EndNodes\n$Elements\n2 5 1 5\n0 1 15 1\n1 1\n2 1 2 4\n{cells}$EndElements\n",
        nodes.join("\n")
    )
}

/// The same as bytes.
fn binary(old: bool, big_endian: bool) -> Vec<u8> {
    let int = |x: i32| {
        if big_endian {
            x.to_be_bytes()
        } else {
            x.to_le_bytes()
        }
    };
    let size = |x: u64| {
        if big_endian {
            x.to_be_bytes()
        } else {
            x.to_le_bytes()
        }
    };
    let mut out = format!("$MeshFormat\n{} 1 8\n", if old { "2.2" } else { "4.1" }).into_bytes();
    out.extend(int(1));
    out.extend(b"\n$EndMeshFormat\n$Nodes\n");
    if old {
        out.extend(b"5\n");
    } else {
        out.extend([1, 5, 1, 5].map(size).concat());
        out.extend([2, 1, 0].map(int).concat());
        out.extend([5, 1, 2, 3, 4, 5].map(size).concat());
    }
    for (i, node) in NODES.iter().enumerate() {
        if old {
            out.extend(int(i as i32 + 1));
        }
        out.extend(node.map(|x| size(x.to_bits())).concat());
    }
    out.extend(b"\n$EndNodes\n$Elements\n");
    if old {
        out.extend(b"4\n");
        out.extend([2, 4, 2].map(int).concat());
    } else {
        out.extend([1, 4, 1, 4].map(size).concat());
        out.extend([2, 1, 2].map(int).concat());
        out.extend(size(4));
    }
    for (i, cell) in CELLS.iter().enumerate() {
        if old {
            out.extend([i as i32 + 1, 7, 1].map(int).concat());
            out.extend(cell.map(|v| int(v as i32)).concat());
        } else {
            out.extend(size(i as u64 + 1));
            out.extend(cell.map(size).concat());
        }
    }
    out.extend(b"\n$EndElements\n");
    out
}

#[test]
fn both_versions_are_read_as_text_and_as_bytes_of_either_order() {
    let mut all = vec![text(true).into_bytes(), text(false).into_bytes()];
    for old in [true, false] {
        all.extend([binary(old, true), binary(old, false)]);
    }
    for bytes in all {
        let read = gmsh::parse(&bytes).unwrap_or_else(|fault| panic!("{fault:?}"));
        assert_eq!((read.dimension, read.vertices), (2, 5));
        assert_eq!(read.coordinates, NODES.concat());
        assert_eq!(read.cells[3], [3, 0, 4]);
        read.mesh::<2>().expect("a mesh");
    }
}

/// Two tetrahedra with a volume in two groups and a surface in one, in version 4.1, as text or bytes.
fn tetrahedra(binary: bool) -> Vec<u8> {
    let mut out = format!("$MeshFormat\n4.1 {} 8\n", if binary { "1" } else { "0" }).into_bytes();
    let put = |int: &[i32], size: &[u64], double: &[f64]| {
        let mut part = Vec::new();
        if binary {
            part.extend(int.iter().flat_map(|x| x.to_le_bytes()));
            part.extend(size.iter().flat_map(|x| x.to_le_bytes()));
            part.extend(double.iter().flat_map(|x| x.to_le_bytes()));
        } else {
            part.extend(int.iter().flat_map(|x| format!("{x} ").into_bytes()));
            part.extend(size.iter().flat_map(|x| format!("{x} ").into_bytes()));
            part.extend(double.iter().flat_map(|x| format!("{x} ").into_bytes()));
        }
        part
    };
    if binary {
        out.extend(put(&[1], &[], &[]));
    }
    out.extend(
        b"\n$EndMeshFormat\n$PhysicalNames\n1\n3 11 \"the body\"\n$EndPhysicalNames\n$Entities\n",
    );
    // No point, no curve, one surface, one volume.
    out.extend(put(&[], &[0, 0, 1, 1], &[]));
    out.extend(put(&[4], &[], &[0.0; 6]));
    out.extend(put(&[], &[1], &[]));
    out.extend(put(&[21], &[0], &[]));
    out.extend(put(&[5], &[], &[0.0; 6]));
    out.extend(put(&[], &[2], &[]));
    out.extend(put(&[11, 12], &[1], &[]));
    out.extend(put(&[-4], &[], &[]));
    out.extend(b"\n$EndEntities\n$Nodes\n");
    out.extend(put(&[], &[1, 5, 1, 1005], &[]));
    out.extend(put(&[3, 5, 0], &[5, 1, 2, 3, 4, 1005], &[]));
    for x in [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]] {
        out.extend(put(&[], &[], &x.map(f64::from)));
    }
    out.extend(b"\n$EndNodes\n$Elements\n");
    out.extend(put(&[], &[2, 3, 1, 3], &[]));
    out.extend(put(&[2, 4, 2], &[1, 1, 1, 2, 3], &[]));
    out.extend(put(&[3, 5, 4], &[2, 2, 1, 2, 3, 4, 3, 2, 3, 4, 1005], &[]));
    out.extend(b"\n$EndElements\n");
    out
}

#[test]
fn tetrahedra_of_version_4_have_the_groups_of_their_entities() {
    for binary in [false, true] {
        let bytes = tetrahedra(binary);
        let read = gmsh::parse(&bytes).unwrap_or_else(|fault| panic!("{fault:?}"));
        assert_eq!((read.dimension, read.vertices), (3, 5));
        assert_eq!(read.cells, [[0, 1, 2, 3], [1, 2, 3, 4]]);
        read.mesh::<3>().expect("a mesh");
        let groups: Vec<_> = (read.groups.iter())
            .map(|g| {
                (
                    g.dimension,
                    g.tag,
                    g.name.as_deref(),
                    g.cells.len(),
                    g.simplices.len(),
                )
            })
            .collect();
        let body = (3, 11, Some("the body"), 2, 0);
        assert_eq!(groups, [(2, 21, None, 0, 1), body, (3, 12, None, 2, 0)]);
        assert_eq!(read.cell_groups(), [11, 11]);
        for end in 0..bytes.len() - 2 {
            assert!(gmsh::parse(&bytes[..end]).is_err(), "cut at {end}");
        }
    }
}

#[test]
fn tags_may_be_any_numbers() {
    let far = text(true).replace("\n5 0.5", "\n2000000000 0.5");
    let far = far.replace(" 5\n", " 2000000000\n");
    let read = gmsh::parse(far.as_bytes()).unwrap_or_else(|fault| panic!("{fault:?}"));
    assert_eq!(read.cells[3], [3, 0, 4]);
}

#[test]
fn no_truncation_is_taken_for_a_mesh_and_none_panics() {
    for bytes in [
        text(true).into_bytes(),
        text(false).into_bytes(),
        binary(true, false),
        binary(false, false),
    ] {
        for end in 0..bytes.len() - 2 {
            assert!(gmsh::parse(&bytes[..end]).is_err(), "cut at {end}");
        }
    }
}

/// A change to the square of text, where it is refused, and why.
#[test]
fn what_is_no_mesh_is_refused_at_its_line() {
    for (from, to, line, expected) in [
        ("2 1 0 0\n", "2 nan 0 0\n", 11, "NaN"),
        ("2 1 0 0\n", "2 1 zero 0\n", 11, "'zero'"),
        ("2 1 0 0\n", "1 1 0 0\n", 11, "given twice"),
        ("5 0.5 0.5 0\n", "5 0 0 0\n", 14, "duplicated"),
        ("5 0.5 0.5 0\n", "5 0.5 0.5 1\n", 14, "z = 1"),
        ("5 0.5 0.5 0\n", "5 0.5 0 0\n", 19, "degenerate"),
        ("5 0.5 0.5 0\n", "5 0.5 -1 0\n", 22, "same side"),
        (
            "5 2 2 7 1 4 1 5\n",
            "5 2 2 7 1 1 2 5\n",
            22,
            "there already",
        ),
        ("2 2 2 7 1 1 2 5", "2 3 2 7 1 1 2 5 4", 19, "quadrangle"),
        (
            "2 2 2 7 1 1 2 5",
            "2 9 2 7 1 1 2 5 4 3 1",
            20,
            "order 1 among others of order 2",
        ),
        ("2 2 2 7 1 1 2 5", "2 99 2 7 1 1 2 5", 19, "unknown type 99"),
        (
            "2 2 2 7 1 1 2 5",
            "2 2 2 7 1 1 2 6",
            19,
            "node 6 does not exist",
        ),
        ("2 2 2 7 1 1 2 5", "2 2 2 7 1 1 2 2", 19, "repeated"),
    ] {
        let changed = text(true).replace(from, to);
        assert_ne!(changed, text(true), "{from}");
        let (place, reason) = match gmsh::parse(changed.as_bytes()) {
            Err(fault) => (fault.place, fault.reason),
            Ok(parsed) => {
                let error = parsed.mesh::<2>().expect_err(to);
                (error.place, error.reason)
            }
        };
        assert!(reason.contains(expected), "{to}: {reason}");
        assert_eq!(place, Place::Line(line), "{to}: {reason}");
    }
}

#[test]
fn a_hanging_node_and_an_orphan_are_named() {
    let hanging = r#"{"dimension": 2, "vertices": [[0,0],[1,0],[0,1],[1,1],[0.5,0.5]],
        "cells": [[0,1,2],[1,3,4],[3,2,4]]}"#;
    let error = json::parse(hanging.as_bytes()).expect("JSON").mesh::<2>();
    assert!(
        error
            .expect_err("hanging")
            .reason
            .contains("vertex 4 hangs")
    );
    let orphan = r#"{"dimension": 2, "vertices": [[0,0],[1,0],[0,1],[1,1]], "cells": [[0,1,2]]}"#;
    let error = json::parse(orphan.as_bytes()).expect("JSON").mesh::<2>();
    assert!(
        error
            .expect_err("orphan")
            .reason
            .contains("vertex 3: belongs to no cell")
    );
}

#[test]
fn no_count_is_trusted() {
    let huge = "18446744073709551615";
    let header = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    let nodes = format!("{header}$Nodes\n{huge} {huge} 1 {huge}\n2 1 0 {huge}\n1\n");
    assert!(gmsh::parse(nodes.as_bytes()).is_err());
    let cells = r#"{"dimension": 2, "cells": [[0, 1, 1000000000000]]}"#;
    let fault = json::parse(cells.as_bytes()).expect_err("refused");
    assert!(fault.reason.contains("vertex 1000000000000"));
}

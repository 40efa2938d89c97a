//! Bad input of `regge curvature`: one line, exit code 2, nothing written.

use crate::common::files::{SQUARE, curvature, folder, regge, write};
use std::fs;
use std::path::Path;

#[test]
fn bad_input_is_one_line_and_code_2() {
    let folder = folder("bad");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", "dimension = 2\nconformal = \"1\"\n");
    let metrics = [
        (
            "dimension = 2\ngraph = \"sine(x)\"",
            "line 2: graph: column 1: unknown name 'sine'",
        ),
        (
            "dimension = 2\nconformal = \"1/(x - x)\"",
            "not finite, or divides by zero, at x = ",
        ),
        ("dimension = 2\nconformal = \"1/sqrt(y)\"", "at x = ["),
        (
            "dimension = 2\nconformal = \"x - 0.5\"",
            "not positive definite (pivot",
        ),
        ("dimension = 3\nconformal = \"1\"", "dimension 3"),
        ("dimension = 2", "exactly one"),
    ];
    for (text, expected) in metrics {
        write(&folder, "bad.toml", text);
        refused(&folder, "--mesh m.json --metric bad.toml", expected);
    }
    let meshes = [
        (r#"{"dimension": 2, "cells": [[0,1,2]"#, "line 1"),
        (
            r#"{"dimension": 2, "vertices": [[0,0],[1,0],[0,1],[1,1]], "cells": [[0,1,2]]}"#,
            "belongs to no cell",
        ),
        (
            r#"{"dimension": 2, "vertices": [[0,0],[1,0],[0,1],[0,0]], "cells": [[0,1,2],[1,2,3]]}"#,
            "duplicated",
        ),
        (
            r#"{"dimension": 2, "vertices": [[0,0],[1,0],[2,0]], "cells": [[0,1,2]]}"#,
            "degenerate",
        ),
        (
            r#"{"dimension": 2, "vertices": [[0,0],[1,0],[0,1],[1,1],[0.5,0.5]], "cells": [[0,1,2],[1,3,4],[3,2,4]]}"#,
            "vertex 4 hangs",
        ),
        (
            r#"{"dimension": 2, "vertices": [[0,0],[1,0],[0,1],[1,1],[2,2]], "cells": [[0,1,2],[1,2,3],[1,2,4]]}"#,
            "not a manifold",
        ),
        (
            r#"{"dimension": 2, "cells": [[0,1,2],[0,1,3],[0,2,3],[1,2,3]]}"#,
            "no coordinates",
        ),
        (
            r#"{"dimension": 2, "vertices": [[0,0],[1,0],[0,1e999]], "cells": [[0,1,2]]}"#,
            "out of range",
        ),
        ("nothing", "is no mesh"),
    ];
    for (text, expected) in meshes {
        write(&folder, "bad.json", text);
        refused(&folder, "--mesh bad.json --metric g.toml", expected);
    }
    refused(&folder, "--mesh none.msh --metric g.toml", "none.msh");
    write(
        &folder,
        "abstract.json",
        r#"{"dimension": 2, "cells": [[0, 1, 2]]}"#,
    );
    refused(&folder, "--mesh abstract.json", "give the edge lengths");
    refused(
        &folder,
        "--mesh m.json --metric g.toml --json missing/x.json",
        "no such folder",
    );
    refused(
        &folder,
        "--mesh m.json --metric g.toml --degree 99",
        "too high",
    );
}

/// Two tetrahedra of Gmsh's with their faces, and what may go wrong.
#[test]
fn bad_gmsh_files_are_one_line_with_the_place() {
    let folder = folder("gmsh");
    write(&folder, "g.toml", "dimension = 3\nconformal = \"1\"\n");
    let good = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n\
        6 5 5 5\n$EndNodes\n$Elements\n4\n1 2 2 9 1 1 2 3\n2 4 2 1 1 1 2 3 4\n3 4 2 1 1 2 3 4 5\n\
        4 4 2 1 1 3 4 5 6\n$EndElements\n";
    write(&folder, "m.msh", good);
    curvature(&folder, "--mesh m.msh --metric g.toml");
    for (from, to, expected) in [
        (
            "2 9 1 1 2 3\n",
            "2 9 1 1 2 6\n",
            "line 15: a triangle that is no face of a tetrahedron",
        ),
        (
            "1 2 2 9 1 1 2 3\n",
            "1 3 2 9 1 1 2 3 4\n",
            "line 15: a quadrangle",
        ),
        (
            "1 2 2 9 1 1 2 3\n",
            "1 6 2 9 1 1 2 3 4 5 6\n",
            "line 15: a prism",
        ),
        (
            "6 5 5 5\n",
            "6 1 1 1\n",
            "line 11: vertex 5 is where vertex 4 is",
        ),
        ("6 5 5 5\n", "6 nan 5 5\n", "line 11: a coordinate is NaN"),
        ("6 5 5 5\n", "6 1 0.5 0.5\n", "line 18"),
        (
            "4 4 2 1 1 3 4 5 6\n",
            "4 4 2 1 1 2 3 4 6\n",
            "share this face",
        ),
        (
            "4 4 2 1 1 3 4 5 6\n",
            "4 4 2 1 1 3 4 5 9\n",
            "line 18: node 9 does not exist",
        ),
        ("4 4 2 1 1 3 4 5 6\n", "4 4 2 1 1 3 4 5 5\n", "line 18"),
        ("4 4 2 1 1 3 4 5 6\n$EndElements\n", "", "truncated"),
        ("6\n1 0 0 0", "7\n1 0 0 0", "line 12: '$EndNodes'"),
        ("2.2 0 8", "4.0 0 8", "version 4.0"),
    ] {
        let changed = good.replace(from, to);
        assert_ne!(changed, good, "{from}");
        write(&folder, "bad.msh", &changed);
        refused(&folder, "--mesh bad.msh --metric g.toml", expected);
    }
}

#[test]
fn what_cannot_be_drawn_or_written_is_refused_first() {
    let folder = folder("asked");
    write(
        &folder,
        "m.json",
        r#"{"dimension": 2, "cells": [[0,1,2],[0,1,3],[0,2,3],[1,2,3]]}"#,
    );
    write(
        &folder,
        "l.csv",
        "0,1,1\n0,2,1\n0,3,1\n1,2,1\n1,3,1\n2,3,1\n",
    );
    let mesh = "--mesh m.json --lengths l.csv";
    refused(&folder, &format!("{mesh} --vtu f.vtu"), "no coordinates");
    refused(&folder, &format!("{mesh} --plot f.pdf"), ".svg or .png");
    refused(&folder, &format!("{mesh} --json f --csv f"), "--json too");
    refused(&folder, &format!("{mesh} --boundary all"), "gauss-bonnet");
    refused(&folder, &format!("{mesh} --json ."), "is a folder");
    let found = curvature(&folder, &format!("{mesh} --boundary gauss-bonnet"));
    let residual = found["gauss_bonnet_residual"].as_f64();
    assert!(residual.expect("a number").abs() < 1e-12);
}

#[test]
fn bad_lengths_are_one_line_and_code_2() {
    let folder = folder("lengths");
    write(
        &folder,
        "m.json",
        r#"{"dimension": 2, "cells": [[0,1,2],[0,1,3],[0,2,3],[1,2,3]]}"#,
    );
    let good = "i,j,length\n0,1,1\n0,2,1\n0,3,1\n1,2,1\n1,3,1\n2,3,1\n";
    for (from, to, expected) in [
        ("0,3,1\n", "", "edge 0-3 has no length; 1 of 6"),
        (
            "0,3,1\n",
            "0,3,1\n3,0,2\n",
            "line 5: edge 3-0 has length 2, but 1 in line 4",
        ),
        ("0,3,1\n", "0,9,1\n", "vertex 9 does not exist"),
        ("0,3,1\n", "0,0,1\n", "no edge"),
        ("0,3,1\n", "0,3,-1\n", "positive"),
        ("0,3,1\n", "0,3,nan\n", "positive"),
        ("0,3,1\n", "0,3,1e-200\n", "the square of the length 1e-200"),
        ("0,3,1\n", "0,3,1e200\n", "another unit"),
        ("0,3,1\n", "0,3\n", "2 fields"),
        ("0,3,1\n", "0,3,one\n", "no length"),
        (
            "0,3,1\n",
            "0,3,5\n",
            "cell 1 [0, 1, 3] (Cayley-Menger determinant",
        ),
    ] {
        write(&folder, "l.csv", &good.replace(from, to));
        refused(&folder, "--mesh m.json --lengths l.csv", expected);
    }
    write(&folder, "l.csv", good);
    refused(
        &folder,
        "--mesh m.json --lengths l.csv --degree 1",
        "--degree",
    );
    refused(
        &folder,
        "--mesh m.json --lengths l.csv --norm hm2",
        "--norm",
    );
    let found = curvature(&folder, "--mesh m.json --lengths l.csv");
    let total = found["total_curvature"].as_f64().expect("a number");
    assert!((total - 8.0 * std::f64::consts::PI).abs() < 1e-12);
}

fn refused(folder: &Path, arguments: &str, expected: &str) {
    let before = fs::read_dir(folder).expect("a folder").count();
    let output = regge(folder, arguments);
    let said = String::from_utf8(output.stderr).expect("text");
    assert_eq!(output.status.code(), Some(2), "{arguments}: {said}");
    assert_eq!(said.lines().count(), 1, "{arguments}: {said}");
    assert!(
        said.starts_with("regge: ") && said.contains(expected),
        "{arguments}: {said}"
    );
    assert!(output.stdout.is_empty());
    assert_eq!(
        fs::read_dir(folder).expect("a folder").count(),
        before,
        "nothing is written"
    );
}

//! Meshes as Gmsh and editors write them.

use crate::common::files::{curvature, folder, regge, write};
use serde_json::Value;
use std::fs;
use std::path::Path;

const METRIC: &str = "dimension = 2\nconformal = \"1 + x^2/4\"\n";

/// Four triangles; a node of no element, one of a point only (a circle's centre), a name with quotes in it, the first
/// triangle in two groups, hence written twice.
const OLD: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"the \"inner\" part\"\n2 8 \"all\"\n\
$EndPhysicalNames\n$Nodes\n7\n1 9 9 0\n2 0 0 0\n3 1 0 0\n4 1 1 0\n5 7 7 0\n6 0 1 0\n7 0.5 0.5 0\n$EndNodes\n$Elements\n7\n\
1 15 2 3 1 5\n2 2 2 7 1 2 3 7\n3 2 2 8 1 2 3 7\n4 2 2 8 1 3 4 7\n5 2 2 8 1 4 6 7\n6 2 2 8 1 6 2 7\n\
7 1 2 5 1 2 3\n$EndElements\n";

/// The same in version 4.1, without groups.
const NEW: &str = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 7 1 7\n2 1 0 7\n1\n2\n3\n4\n5\n6\n7\n9 9 0\n0 0 0\n1 0 0\n\
1 1 0\n7 7 0\n0 1 0\n0.5 0.5 0\n$EndNodes\n$Elements\n2 5 1 5\n0 1 15 1\n1 5\n2 1 2 4\n2 2 3 7\n3 3 4 7\n4 4 6 7\n\
5 6 2 7\n$EndElements\n";

fn json(folder: &Path, mesh: &str, content: &str) -> Value {
    write(folder, mesh, content);
    curvature(folder, &format!("--mesh {mesh} --metric g.toml"))
}

#[test]
fn nodes_of_no_cell_are_left_out_and_counted() {
    let folder = folder("centres");
    write(&folder, "g.toml", METRIC);
    let total = |found: &Value| found["total_curvature"].as_f64().expect("a number");
    let old = json(&folder, "old.msh", OLD);
    let new = json(&folder, "new.msh", NEW);
    assert_eq!(total(&old), total(&new));
    for found in [&old, &new] {
        assert_eq!(found["cell_count"], 4);
        assert_eq!(found["vertices"][0]["vertex"], 4, "counted without them");
        let note = found["notes"][0].as_str().expect("a note");
        assert!(note.starts_with("2 of 7 nodes belong to no cell"), "{note}");
    }
    let said = regge(&folder, "--mesh old.msh --metric g.toml").stderr;
    let said = String::from_utf8_lossy(&said);
    assert!(said.starts_with("note: 2 of 7 nodes"), "{said}");
}

#[test]
fn a_cell_of_two_groups_is_one_cell() {
    let folder = folder("groups-of-two");
    write(&folder, "g.toml", METRIC);
    let found = json(&folder, "m.msh", OLD);
    let groups = found["physical_groups"].as_array().expect("groups");
    // The group of the point is gone with it.
    assert_eq!(groups.len(), 3, "{groups:?}");
    assert_eq!(groups[0]["simplices"], serde_json::json!([[0, 1]]));
    assert_eq!(groups[1]["name"], "the \"inner\" part");
    assert_eq!(groups[1]["cells"], serde_json::json!([0]));
    assert_eq!(groups[2]["cells"], serde_json::json!([1, 2, 3, 0]));
    write(
        &folder,
        "bad.msh",
        &OLD.replace("3 2 2 8 1 2 3 7", "3 2 2 7 1 3 2 7"),
    );
    let said = regge(&folder, "--mesh bad.msh --metric g.toml").stderr;
    let said = String::from_utf8_lossy(&said);
    assert!(
        said.contains("there already, and not for another physical group"),
        "{said}"
    );
}

#[test]
fn a_byte_order_mark_is_no_content() {
    let folder = folder("mark");
    write(&folder, "g.toml", &format!("\u{feff}{METRIC}"));
    for (name, text) in [("m.msh", OLD), ("m.json", crate::common::files::SQUARE)] {
        json(&folder, name, &format!("\u{feff}{text}"));
    }
}

/// Two coordinates or three, in one plane.
#[test]
fn points_in_space_may_make_a_plane_mesh() {
    let folder = folder("space");
    write(&folder, "g.toml", METRIC);
    let mesh = |z: &str| {
        format!(
            r#"{{"dimension": 2, "vertices": [[0,0,1],[1,0,1],[1,1,1],[0,1,1],[0.5,0.5,{z}]],
            "cells": [[0,1,4],[1,2,4],[2,3,4],[3,0,4]]}}"#
        )
    };
    let plane = json(&folder, "m.json", &mesh("1"));
    let two = json(&folder, "m.json", crate::common::files::SQUARE);
    assert_eq!(plane["total_curvature"], two["total_curvature"]);
    for (text, expected) in [
        (mesh("2"), "z = 2"),
        (
            mesh("1").replace("[0,0,1]", "[0,0]"),
            "vertex 1 has 3 coordinates, vertex 0 has 2",
        ),
        (
            mesh("1").replace("[0,0,1]", "[0]"),
            "vertex 0 has 1 coordinates",
        ),
    ] {
        write(&folder, "bad.json", &text);
        let output = regge(&folder, "--mesh bad.json --metric g.toml");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2));
        assert!(said.contains(expected), "{expected}: {said}");
    }
}

#[test]
fn counts_that_lie_are_refused_at_their_line() {
    let folder = folder("counts");
    write(&folder, "g.toml", METRIC);
    for (from, to, expected) in [
        (
            "1 7 1 7",
            "1 8 1 7",
            "line 5: 8 nodes are announced, 7 are there",
        ),
        (
            "2 5 1 5",
            "2 4 1 5",
            "line 23: 4 elements are announced, 5 are there",
        ),
    ] {
        let changed = NEW.replace(from, to);
        assert_ne!(changed, NEW);
        write(&folder, "bad.msh", &changed);
        let output = regge(&folder, "--mesh bad.msh --metric g.toml");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2));
        assert!(said.contains(expected), "{said}");
    }
    assert!(!fs::exists(folder.join("out.json")).expect("a folder"));
}

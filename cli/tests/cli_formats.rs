//! The forms of files: what docs/formats.md and docs/schema say against what is written.

use crate::common::files::{SQUARE, folder, run, write};
use crate::common::schema::faults;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

const SPHERE: &str =
    "dimension = 2\nconformal = \"4/(1 + x^2 + y^2)^2\"\nexact_scalar_curvature = \"2\"\n";
const TETRAHEDRA: &str = r#"{"dimension": 3, "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1],[0.25,0.25,0.25]],
 "cells": [[0,1,2,4],[0,1,3,4],[0,2,3,4],[1,2,3,4]]}"#;

fn schema() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/schema/regge-1.json");
    serde_json::from_str(&fs::read_to_string(path).expect("the schema")).expect("JSON")
}

fn inputs(name: &str) -> std::path::PathBuf {
    let folder = folder(name);
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", SPHERE);
    write(&folder, "t.json", TETRAHEDRA);
    write(
        &folder,
        "t.toml",
        "dimension = 3\nconformal = \"1/(1 + (x^2 + y^2 + z^2)/4)^2\"\n",
    );
    folder
}

fn done(folder: &Path, command: &str, arguments: &str) {
    let output = run(folder, command, arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments}: {said}");
}

fn json(folder: &Path, name: &str) -> Value {
    let text = fs::read_to_string(folder.join(name)).expect("a file");
    serde_json::from_str(&text).expect("JSON")
}

/// With everything that can be asked for and with nothing, every file is of its definition and of no other.
#[test]
fn what_is_written_is_what_the_schema_says() {
    let (folder, schema) = (inputs("schema"), schema());
    let metric = "--mesh m.json --metric g.toml";
    let space = "--mesh t.json --metric t.toml";
    let cases = [
        ("curvature", metric.to_owned()),
        (
            "curvature",
            format!("{metric} --degree 1 --norm hm2 --test-degree 3 --boundary gauss-bonnet"),
        ),
        ("curvature", format!("{space} --degree 1 --quadrature 4")),
        ("einstein", format!("{space} --degree 1")),
        ("action", space.to_owned()),
        ("action", format!("{space} --certified")),
        ("curvature", format!("{metric} --certified")),
        ("curvature", format!("{metric} --certified --degree 1")),
        ("action", format!("{space} --degree 1")),
        (
            "converge",
            "--metric flat --degree 0,1 --levels 0..=2".to_owned(),
        ),
        ("reproduce", "table1 --levels 0..=2 --plot p.svg".to_owned()),
    ];
    for (command, arguments) in cases {
        done(&folder, command, &format!("{arguments} --json out.json"));
        let kind = if ["converge", "reproduce"].contains(&command) {
            "study"
        } else {
            command
        };
        let value = json(&folder, "out.json");
        let definition = &schema["$defs"][kind];
        let found = faults(&schema, definition, &value, kind);
        assert!(found.is_empty(), "{command} {arguments}: {found:?}");
        // The test itself: a field less is seen, and so is one more.
        let mut changed = value.clone();
        changed
            .as_object_mut()
            .expect("an object")
            .remove("version");
        assert_eq!(faults(&schema, definition, &changed, kind).len(), 1);
        changed["version"] = Value::from(3);
        assert_eq!(faults(&schema, definition, &changed, kind).len(), 1);
    }
    let mesh: Value = serde_json::from_str(TETRAHEDRA).expect("JSON");
    assert!(faults(&schema, &schema["$defs"]["mesh"], &mesh, "mesh").is_empty());
}

/// The arrays of a file by their names: type, shape, bytes. By the heads alone, as a reader that cannot seek reads them.
fn arrays(path: &Path) -> BTreeMap<String, (String, Vec<u8>)> {
    let bytes = fs::read(path).expect("a file");
    let int = |at: usize, width: usize| {
        let part = &bytes[at..at + width];
        part.iter()
            .rev()
            .fold(0, |sum, b| sum << 8 | usize::from(*b))
    };
    let (mut at, mut all) = (0, BTreeMap::new());
    while bytes[at..].starts_with(b"PK\x03\x04") {
        let (size, name) = (int(at + 22, 4), int(at + 26, 2));
        let start = at + 30 + name;
        let name = String::from_utf8_lossy(&bytes[at + 30..start]).into_owned();
        assert!(bytes[start..].starts_with(b"\x93NUMPY\x01\x00"), "{name}");
        let head = 10 + int(start + 8, 2);
        let about = String::from_utf8_lossy(&bytes[start + 10..start + head]).into_owned();
        let data = bytes[start + head..start + size].to_vec();
        all.insert(name.replace(".npy", ""), (about, data));
        at = start + size;
    }
    assert!(
        bytes[at..].starts_with(b"PK\x01\x02"),
        "a directory follows"
    );
    all
}

fn doubles(bytes: &[u8]) -> Vec<f64> {
    let eights = bytes.chunks_exact(8);
    eights
        .map(|b| f64::from_le_bytes(b.try_into().expect("eight bytes")))
        .collect()
}

/// Every list of the JSON file is there, with the same numbers.
#[test]
fn numpy_is_given_what_json_has() {
    let folder = inputs("npz");
    let space = "--mesh t.json --metric t.toml";
    for (command, arguments, lists) in [
        (
            "curvature",
            format!("{space} --degree 1 --test-degree 2 --boundary gauss-bonnet"),
            vec!["vertices", "test_functions", "hinges", "faces"],
        ),
        ("einstein", format!("{space} --degree 1"), vec!["functions"]),
        ("action", space.to_owned(), vec!["gradient"]),
    ] {
        done(
            &folder,
            command,
            &format!("{arguments} --json o.json --npz o.npz"),
        );
        let (value, arrays) = (json(&folder, "o.json"), arrays(&folder.join("o.npz")));
        for list in lists {
            let rows = value[list].as_array().expect("a list");
            for key in rows[0].as_object().expect("an object").keys() {
                let (about, data) = &arrays[&format!("{list}_{key}")];
                assert!(
                    about.contains(&format!("'shape': ({},", rows.len())),
                    "{about}"
                );
                if about.contains("'<f8'") {
                    let known = rows.iter().map(|row| row[key].as_f64().expect("a number"));
                    for (found, known) in doubles(data).into_iter().zip(known) {
                        assert!((found - known).abs() <= 1e-15 * known.abs(), "{list} {key}");
                    }
                }
            }
        }
        let (_, text) = &arrays["report"];
        let text: String = text
            .chunks_exact(4)
            .filter_map(|b| char::from_u32(u32::from_le_bytes(b.try_into().expect("four bytes"))))
            .collect();
        let report: Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(report["mesh"], value["mesh"]);
        assert_eq!(report["format"], 1);
    }
}

/// Tables and meshes of hinges and faces in space: as many as the report has, with its numbers.
#[test]
fn hinges_and_faces_have_files_of_their_own() {
    let folder = inputs("hinges");
    let files =
        "--hinges-csv h.csv --faces-csv f.csv --hinges-vtu h.vtu --faces-vtu f.vtu --vtu c.vtu";
    let command = "--mesh t.json --metric t.toml --degree 1 --boundary gauss-bonnet --json o.json";
    done(&folder, "curvature", &format!("{command} {files}"));
    let value = json(&folder, "o.json");
    let text = |name: &str| {
        String::from_utf8_lossy(&fs::read(folder.join(name)).expect("a file")).into_owned()
    };
    for (csv, vtu, list, head, column) in [
        (
            "h.csv",
            "h.vtu",
            "hinges",
            "v0,v1,defect,volume\n",
            "defect",
        ),
        ("f.csv", "f.vtu", "faces", "v0,v1,v2,jump\n", "jump"),
    ] {
        let rows = value[list].as_array().expect("a list");
        let table = text(csv);
        assert!(table.starts_with(head), "{table}");
        assert_eq!(table.lines().count(), rows.len() + 1);
        let place = head.trim_end().split(',').position(|name| name == column);
        let last = table
            .lines()
            .last()
            .and_then(|l| l.split(',').nth(place.expect("a column")));
        let found: f64 = last.expect("a number").parse().expect("a number");
        let known = rows[rows.len() - 1][column].as_f64().expect("a number");
        assert!((found - known).abs() <= 1e-15 * known.abs());
        let mesh = text(vtu);
        assert!(mesh.contains(&format!(
            "NumberOfPoints=\"5\" NumberOfCells=\"{}\"",
            rows.len()
        )));
        assert!(mesh.contains(&format!("Name=\"{column}\"")));
    }
    assert!(text("c.vtu").contains("Name=\"sum_boundary\""));
    let output = run(
        &folder,
        "curvature",
        "--mesh t.json --metric t.toml --plot p.svg",
    );
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.code() == Some(2) && said.contains("ParaView"),
        "{said}"
    );
}

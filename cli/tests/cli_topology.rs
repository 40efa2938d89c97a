//! Meshes that are no ball: several pieces, vertices that are no manifold, dimension five.

use crate::common::files::{curvature, folder, run, write};
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::fs;
use std::path::Path;

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key}"))
}

/// All edges with length 1.
fn files(folder: &Path, n: usize, cells: &[Vec<usize>]) {
    let mut edges = std::collections::BTreeSet::new();
    for cell in cells {
        for (i, &a) in cell.iter().enumerate() {
            edges.extend(cell[..i].iter().map(|&b| (a.min(b), a.max(b))));
        }
    }
    let lines: Vec<String> = edges.iter().map(|(a, b)| format!("{a},{b},1\n")).collect();
    write(
        folder,
        "m.json",
        &json!({"dimension": n, "cells": cells}).to_string(),
    );
    write(folder, "l.csv", &lines.concat());
}

fn simplex_boundary(n: usize, first: usize) -> Vec<Vec<usize>> {
    let without = |out: usize| {
        (0..n + 2)
            .filter(|v| *v != out)
            .map(|v| v + first)
            .collect()
    };
    (0..n + 2).map(without).collect()
}

/// The torus of seven vertices (Möbius, Császár): i, i+1, i+3 and i, i+2, i+3 modulo 7.
fn torus() -> Vec<Vec<usize>> {
    let triangles = |a: usize, b: usize| (0..7).map(move |i| vec![i, (i + a) % 7, (i + b) % 7]);
    triangles(1, 3).chain(triangles(2, 3)).collect()
}

/// A sphere, a torus and a triangle: 4πχ each, the triangle by its boundary.
#[test]
fn each_piece_has_its_own_total() {
    let folder = folder("pieces");
    let mut cells = simplex_boundary(2, 0);
    cells.extend(
        torus()
            .iter()
            .map(|cell| cell.iter().map(|v| v + 4).collect()),
    );
    cells.push(vec![11, 12, 13]);
    files(&folder, 2, &cells);
    let found = curvature(
        &folder,
        "--mesh m.json --lengths l.csv --boundary gauss-bonnet",
    );
    let pieces = found["pieces"].as_array().expect("pieces");
    let known = [(0, 4, true, 2), (4, 14, true, 0), (18, 1, false, 1)];
    assert_eq!(pieces.len(), known.len());
    for (piece, (first, cells, closed, chi)) in pieces.iter().zip(known) {
        assert_eq!(piece["first_cell"], first);
        assert_eq!(piece["cell_count"], cells);
        assert_eq!(piece["closed"], closed);
        assert_eq!(piece["euler_characteristic"], chi);
        let total = 4.0 * PI * f64::from(chi);
        assert!((number(piece, "total_curvature") - total).abs() < 1e-12);
        assert!(number(piece, "gauss_bonnet_residual").abs() < 1e-12);
    }
    let output = run(&folder, "curvature", "--mesh m.json --lengths l.csv");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(said.contains("the mesh falls into 3 pieces"), "{said}");
    // Without the boundary's terms the triangle has no residual, and neither has the whole.
    let paper = curvature(&folder, "--mesh m.json --lengths l.csv");
    assert!(paper["pieces"][2]["gauss_bonnet_residual"].is_null());
    assert!(number(&paper["pieces"][1], "gauss_bonnet_residual").abs() < 1e-12);
}

/// The suspension of a torus: closed, every edge and face is as on a manifold, but the link of both poles is a torus.
#[test]
fn a_vertex_that_is_no_manifold_is_noted_and_computed() {
    let folder = folder("suspension");
    let pole = |pole: usize| {
        torus().into_iter().map(move |mut cell| {
            cell.push(pole);
            cell
        })
    };
    let cells: Vec<Vec<usize>> = pole(7).chain(pole(8)).collect();
    files(&folder, 3, &cells);
    let found = curvature(&folder, "--mesh m.json --lengths l.csv");
    assert_eq!(found["closed"], true);
    let note = found["notes"][0].as_str().expect("a note");
    assert!(
        note.contains("no manifold at vertex 7 and 1 more"),
        "{note}"
    );
    assert!(note.contains("Euler characteristic 0, not 2"), "{note}");
    // Edges of the torus are in 2·2 tetrahedra, those to the poles in 6; dihedral angle arccos ⅓.
    let theta = |around: f64| 2.0 * PI - around * (1.0f64 / 3.0).acos();
    let total = 2.0 * (21.0 * theta(4.0) + 14.0 * theta(6.0));
    assert!((number(&found, "total_curvature") - total).abs() < 1e-11);
    files(&folder, 3, &simplex_boundary(3, 0));
    let sphere = curvature(&folder, "--mesh m.json --lengths l.csv");
    assert_eq!(sphere["notes"], json!([]));
}

/// ∂Δ⁶: 35 tetrahedra of volume √2/12, three 5-simplices around each with dihedral angle arccos ⅕.
#[test]
fn five_dimensions_work() {
    let folder = folder("five");
    files(&folder, 5, &simplex_boundary(5, 0));
    let theta = 2.0 * PI - 3.0 * 0.2f64.acos();
    let known = 2.0 * 35.0 * theta * 2f64.sqrt() / 12.0;
    let found = curvature(&folder, "--mesh m.json --lengths l.csv");
    assert!((number(&found, "total_curvature") - known).abs() < 1e-11);
    for command in ["action", "einstein"] {
        let output = run(
            &folder,
            command,
            "--mesh m.json --lengths l.csv --json out.json",
        );
        assert_eq!(output.status.code(), Some(0));
    }
    let einstein = fs::read_to_string(folder.join("out.json")).expect("a file");
    let einstein: Value = serde_json::from_str(&einstein).expect("JSON");
    assert_eq!(einstein["functions"].as_array().map(Vec::len), Some(21));
    // The unit sphere in a chart, on one cell: R = 20.
    let mut vertices = vec![[0.0; 5]];
    vertices.extend((0..5).map(|i| std::array::from_fn(|j| if i == j { 0.1 } else { 0.0 })));
    let mesh = json!({"dimension": 5, "vertices": vertices, "cells": [[0, 1, 2, 3, 4, 5]]});
    write(&folder, "c.json", &mesh.to_string());
    let square: Vec<String> = (1..=5).map(|i| format!("x{i}^2")).collect();
    let metric = format!(
        "dimension = 5\nconformal = \"4/(1 + {})^2\"\n",
        square.join(" + ")
    );
    write(&folder, "g.toml", &metric);
    let found = curvature(
        &folder,
        "--mesh c.json --metric g.toml --degree 2 --quadrature 4",
    );
    // ∫ R ω ≈ 20 · 2⁵ · 0.1⁵/5! near the origin, where the factor falls by a few per cent.
    let cell = found["cells"][0].as_f64().expect("a number");
    let flat = 20.0 * 32.0 * 1e-5 / 120.0;
    assert!((0.8 * flat..1.05 * flat).contains(&cell), "{cell} {flat}");
    for refused in ["--norm hm2", "--plot p.svg"] {
        let output = run(
            &folder,
            "curvature",
            &format!("--mesh c.json --metric g.toml {refused}"),
        );
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.code() == Some(2) && said.contains("not 5"),
            "{said}"
        );
    }
}

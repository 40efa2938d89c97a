//! `regge einstein` and `regge action` on closed manifolds whose answers are known, and N = 4.

use crate::common::files::{curvature, folder, grid, run, write};
use serde_json::Value;
use std::f64::consts::PI;
use std::fmt::Write;
use std::fs;
use std::path::Path;

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key}"))
}

/// The JSON that a command writes.
fn json(folder: &Path, command: &str, arguments: &str) -> Value {
    let output = run(folder, command, &format!("{arguments} --json out.json"));
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments}: {said}");
    let text = fs::read_to_string(folder.join("out.json")).expect("a file");
    serde_json::from_str(&text).expect("JSON")
}

/// A table that gives every edge of the cells one length.
fn equal_lengths(cells: &[Vec<usize>], length: f64) -> String {
    let mut edges = std::collections::BTreeSet::new();
    for cell in cells {
        for (i, &a) in cell.iter().enumerate() {
            edges.extend(cell[..i].iter().map(|&b| (a.min(b), a.max(b))));
        }
    }
    let mut text = String::from("i,j,length\n");
    for (a, b) in edges {
        let _ = writeln!(text, "{a},{b},{length:e}");
    }
    text
}

fn files(folder: &Path, n: usize, cells: &[Vec<usize>], length: f64) {
    let mesh = serde_json::json!({"dimension": n, "cells": cells});
    write(folder, "m.json", &mesh.to_string());
    write(folder, "l.csv", &equal_lengths(cells, length));
}

/// ∂Δ^{N+1}.
fn simplex_boundary(n: usize) -> Vec<Vec<usize>> {
    let without = |out: usize| (0..n + 2).filter(|v| *v != out).collect();
    (0..n + 2).map(without).collect()
}

/// The 600-cell: 120 unit quaternions, edges of length 1/φ, cells the sets of four neighbours.
fn cell_600() -> Vec<Vec<usize>> {
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let mut points: Vec<[f64; 4]> = Vec::new();
    for axis in 0..4 {
        points
            .extend([1.0, -1.0].map(|s| std::array::from_fn(|i| if i == axis { s } else { 0.0 })));
    }
    let sign = |bits: usize, i: usize| if bits >> i & 1 == 1 { -0.5 } else { 0.5 };
    points.extend((0..16).map(|bits| std::array::from_fn(|i| sign(bits, i))));
    // The even permutations of (φ, 1, 1/φ, 0)/2 with all signs: the place of 0, and cyclic shifts of the other three.
    for zero in 0..4 {
        let others: Vec<usize> = (0..4).filter(|i| *i != zero).collect();
        for shift in 0..3 {
            // Shifting three entries is even; an odd place of 0 is mended by exchanging two others.
            let mut order: Vec<usize> = (0..3).map(|i| others[(i + shift) % 3]).collect();
            if zero % 2 == 0 {
                order.swap(0, 1);
            }
            for bits in 0..8 {
                let mut point = [0.0; 4];
                for (i, value) in [phi, 1.0, 1.0 / phi].into_iter().enumerate() {
                    point[order[i]] = value * sign(bits, i);
                }
                points.push(point);
            }
        }
    }
    let near = |a: usize, b: usize| {
        let square: f64 = (0..4).map(|i| (points[a][i] - points[b][i]).powi(2)).sum();
        (square - 1.0 / (phi * phi)).abs() < 1e-9
    };
    let mut cells = Vec::new();
    for a in 0..120 {
        let list: Vec<usize> = (a + 1..120).filter(|&b| near(a, b)).collect();
        for (i, &b) in list.iter().enumerate() {
            for (j, &c) in list
                .iter()
                .enumerate()
                .skip(i + 1)
                .filter(|(_, c)| near(b, **c))
            {
                let last = list[j + 1..].iter().filter(|&&d| near(b, d) && near(c, d));
                cells.extend(last.map(|&d| vec![a, b, c, d]));
            }
        }
    }
    cells
}

/// n edges of length ℓ with m regular tetrahedra around each: the action is n ℓ (2π − m arccos ⅓).
#[test]
fn regges_action_and_schlaeflis_identity_on_spheres() {
    let folder = folder("action");
    let phi = (1.0 + 5f64.sqrt()) / 2.0;
    let cells = cell_600();
    assert_eq!(cells.len(), 600);
    let cases = [
        (simplex_boundary(3), 10.0, 1.0, 3.0),
        (cells, 720.0, 1.0 / phi, 5.0),
    ];
    for (cells, edges, length, around) in cases {
        files(&folder, 3, &cells, length);
        let theta = 2.0 * PI - around * (1.0f64 / 3.0).acos();
        let arguments = "--mesh m.json --lengths l.csv";
        let found = json(&folder, "action", &format!("{arguments} --csv d.csv"));
        let known = edges * length * theta;
        assert!((number(&found, "action") - known).abs() < 1e-10 * known);
        assert_eq!(number(&found, "boundary"), 0.0);
        assert!(number(&found, "schlaefli") < 1e-10);
        let gradient = found["gradient"].as_array().expect("a gradient");
        assert_eq!(gradient.len() as f64, edges);
        assert!(
            gradient
                .iter()
                .all(|e| (number(e, "derivative") - theta).abs() < 1e-10)
        );
        // ⟨Gω, ∂g/∂(ℓ²)⟩ = −Θ/ℓ: |S| = ℓ, and Tr of ∂g/∂(ℓ²) along the edge is 1/ℓ².
        let einstein = json(&folder, "einstein", arguments);
        let functions = einstein["functions"].as_array().expect("functions");
        assert_eq!(functions.len() as f64, edges);
        assert!(
            functions
                .iter()
                .all(|f| (number(f, "total") + theta / length).abs() < 1e-10)
        );
        // The same sums as the curvature's total: twice the action.
        let total = number(&curvature(&folder, arguments), "total_curvature");
        assert!((total - 2.0 * known).abs() < 1e-10 * known);
    }
}

/// ∂Δ⁵: 20 triangles of area √3/4, three 4-simplices around each with dihedral angle arccos ¼.
#[test]
fn four_dimensions_are_read_from_json() {
    let folder = folder("four");
    files(&folder, 4, &simplex_boundary(4), 1.0);
    let theta = 2.0 * PI - 3.0 * 0.25f64.acos();
    let area = 3f64.sqrt() / 4.0;
    let found = json(&folder, "action", "--mesh m.json --lengths l.csv");
    assert!((number(&found, "action") - 20.0 * theta * area).abs() < 1e-10);
    assert!(number(&found, "schlaefli") < 1e-10);
    // Each edge is in four triangles, and ∂(√3/4 ℓ²)/∂ℓ of one edge alone is √3/6.
    let each = 4.0 * theta * 3f64.sqrt() / 6.0;
    let gradient = found["gradient"].as_array().expect("a gradient");
    assert!(
        gradient
            .iter()
            .all(|e| (number(e, "derivative") - each).abs() < 1e-10)
    );
    let total = number(
        &curvature(&folder, "--mesh m.json --lengths l.csv"),
        "total_curvature",
    );
    assert!((total - 40.0 * theta * area).abs() < 1e-10);
}

/// A metric of degree 1 has an action and an Einstein tensor, but no gradient in lengths.
#[test]
fn higher_degrees_have_an_action_and_an_einstein_tensor() {
    let folder = folder("degree");
    let cube = r#"{"dimension": 3, "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1],[0.25,0.25,0.25]],
        "cells": [[0,1,2,4],[0,1,3,4],[0,2,3,4],[1,2,3,4]]}"#;
    write(&folder, "m.json", cube);
    write(
        &folder,
        "g.toml",
        "dimension = 3\nconformal = \"1/(1 + (x^2 + y^2 + z^2)/4)^2\"\n",
    );
    let arguments = "--mesh m.json --metric g.toml --degree 1";
    let action = json(&folder, "action", arguments);
    assert!(action["gradient"].is_null() && number(&action, "boundary") > 1.0);
    let einstein = json(&folder, "einstein", arguments);
    // Four inner edges with two functions each, six inner faces with three, four cells with none (r = 1, N = 3: 3 on a
    // face, 0 in a cell).
    assert_eq!(
        einstein["functions"].as_array().map(Vec::len),
        Some(4 * 2 + 6 * 3)
    );
    assert!(number(&einstein, "largest") > 1e-3);
    write(&folder, "p.json", crate::common::files::SQUARE);
    write(&folder, "p.toml", "dimension = 2\nconformal = \"1\"\n");
    let plane = run(&folder, "einstein", "--mesh p.json --metric p.toml");
    assert_eq!(plane.status.code(), Some(2));
}

/// Enclosures contain the closed forms, and the only integer is the Euler characteristic.
#[test]
fn certified_numbers() {
    let folder = folder("certified");
    let bounds = |value: &Value| [0, 1].map(|k| value[k].as_f64().expect("a number"));
    for (n, count, size) in [(2, 4, 1.0), (3, 10, 1.0), (4, 20, 3f64.sqrt() / 4.0)] {
        files(&folder, n, &simplex_boundary(n), 1.0);
        let arguments = "--mesh m.json --lengths l.csv --certified";
        let of = |command: &str| json(&folder, command, arguments)["enclosures"].clone();
        let enclosures = of("action");
        let defect = 2.0 * PI - 3.0 * (1.0 / f64::from(n as u32)).acos();
        let wanted = f64::from(count) * defect * size;
        let [low, high] = bounds(&enclosures["action"]);
        assert!(
            low <= wanted && wanted <= high && high - low < 1e-11,
            "{low} {high}"
        );
        let hinges = enclosures["hinges"].as_array().expect("a list");
        assert_eq!(hinges.len(), count as usize);
        for hinge in hinges {
            let [low, high] = bounds(&hinge["defect"]);
            assert!(low <= defect && defect <= high && high < defect + 1e-9);
        }
        let chi = &of("curvature")["euler_characteristic"];
        assert_eq!(chi.as_i64(), (n == 2).then_some(2));
    }
    let refused = run(
        &folder,
        "action",
        "--mesh m.json --lengths l.csv --certified --degree 1",
    );
    assert_eq!(refused.status.code(), Some(2));
}

/// A part of a sphere of radius 10.
#[test]
fn bounds_that_hold_everywhere() {
    let folder = folder("everywhere");
    write(&folder, "m.json", &grid(4));
    let sphere = "dimension = 2\nconformal = \"1/(1 + (x^2 + y^2)/400)^2\"\n";
    write(&folder, "g.toml", sphere);
    let arguments = "--mesh m.json --metric g.toml --degree 2 --certified";
    let said = run(&folder, "curvature", arguments).stdout;
    let said = String::from_utf8(said).expect("text");
    for line in [
        "certified: the metric is positive definite everywhere on its 32 cells",
        "certified: R is positive everywhere on 32 cells, negative everywhere on 0, neither is shown on 0",
    ] {
        assert!(said.contains(line), "{said}");
    }
    let everywhere = &json(&folder, "curvature", arguments)["everywhere"];
    for bounds in everywhere["cells"].as_array().expect("cells") {
        let [low, high] = [0, 1].map(|k| bounds[k].as_f64().expect("a number"));
        // R = 2/10² of the smooth metric, to the first order of a mesh of size 1/10 of the radius.
        assert!(low > 0.015 && high < 0.025, "{bounds}");
    }
    let inner = |s: &&Value| s["interior"].as_bool() == Some(true);
    let count = |list: &str| {
        everywhere[list]
            .as_array()
            .expect("a list")
            .iter()
            .filter(inner)
            .count()
    };
    assert_eq!((count("faces"), count("hinges")), (40, 9));
}

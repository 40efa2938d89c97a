//! `regge curvature` as its users meet it: the reference cases through files, spheres from lengths.

use crate::common::files::{SQUARE, curvature, folder, write};
use serde_json::Value;
use std::fmt::Write;
use std::fs;
use std::path::Path;

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter().map(|x| x.as_f64().expect("a number")).collect()
}

/// A mesh in Gmsh's format 2.2, from JSON lists.
fn msh(vertices: &Value, cells: &Value) -> String {
    let (vertices, cells) = (
        vertices.as_array().expect("a list"),
        cells.as_array().expect("a list"),
    );
    let mut text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n",
        vertices.len()
    );
    for (i, vertex) in vertices.iter().enumerate() {
        let x = numbers(vertex);
        let z = x.get(2).copied().unwrap_or(0.0);
        let _ = writeln!(text, "{} {:e} {:e} {z:e}", i + 1, x[0], x[1]);
    }
    let _ = write!(text, "$EndNodes\n$Elements\n{}\n", cells.len());
    for (i, cell) in cells.iter().enumerate() {
        let nodes = numbers(cell);
        let kind = if nodes.len() == 3 { 2 } else { 4 };
        let _ = write!(text, "{} {kind} 2 1 1", i + 1);
        for node in nodes {
            let _ = write!(text, " {}", node + 1.0);
        }
        text.push('\n');
    }
    text + "$EndElements\n"
}

/// The oracles' metrics, as their README states them.
fn metric(name: &str, n: usize) -> String {
    let quartic = |i: usize| format!("x{i}^2/2 - x{i}^4/12");
    let body = match name {
        "graph-quartic" => {
            let parts: Vec<String> = (1..=n).map(quartic).collect();
            format!("graph = \"{}\"", parts.join(" + "))
        }
        "conformal-sphere" => {
            let parts: Vec<String> = (1..=n).map(|i| format!("x{i}^2")).collect();
            format!("conformal = \"4/(1 + {})^2\"", parts.join(" + "))
        }
        _ => {
            let entry = |i: usize, j: usize| match i == j {
                true => format!("\"1 + 0.15*sin(1.5*x{} + 0.6*{i})\"", i + 1),
                false => {
                    let (i, j) = (i.min(j), i.max(j));
                    format!("\"0.09*sin(x{} + x{}/2 + 0.3*{})\"", i + 1, j + 1, i + j)
                }
            };
            let row = |i: usize| (0..n).map(|j| entry(i, j)).collect::<Vec<_>>().join(", ");
            let rows: Vec<String> = (0..n).map(|i| format!("[{}]", row(i))).collect();
            format!("g = [{}]", rows.join(", "))
        }
    };
    format!("dimension = {n}\n{body}\n")
}

/// The three sums of a reference case of another program, from a mesh file and formulas.
///
/// The reference differentiates by differences: 1e-8 of the largest entry is what its README promises.
#[test]
fn the_oracles_are_met_through_files() {
    let oracles = concat!(env!("CARGO_MANIFEST_DIR"), "/../verify/oracle/cases");
    let folder = folder("oracles");
    let mut cases = 0;
    for entry in fs::read_dir(oracles).expect("the oracles") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|extension| extension != "json") {
            continue;
        }
        let text = fs::read_to_string(&path).expect("a case");
        compare(&folder, &serde_json::from_str(&text).expect("JSON"));
        cases += 1;
    }
    assert_eq!(cases, 10);
}

fn compare(folder: &Path, oracle: &Value) {
    let name = oracle["name"].as_str().expect("a name");
    let n = oracle["dimension"].as_u64().expect("N") as usize;
    write(
        folder,
        "m.msh",
        &msh(&oracle["vertices"], &oracle["simplices"]),
    );
    write(
        folder,
        "g.toml",
        &metric(oracle["metric"].as_str().expect("a metric"), n),
    );
    let interpolant = match oracle["interpolant"].as_str() {
        Some("canonical") => "canonical",
        _ => "average-hierarchical",
    };
    let mut arguments = format!(
        "--mesh m.msh --metric g.toml --degree {} --interpolant {interpolant}",
        oracle["degree"]
    );
    if n == 2 && !oracle["hm2"].is_null() {
        arguments += " --norm hm2";
    }
    let ours = curvature(folder, &arguments);
    let theirs = &oracle["curvature"];
    let lists = ["element", "face", "angle"].map(|key| numbers(&theirs[key]));
    let scale = lists.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
    let vertices = ours["vertices"].as_array().expect("vertices");
    assert_eq!(vertices.len(), lists[0].len(), "{name}");
    for (i, row) in vertices.iter().enumerate() {
        assert_eq!(row["vertex"], theirs["vertex"][i], "{name}");
        for (key, list) in ["cells", "faces", "hinges"].iter().zip(&lists) {
            let found = row[*key].as_f64().expect("a number");
            assert!(
                (found - list[i]).abs() <= 1e-8 * scale,
                "{name}: {key} {found} {}",
                list[i]
            );
        }
    }
    if let Some(found) = ours["hm2"]["error"].as_f64() {
        let known = oracle["hm2"]["error"].as_f64().expect("a number");
        assert!(
            (found / known - 1.0).abs() < 1e-6,
            "{name}: {found} {known}"
        );
    }
}

/// An icosahedron, each triangle cut into four, as often as asked, vertices on the unit sphere.
fn sphere(times: usize) -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let t = (1.0 + 5f64.sqrt()) / 2.0;
    let mut points = Vec::new();
    for (a, b) in [(1.0, t), (-1.0, t), (1.0, -t), (-1.0, -t)] {
        points.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let far = |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>();
    let mut cells = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                // Edges of this icosahedron have length 2.
                let edge = |i: usize, j: usize| far(&points[i], &points[j]) < 4.1;
                if edge(a, b) && edge(b, c) && edge(a, c) {
                    cells.push([a, b, c]);
                }
            }
        }
    }
    for _ in 0..times {
        cells = split(&mut points, &cells);
    }
    let unit = |p: &[f64; 3]| {
        let r = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        p.map(|x| x / r)
    };
    (points.iter().map(unit).collect(), cells)
}

fn split(points: &mut Vec<[f64; 3]>, cells: &[[usize; 3]]) -> Vec<[usize; 3]> {
    let mut middles = std::collections::HashMap::new();
    let mut finer = Vec::new();
    for &[a, b, c] in cells {
        let mut middle = |i: usize, j: usize| {
            *middles.entry((i.min(j), i.max(j))).or_insert_with(|| {
                let (p, q) = (points[i], points[j]);
                points.push([0, 1, 2].map(|k| (p[k] + q[k]) / 2.0));
                points.len() - 1
            })
        };
        let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
        finer.extend([[a, x, z], [b, y, x], [c, z, y], [x, y, z]]);
    }
    finer
}

/// All edges with their lengths, as a table.
fn lengths(points: &[[f64; 3]], cells: &[[usize; 3]]) -> String {
    let mut edges = std::collections::BTreeSet::new();
    for &[a, b, c] in cells {
        edges.extend([(a, b), (b, c), (a, c)].map(|(i, j)| (i.min(j), i.max(j))));
    }
    let mut text = String::from("i,j,length\n");
    for (i, j) in edges {
        let square: f64 = (0..3).map(|k| (points[i][k] - points[j][k]).powi(2)).sum();
        let _ = writeln!(text, "{i},{j},{:e}", square.sqrt());
    }
    text
}

/// Gauss and Bonnet: Σ 2Θ = 4πχ = 8π, by lengths alone, on an abstract manifold and on a surface in space.
#[test]
fn a_sphere_by_edge_lengths_has_curvature_8_pi() {
    let folder = folder("sphere");
    let (points, cells) = sphere(2);
    write(&folder, "l.csv", &lengths(&points, &cells));
    let mesh = serde_json::json!({"dimension": 2, "cells": cells});
    write(&folder, "m.json", &mesh.to_string());
    write(
        &folder,
        "m.msh",
        &msh(&serde_json::json!(points), &serde_json::json!(cells)),
    );
    for file in ["m.json", "m.msh"] {
        let found = curvature(
            &folder,
            &format!("--mesh {file} --lengths l.csv --csv v.csv"),
        );
        let total = found["total_curvature"].as_f64().expect("a number");
        assert!(
            (total - 8.0 * std::f64::consts::PI).abs() < 1e-10,
            "{total}"
        );
        assert_eq!(found["euler_characteristic"], 2);
        assert!(
            found["gauss_bonnet_residual"]
                .as_f64()
                .expect("a number")
                .abs()
                < 1e-10
        );
        let table = fs::read_to_string(folder.join("v.csv")).expect("a table");
        assert_eq!(table.lines().count(), points.len() + 1);
    }
}

/// The local integrals add up to the sums, and a stated R gives the norm that the kernel's own R gives.
#[test]
fn the_parts_of_the_report_fit_together() {
    let folder = folder("parts");
    write(&folder, "m.json", SQUARE);
    let sphere = "dimension = 2\nconformal = \"4/(1 + x^2 + y^2)^2\"\n";
    write(&folder, "g.toml", sphere);
    write(
        &folder,
        "r.toml",
        &format!("{sphere}exact_scalar_curvature = \"2\"\n"),
    );
    let command = "--mesh m.json --degree 1 --test-degree 2 --norm hm2 --metric";
    let found = curvature(&folder, &format!("{command} g.toml"));
    let list = |key: &str| found[key].as_array().expect("a list").clone();
    let sum = |key: &str, part: &str| -> f64 {
        list(key)
            .iter()
            .map(|x| x[part].as_f64().expect("a number"))
            .sum()
    };
    let cells: f64 = numbers(&found["cells"]).iter().sum();
    let total = cells + 2.0 * sum("faces", "jump") + 2.0 * sum("hinges", "defect");
    let stated = found["total_curvature"].as_f64().expect("a number");
    assert!((total - stated).abs() < 1e-10, "{total} {stated}");
    assert_eq!(found["quadrature"]["settled"], true);
    // One vertex and four edges inside.
    assert_eq!(list("test_functions").len(), 5);
    let again = curvature(&folder, &format!("{command} r.toml"));
    let error = |value: &Value| value["hm2"]["error"].as_f64().expect("a number");
    assert!((error(&again) / error(&found) - 1.0).abs() < 1e-6);
}

/// With everything asked for, each thing is done once: one set-up of the norm, one solution, one projection.
#[test]
fn nothing_is_done_twice() {
    use regge_cli::curvature::{Boundary, Request, Source, curvature};
    let file = |name: &str| {
        Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../examples/files")
            .join(name)
    };
    let mesh = regge_readers::mesh::read_mesh(&file("disc.msh")).expect("the example's mesh");
    let metric = regge_readers::metric::read_metric(&file("sphere.toml")).expect("its metric");
    let source = Source::Metric(Box::new(metric), regge_curvature::Interpolant::canonical());
    let request = Request {
        degree: 1,
        quadrature: None,
        test_degree: Some(2),
        norm: Some("hm2"),
        trust_stated: false,
        boundary: Boundary::GaussBonnet,
        details: true,
        fields: true,
        table: false,
        certified: false,
    };
    let phases = std::cell::RefCell::new(Vec::new());
    let report = curvature(&mesh, &source, &request, &|phase| {
        phases.borrow_mut().push(phase.to_owned())
    });
    let report = report.expect("a curvature");
    let mut once = phases.borrow().clone();
    once.sort_unstable();
    once.dedup();
    assert_eq!(once.len(), phases.borrow().len(), "{phases:?}");
    // The norm's load is that of the order by which the sums settled.
    let norm = report.norms.get("hm2").expect("asked for");
    assert_eq!(norm.quadrature.order, report.about.quadrature.order);
    assert_eq!(norm.quadrature.settled, Some(true));
}

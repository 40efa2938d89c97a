//! Surfaces with the metric of their own points: files of other programs in; tables, PLY and pictures out.

use crate::common::files::{curvature, folder, regge, write};
use std::f64::consts::PI;
use std::fmt::Write;
use std::fs;
use std::path::Path;

type Surface = (Vec<[f64; 3]>, Vec<[usize; 3]>);

/// A torus of revolution with radii 2 and 1, `n` points around and `m` the other way; without the last ring it is open.
fn torus(n: usize, m: usize, open: bool) -> Surface {
    let point = |i: usize, j: usize| {
        let [u, v] = [i as f64 / n as f64, j as f64 / m as f64].map(|t| 2.0 * PI * t);
        let r = 2.0 + v.cos();
        [r * u.cos(), r * u.sin(), v.sin()]
    };
    let mut points = Vec::new();
    let mut cells = Vec::new();
    for i in 0..n {
        points.extend((0..m).map(|j| point(i, j)));
        for j in (0..m).filter(|_| i + 1 < n || !open) {
            let at = |i: usize, j: usize| (i % n) * m + j % m;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            cells.extend([[a, b, c], [a, c, d]]);
        }
    }
    (points, cells)
}

fn obj((points, cells): &Surface) -> String {
    let mut text = String::new();
    for [x, y, z] in points {
        let _ = writeln!(text, "v {x:e} {y:e} {z:e}");
    }
    for [a, b, c] in cells {
        let _ = writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1);
    }
    text
}

/// Σθ at the vertices, each angle by its cross and dot products in space, and a third of the areas around.
fn angles_and_areas((points, cells): &Surface) -> Vec<[f64; 2]> {
    let mut sums = vec![[0.0; 2]; points.len()];
    for cell in cells {
        for i in 0..3 {
            let [a, b, c] = [0, 1, 2].map(|j| points[cell[(i + j) % 3]]);
            let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
            let cross = [1, 2, 0].map(|k| u[k] * v[(k + 1) % 3] - u[(k + 1) % 3] * v[k]);
            let size = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
            let dot: f64 = (0..3).map(|k| u[k] * v[k]).sum();
            sums[cell[i]][0] += size.atan2(dot);
            sums[cell[i]][1] += size / 6.0;
        }
    }
    sums
}

/// The table's columns by name; NaN for an empty field.
fn table(folder: &Path, name: &str) -> impl Fn(&str) -> Vec<f64> {
    let text = fs::read_to_string(folder.join(name)).expect("a table");
    let rows: Vec<Vec<String>> = text
        .lines()
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect();
    move |column| {
        let place = rows[0].iter().position(|name| name == column);
        let place = place.unwrap_or_else(|| panic!("{column} is no column of {:?}", rows[0]));
        let value = |row: &Vec<String>| row[place].parse().unwrap_or(f64::NAN);
        rows[1..].iter().map(value).collect()
    }
}

#[test]
fn a_closed_surface_has_its_defects_areas_and_curvature() {
    let (folder, surface) = (folder("torus"), torus(48, 24, false));
    write(&folder, "t.obj", &obj(&surface));
    let found = curvature(&folder, "--mesh t.obj --csv t.csv");
    assert_eq!(found["interpolant"], "points");
    assert_eq!(found["euler_characteristic"], 0);
    let total = found["total_curvature"].as_f64().expect("a number");
    // 1152 defects of size 2π, each rounded.
    assert!(total.abs() < 1e-11, "{total}");
    let column = table(&folder, "t.csv");
    let (integrals, areas, k) = (column("K_integral"), column("area"), column("K"));
    for (v, [angle, area]) in angles_and_areas(&surface).iter().enumerate() {
        assert!((integrals[v] - (2.0 * PI - angle)).abs() < 1e-13, "{v}");
        assert!((areas[v] - area).abs() < 1e-14, "{v}");
    }
    // K = cos v/(2 + cos v) of the smooth torus at the outer and the inner circle. Triangles of a grid with v in 24 parts, first
    // order in their size: some per cent.
    assert!((k[0] - 1.0 / 3.0).abs() < 0.02, "{}", k[0]);
    assert!((k[12] + 1.0).abs() < 0.06, "{}", k[12]);
}

#[test]
fn the_boundary_has_its_angles_and_no_pointwise_curvature() {
    let (folder, surface) = (folder("open"), torus(32, 12, true));
    write(&folder, "t.obj", &obj(&surface));
    let found = curvature(&folder, "--mesh t.obj --boundary gauss-bonnet --csv t.csv");
    assert_eq!(found["closed"], false);
    let residual = found["gauss_bonnet_residual"].as_f64().expect("a number");
    assert!(residual.abs() < 1e-11, "{residual}");
    let notes = found["notes"].as_array().expect("notes");
    assert!(
        notes
            .iter()
            .any(|note| note.as_str().is_some_and(|n| n.contains("overshoots")))
    );
    let column = table(&folder, "t.csv");
    let (integrals, k) = (column("K_integral"), column("K"));
    for (v, [angle, _]) in angles_and_areas(&surface).iter().enumerate() {
        let outer = !(12..31 * 12).contains(&v);
        let flat = if outer { PI } else { 2.0 * PI };
        assert!((integrals[v] - (flat - angle)).abs() < 1e-13, "{v}");
        assert_eq!(k[v].is_nan(), outer, "{v}");
    }
    // The boundary's measures are not projected: R_h is that of the interior alone.
    curvature(&folder, "--mesh t.obj --csv i.csv");
    let inner = table(&folder, "i.csv")("K");
    assert_eq!(
        inner,
        k.into_iter().filter(|k| k.is_finite()).collect::<Vec<_>>()
    );
}

#[test]
fn what_is_written_as_ply_is_the_same_surface() {
    let (folder, surface) = (folder("ply"), torus(12, 8, false));
    write(&folder, "t.obj", &(obj(&surface) + "v 7 7 7\n"));
    let output = regge(&folder, "--mesh t.obj --csv a.csv --ply t.ply --vtu t.vtu");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("1 of 97 nodes belong to no cell"), "{said}");
    for file in ["t.ply", "t.vtu"] {
        let output = regge(&folder, &format!("--mesh {file} --csv b.csv"));
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{file}: {said}");
        let text = |name: &str| fs::read_to_string(folder.join(name)).expect("a table");
        assert_eq!(text("a.csv"), text("b.csv"), "{file}");
    }
    let header = fs::read(folder.join("t.ply")).expect("a file");
    let header = String::from_utf8_lossy(&header[..400]).into_owned();
    for property in ["double x", "double K_integral", "double K\n", "double area"] {
        assert!(header.contains(&format!("property {property}")), "{header}");
    }
}

/// How many facets a picture has.
fn facets(folder: &Path, name: &str) -> usize {
    let svg = fs::read_to_string(folder.join(name)).expect("a picture");
    svg.matches("<path ").count()
}

#[test]
fn pictures_of_closed_surfaces_hide_their_backs() {
    let folder = folder("view");
    // From above the outer half of a torus' triangles is seen: those with upward normals, half of them by symmetry.
    let (n, m) = (24, 12);
    write(&folder, "t.obj", &obj(&torus(n, m, false)));
    for view in ["0,90,z", "20,90,z", "0,-90,z"] {
        let output = regge(&folder, &format!("--mesh t.obj --plot t.svg --view {view}"));
        assert!(
            output.status.success(),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        assert_eq!(facets(&folder, "t.svg"), n * m, "{view}");
    }
    // Both sides of an open one are drawn.
    write(&folder, "o.obj", &obj(&torus(n, m, true)));
    assert!(regge(&folder, "--mesh o.obj --plot o.svg").status.success());
    assert_eq!(facets(&folder, "o.svg"), 2 * (n - 1) * m);
    for (view, expected) in [
        ("0", "30,20"),
        ("0,x", "'x' is no angle"),
        ("0,1,w", "30,20,y"),
    ] {
        let output = regge(&folder, &format!("--mesh t.obj --plot t.svg --view {view}"));
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(expected), "{said}");
    }
}

#[test]
fn a_degree_needs_a_formula() {
    let folder = folder("degree");
    write(&folder, "t.obj", &obj(&torus(6, 6, false)));
    let output = regge(&folder, "--mesh t.obj --degree 2");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("--metric"), "{said}");
}

/// The octahedron ±e_i.
fn octahedron() -> Surface {
    let point = |v: usize| {
        let mut x = [0.0; 3];
        x[v / 2] = if v.is_multiple_of(2) { 1.0 } else { -1.0 };
        x
    };
    // Counterclockwise seen from outside.
    let face = |signs: usize| {
        let order = match signs.count_ones() % 2 {
            0 => [0, 1, 2],
            _ => [0, 2, 1],
        };
        order.map(|i| 2 * i + (signs >> i) % 2)
    };
    ((0..6).map(point).collect(), (0..8).map(face).collect())
}

/// The octahedron with elements of order 2 in Gmsh's format 2.2, all nodes on the unit sphere.
fn curved() -> String {
    let (mut points, cells) = octahedron();
    let mut middles = std::collections::HashMap::new();
    let mut elements = String::new();
    for (i, cell) in cells.iter().enumerate() {
        let mut nodes = cell.to_vec();
        for [a, b] in [[0, 1], [1, 2], [2, 0]] {
            let [a, b] = [cell[a], cell[b]];
            nodes.push(*middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let sum = [0, 1, 2].map(|c| (points[a][c] + points[b][c]) / 2f64.sqrt());
                points.push(sum);
                points.len() - 1
            }));
        }
        let nodes: Vec<String> = nodes.iter().map(|node| (node + 1).to_string()).collect();
        let _ = writeln!(elements, "{} 9 2 1 1 {}", i + 1, nodes.join(" "));
    }
    let mut text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n",
        points.len()
    );
    for (i, [x, y, z]) in points.iter().enumerate() {
        let _ = writeln!(text, "{} {x:e} {y:e} {z:e}", i + 1);
    }
    text + &format!("$EndNodes\n$Elements\n8\n{elements}$EndElements\n")
}

#[test]
fn curved_elements_are_regge_metrics_of_twice_the_degree() {
    let folder = folder("curved");
    write(&folder, "o.msh", &curved());
    let found = curvature(&folder, "--mesh o.msh --csv o.csv --plot o.svg");
    assert_eq!(found["degree"], 2);
    assert_eq!(found["vertices"].as_array().map(Vec::len), Some(6));
    let residual = found["gauss_bonnet_residual"].as_f64().expect("a number");
    // Quadrature settles to 1e-8 of the largest sum.
    assert!(residual.abs() < 1e-6, "{residual}");
    // Nodes in the middle of edges are no vertices, but they are used.
    assert_eq!(found["notes"].as_array().map(Vec::len), Some(0));
    // A cell in 6 × 6 pieces, half of them seen.
    assert!((100..200).contains(&facets(&folder, "o.svg")));
    let areas: f64 = table(&folder, "o.csv")("area").iter().sum();
    // Eight quadratic patches through the octahedron's vertices and the middles of their arcs: |∂₁F × ∂₂F| by a product of Gauss
    // rules of 16 and of 30 points gives the same digits. It is 8 % less than the sphere's 4π.
    assert!((areas - 11.515_706_687_417).abs() < 1e-9, "{areas}");
}

#[test]
fn a_formula_may_be_in_the_coordinates_of_space() {
    let folder = folder("space");
    write(&folder, "o.obj", &obj(&octahedron()));
    write(&folder, "m.msh", &curved());
    // The map x/|x|: the unit sphere itself, whatever surface around the origin it is on.
    let part = |x: &str| format!("\"{x}/sqrt(x^2 + y^2 + z^2)\"");
    let parts = ["x", "y", "z"].map(part).join(", ");
    write(
        &folder,
        "g.toml",
        &format!("dimension = 3\nembedding = [{parts}]\n"),
    );
    for mesh in ["o.obj", "m.msh"] {
        let found = curvature(
            &folder,
            &format!("--mesh {mesh} --metric g.toml --degree 4"),
        );
        assert_eq!(found["interpolant"], "canonical");
        for vertex in found["vertices"].as_array().expect("vertices") {
            let k = vertex["K"].as_f64().expect("a number");
            // Degree 4 on eight cells.
            assert!((k - 1.0).abs() < 0.02, "{mesh}: {k}");
        }
    }
    let output = regge(&folder, "--mesh o.obj --metric g.toml --norm hm2");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("not for a surface"), "{said}");
}

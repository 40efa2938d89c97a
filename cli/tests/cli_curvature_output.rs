//! What `regge curvature` writes: boundary terms, groups, VTU, pictures; and what is left when writing fails.

use crate::common::files::{SQUARE, curvature, folder, regge, write};
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

const GRAPH: &str = "dimension = 2\ngraph = \"x^2/2 - x^4/12 + y^2/2 - y^4/12\"\n";

/// The square of four triangles with a group of cells, a group of lines, and a name with a space.
const GROUPED: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 3 \"the rim\"\n2 7 \"inside\"\n\
$EndPhysicalNames\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0.5 0.5 0\n$EndNodes\n$Elements\n6\n\
1 1 2 3 1 1 2\n2 1 2 3 1 2 3\n3 2 2 7 1 1 2 5\n4 2 2 7 1 2 3 5\n5 2 2 8 1 3 4 5\n6 2 2 0 1 4 1 5\n$EndElements\n";

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("{key}"))
}

/// Gauss and Bonnet with a boundary: 4πχ = 4π, to rounding for lengths; quadrature is converged for r = 1.
#[test]
fn boundary_terms_make_the_total_four_pi_chi() {
    let folder = folder("boundary");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", GRAPH);
    let command = "--mesh m.json --metric g.toml --boundary gauss-bonnet --csv v.csv";
    for (degree, residual) in [(0, 1e-13), (1, 1e-9)] {
        let found = curvature(&folder, &format!("{command} --degree {degree}"));
        assert_eq!(found["boundary"], "gauss-bonnet");
        assert!(number(&found, "gauss_bonnet_residual").abs() < residual);
        assert_eq!(found["vertices"].as_array().map(Vec::len), Some(5));
        let table = fs::read_to_string(folder.join("v.csv")).expect("a table");
        assert!(table.starts_with("vertex,cells,faces,hinges,boundary,total,area,K_integral,K\n"));
    }
    let paper = curvature(&folder, "--mesh m.json --metric g.toml");
    assert_eq!(paper["boundary"], "none");
    assert!(paper["gauss_bonnet_residual"].is_null());
    assert_eq!(paper["vertices"].as_array().map(Vec::len), Some(1));
    assert!(paper["vertices"][0]["boundary"].is_null());
}

/// R_h against its defining equation: for hat functions that vanish on the boundary there is one unknown,
/// R_h ∫ v² ω = ⟨Rω, v⟩, and ∫ v² = |Ω|_g / 6 for the piecewise flat metric with four equal triangles around v.
#[test]
fn the_projected_curvature_solves_its_equation() {
    let folder = folder("projected");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", GRAPH);
    let found = curvature(&folder, "--mesh m.json --metric g.toml --vtu f.vtu");
    let r_h = &found["r_h"];
    assert_eq!(r_h["degree"], 1);
    let at = |vertex: usize| number(&r_h["coefficients"][vertex], "value");
    assert_eq!(at(0), 0.0);
    let total = number(&found["vertices"][0], "total");
    let volume: f64 = doubles(&folder.join("f.vtu"), "volume").iter().sum();
    assert!((at(4) * volume / 6.0 - total).abs() < 1e-12 * total.abs());
}

/// The numbers of a Float64 array of a VTU file.
fn doubles(path: &Path, name: &str) -> Vec<f64> {
    let bytes = fs::read(path).expect("a file");
    let mark = b"encoding=\"raw\">\n_";
    let start = bytes
        .windows(mark.len())
        .position(|w| w == mark)
        .expect("data")
        + mark.len();
    let head = String::from_utf8_lossy(&bytes[..start]);
    let line = head
        .lines()
        .find(|l| l.contains(&format!("Name=\"{name}\"")))
        .expect("an array");
    assert!(line.contains("type=\"Float64\""));
    let offset = line
        .split("offset=\"")
        .nth(1)
        .and_then(|l| l.split('"').next());
    let at = start
        + offset
            .and_then(|o| o.parse::<usize>().ok())
            .expect("an offset");
    let long = |at: usize| -> [u8; 8] { bytes[at..at + 8].try_into().expect("eight bytes") };
    let count = u64::from_le_bytes(long(at)) as usize / 8;
    (0..count)
        .map(|i| f64::from_le_bytes(long(at + 8 + 8 * i)))
        .collect()
}

#[test]
fn groups_are_kept_in_json_and_vtu() {
    let folder = folder("groups");
    write(&folder, "m.msh", GROUPED);
    write(&folder, "g.toml", GRAPH);
    let found = curvature(
        &folder,
        "--mesh m.msh --metric g.toml --degree 1 --vtu f.vtu",
    );
    let groups = found["physical_groups"].as_array().expect("groups");
    assert_eq!(groups.len(), 3);
    assert_eq!(groups[0]["name"], "the rim");
    assert_eq!(groups[0]["simplices"], serde_json::json!([[0, 1], [1, 2]]));
    assert_eq!(
        (&groups[1]["name"], &groups[1]["cells"]),
        (&"inside".into(), &serde_json::json!([0, 1]))
    );
    assert_eq!(
        (&groups[2]["tag"], &groups[2]["cells"]),
        (&8.into(), &serde_json::json!([2]))
    );
    let text = fs::read(folder.join("f.vtu")).expect("a file");
    let text = String::from_utf8_lossy(&text);
    assert!(text.contains("NumberOfPoints=\"5\" NumberOfCells=\"4\""));
    assert!(text.contains("Name=\"physical_group\""));
    assert!(text.ends_with("</AppendedData>\n</VTKFile>\n"));
    let cells = doubles(&folder.join("f.vtu"), "R_integral");
    let listed: Vec<f64> = found["cells"]
        .as_array()
        .expect("cells")
        .iter()
        .filter_map(Value::as_f64)
        .collect();
    // JSON is read back to the last place but one.
    let same = |a: f64, b: f64| (a - b).abs() <= 1e-15 * a.abs();
    assert_eq!(cells.len(), listed.len());
    assert!(cells.iter().zip(&listed).all(|(a, b)| same(*a, *b)));
    let total = doubles(&folder.join("f.vtu"), "sum_total");
    assert!(same(total[4], number(&found["vertices"][0], "total")));
    assert!(
        total[..4].iter().all(|x| x.is_nan()),
        "nothing is tested on the boundary"
    );
}

#[test]
fn a_picture_shows_every_cell_and_every_inner_vertex() {
    let folder = folder("picture");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", GRAPH);
    let command = "--mesh m.json --metric g.toml --degree 1 --plot";
    curvature(&folder, &format!("{command} p.svg"));
    let svg = fs::read_to_string(folder.join("p.svg")).expect("a picture");
    // Three panels of four triangles, one disc, three bars of 100 steps with five labels each.
    assert_eq!(svg.matches("<polygon").count(), 12);
    assert_eq!(svg.matches("<circle").count(), 1);
    assert_eq!(svg.matches("font-size=\"13\"").count(), 15);
    let output = regge(&folder, &format!("{command} p.jpg"));
    assert_eq!(output.status.code(), Some(2));
}

#[cfg(feature = "png")]
#[test]
fn a_picture_may_be_png() {
    let folder = folder("png");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", GRAPH);
    curvature(
        &folder,
        "--mesh m.json --metric g.toml --degree 1 --plot p.PNG",
    );
    let png = fs::read(folder.join("p.PNG")).expect("a picture");
    assert!(png.starts_with(b"\x89PNG\r\n") && png.len() > 5000);
}

/// Without the feature, before any file is read: there is no mesh.
#[cfg(not(feature = "png"))]
#[test]
fn png_without_the_feature_is_refused_first() {
    let folder = folder("no-png");
    let output = regge(&folder, "--mesh none.msh --metric none.toml --plot p.png");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(
        said.contains("p.png") && said.contains("--features png"),
        "{said}"
    );
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0);
}

/// No more than a file of 512 bytes may be written, and the signal that says so is ignored: as on a full disk, the write
/// fails half way.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_file_whole() {
    let folder = folder("full");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", GRAPH);
    for (option, name) in [
        ("--json", "c.json"),
        ("--vtu", "c.vtu"),
        ("--plot", "c.svg"),
    ] {
        write(&folder, name, "old");
        let script = format!(
            "trap '' XFSZ; ulimit -f 1; exec \"{}\" curvature --mesh m.json --metric g.toml {option} {name}",
            env!("CARGO_BIN_EXE_regge")
        );
        let output = Command::new("sh")
            .current_dir(&folder)
            .args(["-c", &script])
            .output();
        let output = output.expect("a shell");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert_eq!(said.lines().count(), 1, "{said}");
        assert!(said.contains(name), "{said}");
        assert_eq!(
            fs::read_to_string(folder.join(name)).expect("the old file"),
            "old"
        );
    }
    assert_eq!(
        fs::read_dir(&folder).expect("a folder").count(),
        5,
        "no part is left"
    );
}

/// A device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_one_line_and_code_1() {
    let folder = folder("device");
    write(&folder, "m.json", SQUARE);
    write(&folder, "g.toml", GRAPH);
    let output = regge(&folder, "--mesh m.json --metric g.toml --json /dev/full");
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
}

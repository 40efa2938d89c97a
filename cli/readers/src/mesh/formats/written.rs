//! One surface, the boundary of a tetrahedron, as other programs write it: `seeds/make.py` says which, and how.

use super::super::{MeshFile, mesh_from};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

const POINTS: [[f64; 3]; 4] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.5, 0.0],
    [0.0, 0.0, -0.25],
];

/// The files of a folder, by name.
fn files(folder: &str) -> BTreeMap<String, PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("seeds")
        .join(folder);
    let all = fs::read_dir(folder).expect("a folder of files");
    let named = all.map(|entry| entry.expect("an entry").path());
    named
        .map(|path| (path.file_name().unwrap().to_string_lossy().into(), path))
        .collect()
}

fn read(path: &Path) -> MeshFile {
    let bytes = fs::read(path).expect("a file");
    mesh_from(path, &bytes).unwrap_or_else(|error| panic!("{error}"))
}

/// The faces, oriented and turned so that the smallest corner is first, by the places of their corners, which are named by number.
fn faces(file: &MeshFile) -> Vec<[usize; 3]> {
    let place = |v: usize| {
        let x = &file.coordinates[3 * v..][..3];
        let found = POINTS.iter().position(|p| p == x);
        found.unwrap_or_else(|| panic!("{x:?} is no corner"))
    };
    let turned = |cell: &Vec<usize>| {
        let mut corners: [usize; 3] = std::array::from_fn(|i| place(cell[i]));
        let least = (0..3).min_by_key(|&i| corners[i]).unwrap_or(0);
        corners.rotate_left(least);
        corners
    };
    let mut all: Vec<_> = file.cells.iter().map(turned).collect();
    all.sort_unstable();
    all
}

#[test]
fn every_way_to_write_a_surface_is_read() {
    let mut seen = 0;
    for (folder, least) in [
        ("obj", 2),
        ("off", 3),
        ("ply", 4),
        ("stl", 2),
        ("medit", 2),
        ("vtk", 13),
        ("vtu", 30),
    ] {
        let files = files(folder);
        assert!(files.len() >= least, "{folder}: {}", files.len());
        for (name, path) in files {
            let file = read(&path);
            assert_eq!((file.dimension, file.vertices), (2, 4), "{name}");
            assert_eq!(
                faces(&file),
                [[0, 1, 3], [0, 2, 1], [0, 3, 2], [1, 2, 3]],
                "{name}"
            );
            seen += 1;
        }
    }
    assert!(seen >= 56);
}

/// Of each order the same control points in both versions of Gmsh's format, as text and as bytes.
#[test]
fn curved_cells_are_the_same_in_every_way_to_write_them() {
    let mut known: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for (name, path) in files("curved") {
        let parts: Vec<&str> = name.split('-').collect();
        let order: usize = parts[2]["order".len()..].parse().expect("an order");
        let file = read(&path);
        let control = match parts[1] {
            "2d" => {
                let surface = file.immersion::<2>().expect("a surface");
                assert_eq!(surface.mesh().euler_characteristic(), 2, "{name}");
                assert_eq!((surface.degree(), surface.width()), (order, 3), "{name}");
                (0..4).flat_map(|cell| surface.local(cell)).collect()
            }
            _ => {
                let solid = file.immersion::<3>().expect("a solid");
                assert_eq!((solid.mesh().cell_count(), solid.degree()), (1, order));
                solid.local(0)
            }
        };
        let key = format!("{} {order}", parts[1]);
        let first = known.entry(key).or_insert_with(|| control.clone());
        // Text has sixteen digits.
        for (a, b) in control.iter().zip(&*first) {
            assert!((a - b).abs() < 1e-14, "{name}: {a} {b}");
        }
    }
    assert_eq!(known.len(), 8);
    // Nodes that are no corners lie outside: the cells are curved.
    assert_ne!(known["2d 2"].len(), known["2d 1"].len());
}

/// Bytes that are cut off anywhere are no mesh, and nothing panics on the way.
#[test]
fn no_truncated_file_of_bytes_is_a_surface() {
    for folder in ["vtk", "vtu"] {
        for (name, path) in files(folder) {
            let bytes = fs::read(&path).expect("a file");
            for end in 0..bytes.len() {
                if let Ok(file) = mesh_from(&path, &bytes[..end]) {
                    // Data of points and cells, and marks that end, may follow.
                    assert_eq!(faces(&file).len(), 4, "{name} cut at {end}");
                }
            }
        }
    }
}

/// Found by the fuzz target `vtu`: an empty list of types beside polygons, which have none, was a panic.
#[test]
fn polygons_have_no_types() {
    let path = &files("vtu")["vtk-ascii.vtp"];
    let text = fs::read_to_string(path).expect("a file");
    let types = "<Polys>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">";
    for list in ["", "7 7", "7 7 7 7 7"] {
        let changed = text.replace("<Polys>", &format!("{types}{list}</DataArray>"));
        assert_ne!(changed, text);
        let file = mesh_from(path, changed.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(faces(&file).len(), 4, "{list}");
    }
}

/// 32 MiB of zeros in 32 KiB: no mesh of so many points fits into so short a file, and thousands of times the file could be asked for.
#[test]
fn what_is_compressed_is_bounded_by_the_file() {
    let path = &files("vtu")["vtk-appended-raw-zlib-64.vtu"];
    let bytes = fs::read(path).expect("a file");
    let mark = b"encoding=\"raw\">";
    let begin = bytes.windows(mark.len()).position(|w| w == mark);
    let begin = begin.expect("data behind the marks") + mark.len();
    let zeros = miniz_oxide::deflate::compress_to_vec_zlib(&vec![0; 1 << 25], 6);
    let mut bomb = bytes[..begin].to_vec();
    bomb.push(b'_');
    for number in [1, 1 << 25, 0, zeros.len() as u64] {
        bomb.extend(number.to_le_bytes());
    }
    bomb.extend(&zeros);
    assert!(bomb.len() < 1 << 17);
    let refused = mesh_from(path, &bomb).expect_err("zeros");
    assert!(refused.reason.contains("too long for a file of this size"));
}

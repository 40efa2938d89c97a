//! Valid files, mutated at random: no reader may panic, hang, or need 1 GiB for 1 MiB.
//!
//! A few thousand cases a reader by default; `REGGE_FUZZ_SECONDS=600` runs each for ten minutes. The targets of
//! cargo-fuzz in `fuzz/` do the same, guided by coverage.

use regge_curvature::mesh::SplitMix64;
use regge_readers::trial;
use std::time::{Duration, Instant};

/// Cases of each reader, unless a time is asked for.
const CASES: u64 = 3000;
/// No case of at most 1 MiB may take longer, in seconds, even on a busy machine without optimisation.
const PATIENCE: f64 = 10.0;
/// The memory of the whole process, in KiB.
const MEMORY: u64 = 1024 * 1024;

const MSH_2: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"all of it\"\n$EndPhysicalNames\n\
$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0.5 0.5 0\n$EndNodes\n$Elements\n6\n1 15 2 0 1 1\n2 1 2 3 1 1 2\n\
3 2 2 7 1 1 2 5\n4 2 2 7 1 2 3 5\n5 2 2 7 1 3 4 5\n6 2 2 7 1 4 1 5\n$EndElements\n";
const MSH_4: &str = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n1 1 1 0\n1 0 0 0 0\n1 0 0 0 1 0 0 1 3 0\n\
1 0 0 0 1 1 0 1 7 1 1\n$EndEntities\n$Nodes\n1 5 1 5\n2 1 0 5\n1\n2\n3\n4\n5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 0\n\
$EndNodes\n$Elements\n2 5 1 5\n1 1 1 1\n1 1 2\n2 1 2 4\n2 1 2 5\n3 2 3 5\n4 3 4 5\n5 4 1 5\n$EndElements\n";
/// Nodes of no cell, a cell of two groups, a quote in a name.
const MSH_GROUPS: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 7 \"a \"b\" c\"\n$EndPhysicalNames\n\
$Nodes\n5\n1 9 9 0\n2 0 0 0\n3 1 0 0\n4 0 1 0\n5 1 1 0\n$EndNodes\n$Elements\n4\n1 15 2 3 1 1\n2 2 2 7 1 2 3 4\n\
3 2 2 8 1 2 3 4\n4 2 2 8 1 3 4 5\n$EndElements\n";
const TETRAHEDRA: &str = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n\
$EndNodes\n$Elements\n3\n1 2 2 9 1 1 2 3\n2 4 2 1 1 1 2 3 4\n3 4 2 1 1 2 3 4 5\n$EndElements\n";
const JSON: &str = r#"{"dimension": 2, "vertices": [[0,0],[1,0],[1,1],[0,1],[0.5,0.5]], "cells": [[0,1,4],[1,2,4],[2,3,4],[3,0,4]]}"#;
const ABSTRACT: &str = r#"{"dimension": 4, "cells": [[0,1,2,3,4],[0,1,2,3,5],[0,1,2,4,5],[0,1,3,4,5],[0,2,3,4,5],[1,2,3,4,5]]}"#;
const METRICS: [&str; 4] = [
    "dimension = 2\ngraph = \"x^2/2 - x^4/12\"\nexact_scalar_curvature = \"2\"\n",
    "dimension = 3\nconformal = \"4/(1 + x^2 + y^2 + z^2)^2\"\n",
    "dimension = 2\ng = [[\"1 + x^2\", \"x*y\"], [\"x*y\", \"1 + y^2\"]]\n",
    "dimension = 2\nembedding = [\"x\", \"y\", \"sin(x)*tanh(y)\"]\n",
];
const LENGTHS: &str = "i,j,length\n0,1,1\n0,2,1.5e0\n0,3,1\n1,2,1\n1,3,1\n2,3,1\n";
const FORMULAS: [&str; 5] = [
    "atan2(y, x) + max(abs(x), y, 1)*min(x, pow(y, 2)) - acosh(2 + hypot(x, y))/sign(x)",
    "-x^2 + 2^-1*sin(x*y)/sqrt(1 + y^2)",
    "((((x))))^(y - 1)",
    "exp(ln(abs(x) + 1))*atan(y)^3",
    "1.5e-3*x1 - .5*x2^2^x",
];
/// What breaks readers: extreme numbers, marks of the formats, bytes that are no text.
const TOKENS: [&[u8]; 22] = [
    b"0",
    b"-1",
    b"1e308",
    b"1e-320",
    b"nan",
    b"inf",
    b"18446744073709551615",
    b"4294967296",
    b"-2147483648",
    b" ",
    b"\n",
    b"\r\n",
    b"\"",
    b",",
    b"(",
    b")",
    b"[",
    b"{",
    b"$EndNodes",
    b"$Nodes\n",
    b"\xff\xfe",
    b"\0",
];

/// A stream of choices, so that a failure can be repeated from its number.
struct Random(SplitMix64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        (self.0.next_u64() % n.max(1) as u64) as usize
    }

    fn range(&mut self, length: usize) -> std::ops::Range<usize> {
        let start = self.below(length + 1);
        let longest = if self.below(4) == 0 { length } else { 16 };
        start..(start + self.below(longest + 1)).min(length)
    }

    /// One change.
    fn change(&mut self, bytes: &mut Vec<u8>, seeds: &[Vec<u8>]) {
        let at = self.range(bytes.len());
        match self.below(8) {
            0 if !bytes.is_empty() => {
                let place = self.below(bytes.len());
                bytes[place] ^= 1 << self.below(8);
            }
            1 => drop(bytes.drain(at)),
            2 => {
                let copy = bytes[at.clone()].to_vec();
                bytes.splice(at.end..at.end, copy);
            }
            3 => bytes.truncate(at.start),
            4 => {
                let other = &seeds[self.below(seeds.len())];
                let part = self.range(other.len());
                bytes.splice(at, other[part].iter().copied());
            }
            5 => {
                // Many times over, up to 1 MiB.
                let copy = bytes[at.clone()].to_vec();
                let times = (1usize << self.below(17)).min((1 << 20) / (copy.len() + 1));
                bytes.splice(at, copy.repeat(times));
            }
            _ => {
                let token = TOKENS[self.below(TOKENS.len())];
                bytes.splice(at, token.iter().copied());
            }
        }
    }
}

/// Runs a reader on mutated seeds.
fn fuzz(name: &str, seeds: &[Vec<u8>], reader: fn(&[u8])) {
    let seconds = std::env::var("REGGE_FUZZ_SECONDS")
        .ok()
        .and_then(|s| s.parse().ok());
    let (start, mut case, mut slowest) = (Instant::now(), 0u64, 0.0f64);
    let more = |case: u64| match seconds {
        Some(seconds) => start.elapsed() < Duration::from_secs(seconds),
        None => case < CASES,
    };
    for seed in seeds {
        reader(seed);
    }
    while more(case) {
        let mut random = Random(SplitMix64::new(case));
        let mut bytes = seeds[random.below(seeds.len())].clone();
        for _ in 0..=random.below(6) {
            random.change(&mut bytes, seeds);
        }
        bytes.truncate(1 << 20);
        let begin = Instant::now();
        let done = std::panic::catch_unwind(|| reader(&bytes));
        let taken = begin.elapsed().as_secs_f64();
        assert!(done.is_ok(), "{name}: case {case} panics");
        assert!(taken < PATIENCE, "{name}: case {case} takes {taken} s");
        slowest = slowest.max(taken);
        case += 1;
    }
    let memory = peak_memory();
    assert!(
        memory.is_none_or(|kib| kib < MEMORY),
        "{name}: {memory:?} KiB"
    );
    println!(
        "{name}: {case} cases, the slowest {slowest:.3} s, memory of the process {memory:?} KiB"
    );
}

/// The largest memory that this process ever had, in KiB, where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

fn seeds(texts: &[&str]) -> Vec<Vec<u8>> {
    texts.iter().map(|text| text.as_bytes().to_vec()).collect()
}

/// The square of MSH_2 as bytes of version 4.1, and two tetrahedra as bytes of 2.2.
fn binary() -> [Vec<u8>; 2] {
    let mut new = b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n".to_vec();
    new.extend([1u64, 3, 1, 3].map(u64::to_le_bytes).concat());
    new.extend([2i32, 1, 0].map(i32::to_le_bytes).concat());
    new.extend([3u64, 1, 2, 3].map(u64::to_le_bytes).concat());
    new.extend(
        [0.0f64, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
            .map(f64::to_le_bytes)
            .concat(),
    );
    new.extend(b"\n$EndNodes\n$Elements\n");
    new.extend([1u64, 1, 1, 1].map(u64::to_le_bytes).concat());
    new.extend([2i32, 1, 2].map(i32::to_le_bytes).concat());
    new.extend([1u64, 1, 1, 2, 3].map(u64::to_le_bytes).concat());
    new.extend(b"\n$EndElements\n");
    let mut old = b"$MeshFormat\n2.2 1 8\n\x01\0\0\0\n$EndMeshFormat\n$Nodes\n4\n".to_vec();
    for (i, x) in [
        [0.0f64, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
    ]
    .iter()
    .enumerate()
    {
        old.extend((i as i32 + 1).to_le_bytes());
        old.extend(x.map(f64::to_le_bytes).concat());
    }
    old.extend(b"\n$EndNodes\n$Elements\n1\n");
    old.extend(
        [4i32, 1, 2, 1, 7, 1, 1, 2, 3, 4]
            .map(i32::to_le_bytes)
            .concat(),
    );
    old.extend(b"\n$EndElements\n");
    [new, old]
}

/// A triangle and its neighbour in the formats of surfaces.
const SURFACES: [&str; 8] = [
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvn 0 0 1\nf 1/1/1 2//1 3\nf -2 -3 \\\n-1\n",
    "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2 255 0 0\n3 2 1 3\n",
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n\
     property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2\n3 2 1 3\n",
    "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty char y\nproperty short z\n\
     element face 1\nproperty list uchar uchar vertex_index\nend_header\n\x01\x02\x03\0\x03\0\0\0",
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
    "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n1 1 1 1\nTriangles 2\n1 2 3 4\n3 2 4 5\nEnd\n",
    "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n\
     CELLS 2 8\n3 0 1 2\n3 2 1 3\nCELL_TYPES 2\n5\n5\n",
    "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\">\
     <Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray></Points>\
     <Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">DAAAAAAAAAABAAAAAgAAAA==</DataArray>\
     <DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>",
];

/// They are valid to begin with, but for the bytes.
#[test]
fn seeds_of_surfaces_are_read() {
    let folder = crate::common::files::folder("seeds");
    for (i, seed) in SURFACES.iter().enumerate().filter(|(i, _)| *i != 3) {
        crate::common::files::write(&folder, "seed", seed);
        let output = crate::common::files::regge(&folder, "--mesh seed");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{i}: {said}");
    }
}

#[test]
fn surface_files() {
    fuzz("surface", &seeds(&SURFACES), trial::mesh);
}

#[test]
fn mesh_files() {
    let mut all = seeds(&[MSH_2, MSH_4, MSH_GROUPS, TETRAHEDRA, JSON, ABSTRACT]);
    all.extend(binary());
    fuzz("mesh", &all, trial::mesh);
}

#[test]
fn metric_files() {
    fuzz("metric", &seeds(&METRICS), trial::metric);
}

#[test]
fn tables_of_lengths() {
    fuzz("lengths", &seeds(&[LENGTHS]), trial::lengths);
}

#[test]
fn formulas() {
    fuzz("expression", &seeds(&FORMULAS), trial::expression);
}

//! Edge lengths from a table `i,j,length`: the coefficients of a Regge function of degree 0.

use super::error::{Fault, InputError, Place, bytes_of};
use regge_curvature::linalg::{Mat, indefinite_pivot, symmetric};
use regge_curvature::mesh::Mesh;
use std::collections::HashMap;
use std::path::Path;

/// How many cells one line names.
const NAMED_CELLS: usize = 50;

/// How flat a cell may be: its least pivot over its largest squared edge. Below, the sign is rounding.
const FLAT: f64 = 1e-13;

/// Reads the squared length of every edge of the mesh, in the mesh's order.
///
/// Vertices are counted from 0 as in the mesh file; the table may begin with a line of names.
///
/// # Errors
/// Names the line with an unknown vertex, an edge that is not there, given twice with other lengths, no positive
/// length; the edge that is missing; all cells that violate the triangle inequality.
pub fn read_lengths<const N: usize>(file: &Path, mesh: &Mesh<N>) -> Result<Vec<f64>, InputError> {
    lengths_from(file, &bytes_of(file)?, mesh)
}

/// [`read_lengths`] of a file that is in memory.
pub(super) fn lengths_from<const N: usize>(
    file: &Path,
    bytes: &[u8],
    mesh: &Mesh<N>,
) -> Result<Vec<f64>, InputError> {
    let squares = parse(bytes, mesh).map_err(|fault| fault.of(file))?;
    match violations(mesh, &squares) {
        None => Ok(squares),
        Some(reason) => Err(InputError::new(file, Place::Whole, reason)),
    }
}

/// The squared lengths, by edges.
fn parse<const N: usize>(bytes: &[u8], mesh: &Mesh<N>) -> Result<Vec<f64>, Fault> {
    let edges: HashMap<(u32, u32), usize> = (0..mesh.count(1))
        .map(|edge| ((mesh.vertices(1, edge)[0], mesh.vertices(1, edge)[1]), edge))
        .collect();
    let mut lengths: Vec<Option<(f64, u64)>> = vec![None; mesh.count(1)];
    let mut reader = csv::ReaderBuilder::new();
    let reader = reader.has_headers(false).flexible(true).comment(Some(b'#'));
    let reader = reader.trim(csv::Trim::All);
    for (row, record) in reader.from_reader(bytes).records().enumerate() {
        let record = record.map_err(|error| {
            let line = error
                .position()
                .map_or(Place::Whole, |at| Place::Line(at.line()));
            Fault::new(line, error.to_string())
        })?;
        let line = record.position().map_or(0, csv::Position::line);
        let fault = |reason: String| Fault::new(Place::Line(line), reason);
        if row == 0 && record.iter().eq(["i", "j", "length"]) {
            continue;
        }
        let ([i, j], length) = entry(&record, mesh.count(0)).map_err(fault)?;
        let Some(&edge) = edges.get(&(i.min(j), i.max(j))) else {
            return Err(fault(format!("{i}-{j} is no edge of the mesh")));
        };
        match lengths[edge] {
            Some((other, first)) if other != length => {
                return Err(fault(format!(
                    "edge {i}-{j} has length {length}, but {other} in line {first}"
                )));
            }
            _ => lengths[edge] = Some((length, line)),
        }
    }
    complete(mesh, &lengths)
}

/// The three fields of a line.
fn entry(record: &csv::StringRecord, vertices: usize) -> Result<([u32; 2], f64), String> {
    let fields: Vec<&str> = record.iter().collect();
    let [i, j, length] = fields[..] else {
        return Err(format!(
            "{} fields where i,j,length are expected",
            fields.len()
        ));
    };
    let vertex = |text: &str| match text.parse::<u32>() {
        Ok(v) if (v as usize) < vertices => Ok(v),
        Ok(v) => Err(format!(
            "vertex {v} does not exist: there are {vertices}, counted from 0"
        )),
        Err(_) => Err(format!("{text:?} is no vertex")),
    };
    let value: f64 = length
        .parse()
        .map_err(|_| format!("{length:?} is no length"))?;
    if !(value > 0.0 && value.is_finite()) {
        return Err(format!(
            "a length must be positive and finite, not {length}"
        ));
    }
    if !(value * value).is_normal() {
        return Err(format!(
            "the square of the length {length} is beyond double precision: give all lengths in another unit"
        ));
    }
    Ok(([vertex(i)?, vertex(j)?], value))
}

fn complete<const N: usize>(
    mesh: &Mesh<N>,
    lengths: &[Option<(f64, u64)>],
) -> Result<Vec<f64>, Fault> {
    let missing: Vec<usize> = (0..lengths.len())
        .filter(|e| lengths[*e].is_none())
        .collect();
    if let Some(&edge) = missing.first() {
        let [a, b] = [mesh.vertices(1, edge)[0], mesh.vertices(1, edge)[1]];
        let reason = format!(
            "edge {a}-{b} has no length; {} of {} edges have none",
            missing.len(),
            lengths.len()
        );
        return Err(Fault::new(Place::Whole, reason));
    }
    Ok(lengths.iter().flatten().map(|(l, _)| l * l).collect())
}

/// All cells that no simplex of ℝ^N has the lengths of.
fn violations<const N: usize>(mesh: &Mesh<N>, squares: &[f64]) -> Option<String> {
    let mut named = Vec::new();
    let mut count = 0;
    for cell in 0..mesh.cell_count() {
        let gram = gram(mesh, squares, cell);
        let scale = (0..N).map(|i| gram[(i, i)]).fold(0.0, f64::max);
        let shifted = gram - Mat::<f64, N>::identity() * (FLAT * scale);
        if indefinite_pivot(&shifted).is_some() {
            count += 1;
            if named.len() < NAMED_CELLS {
                named.push(format!(
                    "cell {cell} {:?} (Cayley-Menger determinant {:e})",
                    mesh.vertices(N, cell),
                    cayley_menger(mesh, squares, cell)
                ));
            }
        }
    }
    let more = match count - named.len() {
        0 => String::new(),
        more => format!(", and {more} more cells"),
    };
    (count > 0).then(|| {
        format!(
            "the triangle inequality is violated in {}{more}",
            named.join(", ")
        )
    })
}

/// The squared length between two corners of a cell.
fn square<const N: usize>(mesh: &Mesh<N>, squares: &[f64], cell: usize, a: usize, b: usize) -> f64 {
    if a == b {
        return 0.0;
    }
    let (a, b) = (a.min(b), a.max(b));
    // The edges 0b, 1b, … stand in lexicographic order.
    let place = a * (2 * N + 1 - a) / 2 + b - a - 1;
    squares[mesh.simplices_of(cell, 1)[place] as usize]
}

/// g_ij = ½(ℓ_0i² + ℓ_0j² − ℓ_ij²).
fn gram<const N: usize>(mesh: &Mesh<N>, squares: &[f64], cell: usize) -> Mat<f64, N> {
    let q = |a, b| square(mesh, squares, cell, a, b);
    symmetric(|i, j| 0.5 * (q(0, i + 1) + q(0, j + 1) - q(i + 1, j + 1)))
}

/// det of the squared lengths bordered by ones: (−1)^(N+1) 2^N (N! volume)².
fn cayley_menger<const N: usize>(mesh: &Mesh<N>, squares: &[f64], cell: usize) -> f64 {
    let bordered = nalgebra::DMatrix::from_fn(N + 2, N + 2, |i, j| match (i, j) {
        (0, 0) => 0.0,
        (0, _) | (_, 0) => 1.0,
        _ => square(mesh, squares, cell, i - 1, j - 1),
    });
    bordered.determinant()
}

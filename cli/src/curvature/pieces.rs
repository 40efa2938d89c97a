//! Curved triangles as many small flat ones, for pictures.

use super::drawn::FlatPiece;
use regge_curvature::spaces::Immersion;
use regge_readers::mesh::MeshFile;

/// More pieces than this make no picture.
const MOST: usize = 50_000;

/// Each curved triangle in s² pieces, s = 3k or as many as are not too many in all; none where cells are straight or no triangles.
pub fn pieces<const N: usize>(map: &Immersion<N>, file: &MeshFile) -> Vec<FlatPiece> {
    if N != 2 || map.degree() == 1 || map.width() != 3 {
        return Vec::new();
    }
    let cells = file.cells.len();
    let most = ((MOST / cells.max(1)) as f64).sqrt() as usize;
    let s = (3 * map.degree()).min(most).max(1);
    let mut all = Vec::with_capacity(cells * s * s);
    for (cell, vertices) in file.cells.iter().enumerate() {
        let points = lattice(map, cell, vertices, s);
        let at = |i: usize, j: usize| points[i * (s + 1) + j];
        for i in 0..s {
            for j in 0..s - i {
                all.push(piece(cell, [at(i, j), at(i + 1, j), at(i, j + 1)]));
                if i + j + 1 < s {
                    all.push(piece(cell, [at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
                }
            }
        }
    }
    all
}

/// Barycentric coordinates, and the place in space.
type Node = ([f64; 3], [f64; 3]);

/// The points λ = (1 − i/s − j/s, i/s, j/s), row by row of s + 1.
fn lattice<const N: usize>(
    map: &Immersion<N>,
    cell: usize,
    vertices: &[usize],
    s: usize,
) -> Vec<Node> {
    // The map has the vertices of a cell ascending.
    let rank = |i: usize| vertices.iter().filter(|v| **v < vertices[i]).count();
    let ranks = [0, 1, 2].map(rank);
    let mut points = vec![([0.0; 3], [0.0; 3]); (s + 1) * (s + 1)];
    for i in 0..=s {
        for j in 0..=s - i {
            let lambda = [s - i - j, i, j].map(|a| a as f64 / s as f64);
            let mut sorted = [0.0; 3];
            for (rank, l) in ranks.iter().zip(lambda) {
                sorted[*rank] = l;
            }
            let x = map.point(cell, &sorted);
            points[i * (s + 1) + j] = (lambda, [x[0], x[1], x[2]]);
        }
    }
    points
}

fn piece(cell: usize, nodes: [Node; 3]) -> FlatPiece {
    let middle = |c: usize| nodes.iter().map(|node| node.0[c]).sum::<f64>() / 3.0;
    FlatPiece {
        cell,
        middle: [0, 1, 2].map(middle),
        corners: nodes.map(|node| node.1),
    }
}

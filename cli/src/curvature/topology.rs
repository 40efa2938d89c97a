//! What can be said of a mesh by counting: its pieces, and vertices around which it is no manifold.

use regge_curvature::mesh::Mesh;
use serde::Serialize;

/// A connected piece of a mesh.
#[derive(Clone, Debug, Serialize)]
pub struct Piece {
    /// Its first cell.
    pub first_cell: usize,
    /// Its cells.
    pub cell_count: usize,
    /// No boundary?
    pub closed: bool,
    /// Σ_k (−1)^k of its k-simplices.
    pub euler_characteristic: i64,
    /// The functional at v = 1 on it.
    pub total_curvature: f64,
    /// Total curvature − 4πχ, for surfaces that are closed or have their boundary terms.
    pub gauss_bonnet_residual: Option<f64>,
}

/// The connected pieces of a mesh, by their first cells, with the totals of a functional that is given by hat functions.
pub fn pieces<const N: usize>(mesh: &Mesh<N>, by_vertex: &[f64]) -> Vec<Piece> {
    let (piece_of, firsts) = components(mesh);
    let piece = |first_cell| Piece {
        first_cell,
        cell_count: 0,
        closed: true,
        euler_characteristic: 0,
        total_curvature: 0.0,
        gauss_bonnet_residual: None,
    };
    let mut pieces: Vec<Piece> = firsts.into_iter().map(piece).collect();
    for k in 0..=N {
        let sign = if k.is_multiple_of(2) { 1 } else { -1 };
        for simplex in 0..mesh.count(k) {
            let piece = &mut pieces[piece_of[mesh.first_side(k, simplex).cell]];
            piece.euler_characteristic += sign;
            if k == 0 {
                piece.total_curvature += by_vertex[simplex];
            }
            if k == N {
                piece.cell_count += 1;
            } else {
                piece.closed &= mesh.is_interior(k, simplex);
            }
        }
    }
    pieces
}

/// The piece of each cell, and the first cell of each piece: cells hang together by faces.
fn components<const N: usize>(mesh: &Mesh<N>) -> (Vec<usize>, Vec<usize>) {
    const NONE: usize = usize::MAX;
    let (mut piece_of, mut firsts) = (vec![NONE; mesh.cell_count()], Vec::new());
    let mut left = Vec::new();
    for first in 0..mesh.cell_count() {
        if piece_of[first] != NONE {
            continue;
        }
        let piece = firsts.len();
        firsts.push(first);
        piece_of[first] = piece;
        left.push(first);
        while let Some(cell) = left.pop() {
            for &face in mesh.simplices_of(cell, N - 1) {
                for side in mesh.star(N - 1, face as usize) {
                    if piece_of[side.cell] == NONE {
                        piece_of[side.cell] = piece;
                        left.push(side.cell);
                    }
                }
            }
        }
    }
    (piece_of, firsts)
}

/// A note on vertices whose link is neither a sphere nor, on the boundary, a ball, as far as the Euler characteristic tells: for
/// N = 3 it tells all. The functional needs faces and hinges only, so that this is not refused.
pub fn odd_links<const N: usize>(mesh: &Mesh<N>) -> Option<String> {
    let mut links = vec![0i64; mesh.count(0)];
    // A k-simplex around a vertex is a (k−1)-simplex of its link.
    for k in 1..=N {
        let sign = if k.is_multiple_of(2) { -1 } else { 1 };
        for simplex in 0..mesh.count(k) {
            for &vertex in mesh.vertices(k, simplex) {
                links[vertex as usize] += sign;
            }
        }
    }
    // χ(S^(N−1)) = 1 + (−1)^(N−1), χ(ball) = 1.
    let sphere = if N.is_multiple_of(2) { 0 } else { 2 };
    let expected = |vertex: usize| {
        if mesh.is_interior(0, vertex) {
            sphere
        } else {
            1
        }
    };
    let mut odd = (0..links.len()).filter(|&v| links[v] != expected(v));
    let first = odd.next()?;
    let more = match odd.count() {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    Some(format!(
        "the mesh is no manifold at vertex {first}{more}: the link there has Euler characteristic {}, not {}; the functional \
         needs faces and hinges only, and is computed",
        links[first],
        expected(first)
    ))
}

//! Hanging nodes: a vertex on the boundary that lies in a boundary face without being a vertex of it.
//!
//! A node that hangs inside the domain makes faces of one cell on both sides of it, so that this finds it as well,
//! and says more than that the cells around it are no manifold.

use nalgebra::{DMatrix, DVector, SVector};

/// How near counts as on a face, relative to the face and to the distance from its corners: a neighbour of a corner in a thin cell
/// is near the face without hanging.
const NEAR: f64 = 1e-9;

/// The first vertex of the boundary that hangs, and the vertices of the face that it lies in.
pub fn hanging<const N: usize>(
    points: &[SVector<f64, N>],
    faces: &[[usize; N]],
) -> Option<(usize, Vec<usize>)> {
    let mut boundary: Vec<usize> = faces.iter().flatten().copied().collect();
    boundary.sort_by(|a, b| points[*a][0].total_cmp(&points[*b][0]).then(a.cmp(b)));
    boundary.dedup();
    for face in faces {
        let corners = face.map(|v| points[v]);
        let (low, high) = frame(&corners);
        let start = boundary.partition_point(|v| points[*v][0] < low[0]);
        let near = boundary[start..].iter();
        for &v in near.take_while(|v| points[**v][0] <= high[0]) {
            let inside = (1..N).all(|i| (low[i]..=high[i]).contains(&points[v][i]));
            if inside && !face.contains(&v) && lies_in(&corners, &points[v]) {
                return Some((v, face.to_vec()));
            }
        }
    }
    None
}

/// The faces of one cell only, each with ascending vertices.
pub fn boundary_faces<const N: usize>(cells: &[Vec<usize>]) -> Vec<[usize; N]> {
    let mut faces: Vec<[usize; N]> = Vec::with_capacity(cells.len() * (N + 1));
    for cell in cells {
        for out in 0..=N {
            let mut face = std::array::from_fn(|i| cell[if i < out { i } else { i + 1 }]);
            face.sort_unstable();
            faces.push(face);
        }
    }
    faces.sort_unstable();
    let runs = faces.chunk_by(|a, b| a == b);
    runs.filter(|run| run.len() == 1)
        .map(|run| run[0])
        .collect()
}

/// The box around a face, a little widened.
fn frame<const N: usize>(corners: &[SVector<f64, N>]) -> (SVector<f64, N>, SVector<f64, N>) {
    let (mut low, mut high) = (corners[0], corners[0]);
    for corner in corners {
        low = low.inf(corner);
        high = high.sup(corner);
    }
    let margin = SVector::repeat(NEAR * (high - low).norm());
    (low - margin, high + margin)
}

/// Is the point in the face? By the least squares solution of x = x_0 + Σ λ_i (x_i − x_0).
fn lies_in<const N: usize>(corners: &[SVector<f64, N>], x: &SVector<f64, N>) -> bool {
    let edge = |i: usize| corners[i + 1] - corners[0];
    let gram = DMatrix::from_fn(N - 1, N - 1, |i, j| edge(i).dot(&edge(j)));
    let off = x - corners[0];
    let right = DVector::from_fn(N - 1, |i, _| edge(i).dot(&off));
    let Some(lambda) = gram.lu().solve(&right) else {
        return false;
    };
    let mut rest = off;
    for i in 0..N - 1 {
        rest -= edge(i) * lambda[i];
    }
    let apart = corners.iter().map(|corner| (x - corner).norm());
    let within = lambda.iter().all(|l| *l >= -NEAR) && lambda.sum() <= 1.0 + NEAR;
    within && rest.norm() <= NEAR * apart.fold(f64::INFINITY, f64::min)
}

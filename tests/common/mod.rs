//! What several test files share.
#![allow(dead_code, reason = "each program uses a part")]

pub mod draw;

use regge_curvature::functional::HessianEntry;
use regge_curvature::mesh::{Mesh, SplitMix64};
use regge_curvature::simplex::{multi_indices, subsets};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};

/// A Regge function near the metric that makes each edge as long as it is in ℝ^N, or 1 on an abstract mesh: every
/// coefficient times 1 + `noise` · (uniform in [−1, 1)). With `noise` ≥ 1 it is a variation rather than a metric.
pub fn random_regge<const N: usize>(
    space: &ReggeSpace<N>,
    noise: f64,
    seed: u64,
) -> ReggeFunction<f64, N> {
    let mesh = space.mesh();
    let mut random = SplitMix64::new(seed);
    let factors: Vec<f64> = (0..space.len())
        .map(|_| 1.0 + noise * random.symmetric())
        .collect();
    let mut coefficients = vec![0.0; space.len()];
    for cell in 0..mesh.cell_count() {
        for (e, edge) in subsets(N + 1, 2).iter().enumerate() {
            let square = match (mesh.corner(cell, edge[0]), mesh.corner(cell, edge[1])) {
                (Some(a), Some(b)) => (a - b).norm_squared(),
                _ => 1.0,
            };
            for alpha in 0..multi_indices(N + 1, space.degree()).len() {
                let dof = space.cell_dof(cell, e, alpha);
                coefficients[dof] = square * factors[dof];
            }
        }
    }
    space
        .function(coefficients)
        .expect("as many coefficients as the space has")
}

/// The cube with `side` cells a side, its inner vertices moved by up to a tenth of a cell.
pub fn crooked_cube<const N: usize>(side: usize, seed: u64) -> Mesh<N> {
    let amplitude = 0.2 / side as f64;
    Mesh::cube(side)
        .and_then(|m| m.perturbed(amplitude, seed))
        .expect("small moves invert nothing")
}

/// The same with the boundary strictly convex. A vertex inside a flat part of the boundary may move outwards without any
/// change of length to first order, which a flat metric does not feel either.
pub fn bulging_cube<const N: usize>(side: usize, seed: u64) -> Mesh<N> {
    let mesh = crooked_cube::<N>(side, seed);
    let points = mesh.points().expect("a cube has coordinates").iter();
    let bulged = points.map(|x| x * (1.0 - 0.1 * x.norm_squared())).collect();
    let cells: Vec<Vec<usize>> = (0..mesh.cell_count())
        .map(|cell| mesh.vertices(N, cell).iter().map(|&v| v as usize).collect())
        .collect();
    Mesh::new(bulged, &cells).expect("rays from the centre are kept")
}

/// The largest absolute value.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}

/// The matrix of these entries, by edges.
pub fn dense<const N: usize>(mesh: &Mesh<N>, entries: &[HessianEntry]) -> nalgebra::DMatrix<f64> {
    let mut matrix = nalgebra::DMatrix::zeros(mesh.count(1), mesh.count(1));
    for entry in entries {
        matrix[(entry.row, entry.column)] += entry.value;
    }
    matrix
}

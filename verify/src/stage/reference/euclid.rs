//! Piecewise flat geometry from edge lengths alone, by another route than the library's: every cell is laid out in
//! ℝ^N by Cholesky's factor of its Gram matrix, angles come from projections, volumes from Gram determinants.

use crate::harness::others;
use crate::stage::fields::Regge;
use regge_curvature::mesh::Mesh;
use regge_curvature::scalar::Real;
use regge_curvature::simplex::{factorial, subsets};

/// An interior hinge S.
#[derive(Clone, Copy, Debug)]
pub struct FlatHinge<T> {
    /// Its number.
    pub hinge: usize,
    /// Θ_S.
    pub defect: T,
    /// V_S.
    pub volume: T,
}

/// Squared edge lengths of a cell: `[i][j]`.
fn squares<T: Real, const N: usize>(g: &Regge<T, N>, cell: usize) -> Vec<Vec<T>> {
    let mut all = vec![vec![T::zero(); N + 1]; N + 1];
    for (edge, length) in subsets(N + 1, 2).iter().zip(g.local(cell)) {
        all[edge[0]][edge[1]] = length;
        all[edge[1]][edge[0]] = length;
    }
    all
}

/// Vectors from the first of these vertices to the others, by Cholesky's factor of their Gram matrix
/// ½(d_0i² + d_0j² − d_ij²).
fn laid_out<T: Real>(squares: &[Vec<T>], vertices: &[usize]) -> Vec<Vec<T>> {
    let (o, n) = (vertices[0], vertices.len() - 1);
    let gram = |i: usize, j: usize| {
        let (a, b) = (vertices[i + 1], vertices[j + 1]);
        (squares[o][a] + squares[o][b] - squares[a][b]) * T::half()
    };
    let mut rows = vec![vec![T::zero(); n]; n];
    for i in 0..n {
        for j in 0..=i {
            let mut sum = gram(i, j);
            for k in 0..j {
                sum -= rows[i][k] * rows[j][k];
            }
            rows[i][j] = if i == j { sum.sqrt() } else { sum / rows[j][j] };
        }
    }
    rows
}

/// The angle at the simplex of all vertices but the last two: with the factor's rows for these, the parts of the
/// last two vectors that are orthogonal to it are (x, 0) and (y, z).
fn dihedral<T: Real>(squares: &[Vec<T>], hinge: &[usize], others: [usize; 2]) -> T {
    let mut order = hinge.to_vec();
    order.extend(others);
    let rows = laid_out(squares, &order);
    let n = rows.len();
    let (y, z) = (rows[n - 1][n - 2], rows[n - 1][n - 1]);
    T::angle(z, y)
}

/// Volume of a simplex: the product of the factor's diagonal over its dimension's factorial. 1 for a point.
fn volume<T: Real>(squares: &[Vec<T>], vertices: &[usize]) -> T {
    let rows = laid_out(squares, vertices);
    let mut product = T::from_f64(1.0 / factorial(rows.len()));
    for (i, row) in rows.iter().enumerate() {
        product *= row[i];
    }
    product
}

/// All interior hinges of a piecewise constant metric.
pub fn hinges<T: Real, const N: usize>(g: &Regge<T, N>) -> Vec<FlatHinge<T>> {
    let mesh: &Mesh<N> = g.space().mesh();
    let places = subsets(N + 1, N - 1);
    let mut all = Vec::new();
    for hinge in mesh.interior_hinges() {
        let (mut defect, mut size) = (T::from_f64(std::f64::consts::TAU), T::one());
        for side in mesh.star(N - 2, hinge) {
            let on = &places[side.place];
            let apart = others(N + 1, on);
            let lengths = squares(g, side.cell);
            defect -= dihedral(&lengths, on, [apart[0], apart[1]]);
            size = volume(&lengths, on);
        }
        all.push(FlatHinge {
            hinge,
            defect,
            volume: size,
        });
    }
    all
}

/// 2Σ Θ_S ∫_S φ_i for every hat function, which has the mean 1/(N−1) on a hinge with N−1 vertices.
pub fn against_hats<const N: usize>(g: &Regge<f64, N>) -> Vec<f64> {
    let mesh: &Mesh<N> = g.space().mesh();
    let mut sums = vec![0.0; mesh.count(0)];
    for h in hinges::<f64, N>(g) {
        let share = 2.0 * h.defect * h.volume / (N - 1) as f64;
        for &v in mesh.vertices(N - 2, h.hinge) {
            sums[v as usize] += share;
        }
    }
    sums
}

//! Gauss–Jacobi rules on [0, 1] with the weight (1−t)^α, by Golub and Welsch.

use nalgebra::{DMatrix, SymmetricEigen};

/// n points t ∈ (0, 1), ascending, and weights with ∫₀¹ (1−t)^α f(t) dt = Σ w f(t) for degrees ≤ 2n−1.
///
/// The points are the eigenvalues of the Jacobi matrix of the recurrence on [−1, 1], made exact by Newton's
/// method on the polynomial; a weight is ∫(1−t)^α over the sum of the squares of the orthonormal polynomials.
pub(super) fn gauss_jacobi(n: usize, alpha: usize) -> (Vec<f64>, Vec<f64>) {
    let a = alpha as f64;
    // Monic recurrence p_{k+1} = (x − d_k) p_k − e_k p_{k−1} for the weight (1−x)^a on [−1, 1].
    let diagonal = |k: f64| {
        let s = 2.0 * k + a;
        if alpha == 0 {
            0.0
        } else {
            -a * a / (s * (s + 2.0))
        }
    };
    let off_diagonal = |k: f64| {
        let s = 2.0 * k + a;
        4.0 * k * k * (k + a) * (k + a) / (s * s * (s + 1.0) * (s - 1.0))
    };
    let d: Vec<f64> = (0..n).map(|k| diagonal(k as f64)).collect();
    let e: Vec<f64> = (1..=n).map(|k| off_diagonal(k as f64)).collect();
    let matrix = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
        0 => d[i],
        1 => e[i.min(j)].sqrt(),
        _ => 0.0,
    });
    let mut nodes: Vec<f64> = SymmetricEigen::new(matrix)
        .eigenvalues
        .iter()
        .copied()
        .collect();
    nodes.sort_by(f64::total_cmp);
    let total = 1.0 / (a + 1.0);
    let weights = nodes
        .iter_mut()
        .map(|x| total * polish(x, &d, &e))
        .collect();
    (nodes.iter().map(|x| 0.5 * (1.0 + x)).collect(), weights)
}

/// Newton's method on p_n from an approximate root; returns the Christoffel number 1/Σ_k p_k²/|p_k|².
fn polish(x: &mut f64, d: &[f64], e: &[f64]) -> f64 {
    let n = d.len();
    let mut christoffel = 1.0;
    for _ in 0..3 {
        // Orthonormal values q_k with their derivatives: b_{k+1} q_{k+1} = (x − d_k) q_k − b_k q_{k−1}, b_k² = e.
        let (mut q, mut dq) = (1.0, 0.0);
        let (mut before, mut d_before) = (0.0, 0.0);
        let mut b_before = 0.0;
        let mut sum = 0.0;
        for k in 0..n {
            sum += q * q;
            let b = e[k].sqrt();
            let next = ((*x - d[k]) * q - b_before * before) / b;
            let d_next = (q + (*x - d[k]) * dq - b_before * d_before) / b;
            (before, d_before, q, dq, b_before) = (q, dq, next, d_next, b);
        }
        *x -= q / dq;
        christoffel = 1.0 / sum;
    }
    christoffel
}

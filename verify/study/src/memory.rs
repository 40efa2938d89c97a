//! How much memory a case takes.

use crate::case::Case;
use crate::study::Study;

/// How many k-simplices the cube's mesh has, k = 0…N, N = 2 or 3.
fn counts(dimension: usize, level: u32) -> Vec<f64> {
    let n = f64::from(1 << level);
    let vertices = (n + 1.0).powi(dimension as i32);
    // Euler's characteristic of a ball is 1.
    match dimension {
        2 => vec![vertices, vertices + 2.0 * n * n - 1.0, 2.0 * n * n],
        _ => {
            let (cells, faces) = (6.0 * n.powi(3), 12.0 * n.powi(3) + 6.0 * n * n);
            vec![vertices, vertices + faces - cells - 1.0, faces, cells]
        }
    }
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k)
        .map(|i| (n as f64 - i as f64) / (i + 1) as f64)
        .product()
}

impl Study {
    /// The memory in bytes that a case takes at its height: 20 to 30 % more than was measured for N = 3, k = 5 (275 and
    /// 889 MiB for r = 0 and 2), 5 % more for N = 2, k = 7, r = 2 (747 MiB).
    ///
    /// By its terms: the mesh with all incidences; the shapes of the cells; g_h with the local projections, or the
    /// functional's sums; what the solver holds.
    pub fn memory(&self, case: Case) -> f64 {
        let (n, p) = (self.dimension, case.degree + 2);
        let counts = counts(n, case.level);
        let cells = counts[n];
        let mesh = cells * if n == 2 { 300.0 } else { 500.0 };
        let shapes = cells * if n == 2 { 250.0 } else { 350.0 };
        let u: f64 = (0..=n).map(|k| counts[k] * binomial(p - 1, k)).sum();
        let slopes = |k: usize| {
            if k + 1 == n {
                binomial(p + n - 2, n - 1)
            } else {
                0.0
            }
        };
        let widths: Vec<f64> = (0..n).map(|k| binomial(p - 1, k) + slopes(k)).collect();
        let unknowns: f64 = (0..n).map(|k| counts[k] * widths[k]).sum();
        let edges = binomial(n + 1, 2);
        let regge = cells * edges * binomial(case.degree + n, n) * 8.0 * 2.0;
        let solver = if n == 3 && unknowns > 15_000.0 {
            let blocks: f64 = (0..n)
                .map(|k| counts[k] * widths[k] * (widths[k] + 1.0) / 2.0)
                .sum();
            let outer: f64 = (0..n).map(|k| binomial(n + 1, k + 1) * widths[k]).sum();
            // Inverse blocks; eight vectors, the load and the solution; a place for each cell's result.
            4.0 * blocks + 8.0 * (8.0 * unknowns + 2.0 * (u + unknowns)) + 8.0 * cells * outer
                // While they are set up the blocks are there in double precision too.
                + (8.0 * blocks - 64.0 * unknowns).max(0.0)
        } else {
            factor(n, unknowns)
        };
        mesh + shapes + regge.max(32.0 * u) + solver + 2e7
    }
}

/// A sparse Cholesky factorisation with its assembly after nested dissection: n log n entries in the plane, with a
/// constant that was measured, n^(4/3) in space, where the direct solver is for small meshes only.
fn factor(n: usize, unknowns: f64) -> f64 {
    8.0 * match n {
        2 => 15.0 * unknowns * unknowns.max(2.0).log2(),
        _ => 12.0 * unknowns.powf(4.0 / 3.0),
    }
}

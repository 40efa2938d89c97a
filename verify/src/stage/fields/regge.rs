//! Random Regge functions: metrics near flat ones, and variations.

use crate::harness::{Draw, pairwise};
use num_dual::Dual64;
use regge_curvature::simplex::{multi_indices, subsets};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};

/// A Regge function with coefficients of type C.
pub type Regge<C, const N: usize> = ReggeFunction<C, N>;

/// The coefficients of the metric that makes each edge as long as it is in ℝ^N, or 1 on a mesh without coordinates,
/// each times 1 + `noise` · (a random number in −1…1). With noise ≥ 1 it is a variation rather than a metric.
pub fn near_flat<const N: usize>(
    space: &ReggeSpace<N>,
    random: &[f64],
    noise: f64,
) -> Regge<f64, N> {
    let mesh = space.mesh();
    let mut coefficients = vec![0.0; space.len()];
    for cell in 0..mesh.cell_count() {
        for (e, edge) in subsets(N + 1, 2).iter().enumerate() {
            let square = match (mesh.corner(cell, edge[0]), mesh.corner(cell, edge[1])) {
                (Some(a), Some(b)) => (a - b).norm_squared(),
                _ => 1.0,
            };
            for alpha in 0..multi_indices(N + 1, space.degree()).len() {
                let dof = space.cell_dof(cell, e, alpha);
                coefficients[dof] = square * (1.0 + noise * random[dof]);
            }
        }
    }
    function(space, coefficients)
}

/// A function of a space by its coefficients.
pub fn function<C: Copy, const N: usize>(
    space: &ReggeSpace<N>,
    coefficients: Vec<C>,
) -> Regge<C, N> {
    space
        .function(coefficients)
        .expect("there are as many coefficients as the space has")
}

/// A random metric. The noise is small: Alfeld's cells in N = 4 are thin, and the sums' integrands are nearer to
/// polynomials.
pub fn metric<const N: usize>(space: &ReggeSpace<N>, draw: &mut Draw) -> Regge<f64, N> {
    wild(space, draw, 1.0)
}

/// A random metric that is so many times as far from a flat one.
pub fn wild<const N: usize>(space: &ReggeSpace<N>, draw: &mut Draw, times: f64) -> Regge<f64, N> {
    let noise = times * [0.03, 0.015, 0.005][N - 2];
    near_flat(space, &draw.numbers(space.len()), noise)
}

/// A random σ, as large as a metric.
pub fn variation<const N: usize>(space: &ReggeSpace<N>, draw: &mut Draw) -> Regge<f64, N> {
    near_flat(space, &draw.numbers(space.len()), 1.0)
}

/// δ, on a mesh with coordinates.
pub fn flat<const N: usize>(space: &ReggeSpace<N>) -> Regge<f64, N> {
    near_flat(space, &vec![0.0; space.len()], 0.0)
}

/// g + t σ to first order in t.
pub fn moving<const N: usize>(g: &Regge<f64, N>, sigma: &Regge<f64, N>) -> Regge<Dual64, N> {
    let (g0, rate) = (g.coefficients(), sigma.coefficients());
    function(g.space(), pairwise(g0, rate, |g, s| Dual64::new(*g, *s)))
}

/// a g + b h, for two functions of one space.
pub fn combination<const N: usize>(
    a: f64,
    g: &Regge<f64, N>,
    b: f64,
    h: &Regge<f64, N>,
) -> Regge<f64, N> {
    let sum = pairwise(g.coefficients(), h.coefficients(), |x, y| a * x + b * y);
    function(g.space(), sum)
}

//! Our side of the comparison with NGSolve: `python3 benches/peer/compare.py` calls it.
//!
//! `ours mesh N k FILE` writes the paper's mesh; `ours functional N k r REPEATS [SCALAR]` times the functional.

use num_dual::Dual64;
use regge::functional::{Rules, distributional_curvature};
use regge::lagrange::Lagrange;
use regge::mesh::Mesh;
use regge::metrics::Metric;
use regge::regge::{Interpolant, ReggeSpace};
use regge::scalar::{Lanes, Lift, Real};
use regge::smooth::Smooth;
use std::time::Instant;

fn mesh<const N: usize>(level: u32) -> Mesh<N> {
    Mesh::<N>::cube(1 << level)
        .and_then(|m| m.perturbed_as_in_paper(level, 3))
        .expect("the paper's mesh")
}

fn functional<T: Real<Sum: Part>, const N: usize>(
    level: u32,
    degree: usize,
    repeats: usize,
    q: usize,
) where
    f64: Lift<T>,
{
    let mesh = mesh::<N>(level);
    let g = Smooth::new(&mesh, Metric::GraphQuartic).expect("coordinates");
    let space = ReggeSpace::new(&mesh, degree);
    let g_h = Interpolant::Canonical {
        order: 2 * degree + 2,
    }
    .apply(&space, &g)
    .expect("a metric");
    let test = Lagrange::new(&mesh, q);
    let rules = Rules::new::<N>(2 * (degree + 2));
    let mut best = f64::INFINITY;
    let mut check = 0.0;
    for _ in 0..repeats {
        let start = Instant::now();
        let sums = distributional_curvature::<T, _, _>(&g_h, &test, &rules);
        best = best.min(start.elapsed().as_secs_f64());
        let total = sums.total();
        check = 0.0;
        for dof in (0..test.len()).filter(|&d| test.vanishes_on_boundary(d)) {
            check += total[dof].part();
        }
    }
    println!(
        "N={N} k={level} r={degree} q={q}: {:.3} us/cell, sum {check:.15e}",
        best * 1e6 / mesh.cells() as f64
    );
}

/// The real part, for a check of what is timed.
trait Part {
    fn part(&self) -> f64;
}

impl Part for f64 {
    fn part(&self) -> f64 {
        *self
    }
}

impl Part for Dual64 {
    fn part(&self) -> f64 {
        self.re
    }
}

fn by_dimension<T: Real<Sum: Part>>(n: usize, level: u32, degree: usize, repeats: usize, q: usize)
where
    f64: Lift<T>,
{
    match n {
        2 => functional::<T, 2>(level, degree, repeats, q),
        _ => functional::<T, 3>(level, degree, repeats, q),
    }
}

fn main() {
    let args: Vec<String> = std::env::args().skip(2).collect();
    let number = |i: usize| args[i].parse::<usize>().expect("a number");
    let (n, level, degree, repeats, q) =
        (number(0), number(1) as u32, number(2), number(3), number(4));
    match args[5].as_str() {
        "f64" => by_dimension::<f64>(n, level, degree, repeats, q),
        "dual" => by_dimension::<Dual64>(n, level, degree, repeats, q),
        _ => by_dimension::<Lanes>(n, level, degree, repeats, q),
    }
}

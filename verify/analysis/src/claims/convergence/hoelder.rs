//! The proof of cor:conv.

use crate::claim::{Claim, Effort};
use crate::distance::Distance;
use crate::families::{gridded, near, smooth};
use crate::finding::Finding;
use crate::rule::Rule;
use crate::series::Series;
use regge_curvature::Error;
use regge_curvature::field::Combination;
use regge_curvature::quadrature::Rule as Quadrature;

/// Hölder's inequality.
pub const A36: Claim = Claim {
    label: "A36",
    paper: &["cor:conv"],
    title: "Hölder's inequality in the proof of the corollary",
    statement: r"\Big(\sum_Th_T^{2j}|g_h-g|_{H^j(T)}^2\Big)^{1/2} \le |\Omega|^{1/2-1/p}\Big(\sum_Th_T^{jp}|g_h-g|_{W^{j,p}(T)}^p\Big)^{1/p},
        \qquad j=0,1,2,\ p\in[2,\infty]",
    how: "Left over right side for the canonical interpolant and its noisy neighbours on random meshes, p = 2, 3, 6 and ∞, j = 0, 1, 2: at most 1, and 1 is \
        reached for p = 2. Of sums with positive weights the inequality is Jensen's, whatever g_h is: what this can refute are the powers of |Ω| and of h_T. Forged: without the power of |Ω|, on (−1, 1)^N.",
    measure: hoelder,
};

/// Left over right side for p = 2, 3, 6, ∞, and without |Ω|, by j.
fn hoelder_on<const N: usize>(side: usize, seed: u64, r: usize) -> Result<[Vec<f64>; 2], Error> {
    let (mesh, _) = gridded::<N>(side, seed)?;
    let (g, rule) = (smooth(&mesh)?, Quadrature::new(N, 6));
    let g_h = near(&g, r, 0.01, seed)?;
    let sigma = Combination::new(-1.0, &g, 1.0, &g_h);
    let volume = 2.0_f64.powi(N as i32);
    let mut all = [Vec::new(), Vec::new()];
    for j in 0..3 {
        let points = Distance::at_points(&mesh, &sigma, &rule, j);
        for p in [2.0, 3.0, 6.0, f64::INFINITY] {
            let mean = |p: f64| -> f64 {
                let sum: f64 = points.iter().map(|(weight, x)| weight * x.powf(p)).sum();
                sum.powf(1.0 / p)
            };
            let right = match p.is_finite() {
                true => mean(p),
                false => points.iter().fold(0.0, |max: f64, (_, x)| max.max(*x)),
            };
            let ratio = mean(2.0) / right;
            all[0].push(ratio / volume.powf(0.5 - 1.0 / p));
            all[1].push(ratio);
        }
    }
    Ok(all)
}

fn hoelder(effort: &Effort) -> Result<Vec<Finding>, Error> {
    let mut all = Vec::new();
    let mut add = |n: usize, r: usize, [stated, without]: [Vec<f64>; 2]| {
        let finding = Finding::new(
            format!("N = {n}, r = {r}"),
            Rule::Sharp(1.0, 0.999),
            Series::samples(stated),
        );
        all.push(finding.forge("no power of |Ω|", Series::samples(without)));
    };
    add(2, 0, hoelder_on::<2>(8, effort.seed, 0)?);
    add(2, 2, hoelder_on::<2>(8, effort.seed, 2)?);
    add(3, 1, hoelder_on::<3>(3, effort.seed, 1)?);
    Ok(all)
}

//! Section 4: inequalities at a point, whose constants are sharp.

use crate::claim::{Claim, Effort};
use crate::finding::Finding;
use crate::local::frame_of;
use crate::rule::Rule;
use crate::series::Series;
use nalgebra::DMatrix;
use regge_curvature::Error;
use regge_curvature::density::{Corner, Normal, outward};
use regge_curvature::formulas::PAPER;
use regge_curvature::linalg::{Mat, Vector, identity, inverse_and_det, symmetric, vector};
use regge_curvature::mesh::SplitMix64;

/// Samples a run.
fn samples(effort: &Effort) -> usize {
    if effort.quick { 500 } else { 20_000 }
}

/// The eigenvalues of a symmetric matrix.
fn eigenvalues<const N: usize>(a: &Mat<f64, N>) -> Vec<f64> {
    let a = DMatrix::from_fn(N, N, |i, j| a[(i, j)]);
    a.symmetric_eigenvalues().iter().copied().collect()
}

/// The greatest of a list.
fn greatest(list: &[f64]) -> f64 {
    list.iter().fold(f64::NEG_INFINITY, |max, x| max.max(*x))
}

/// A positive definite matrix whose eigenvalues are up to e^{±spread}: (1 + A)ᵀ D (1 + A).
fn random_metric<const N: usize>(random: &mut SplitMix64, spread: f64) -> Mat<f64, N> {
    let scales: Vector<f64, N> = vector(|_| (spread * random.symmetric()).exp());
    let turn = Mat::<f64, N>::from_fn(|i, j| f64::from(u8::from(i == j)) + random.symmetric());
    let g = turn.transpose() * Mat::from_diagonal(&scales) * turn;
    symmetric(|i, j| 0.5 * (g[(i, j)] + g[(j, i)]))
}

/// A symmetric matrix with entries up to `size`.
fn random_tensor<const N: usize>(random: &mut SplitMix64, size: f64) -> Mat<f64, N> {
    symmetric(|_, _| size * random.symmetric())
}

/// lemma:ndiff and eq. (ndiffLinf).
pub const A09: Claim = Claim {
    label: "A09",
    paper: &["lemma:ndiff", "ndiffLinf"],
    title: "The unit normals of two metrics, with the best constant",
    statement: r"|n_{g_1} - n_{g_2}| \le \mu^{3/2}|g_1 - g_2|,\qquad \mu = \max(|g_1^{-1}|,|g_2^{-1}|)",
    how: "Spectral norms. The constant follows from lemma:ndot: along the segment |ṅ|_g ≤ |σ|_g, and a length in g is at least \
        μ^{-1/2} times the Euclidean one. Normals by the library: at random metrics, near and far; and where it is attained, \
        g_1 = δ/μ and g_2 − g_1 small and off the diagonal. The lemma says that there is a constant.",
    measure: normals,
};

/// |n_1 − n_2| over μ^{3/2} |g_1 − g_2|, in spectral norms, for the normal of {x_1 = 0}.
fn normals_ratio<const N: usize>(g: [&Mat<f64, N>; 2]) -> f64 {
    let normal = |g: &Mat<f64, N>| {
        let (inverse, det) = inverse_and_det(g);
        let nu: Vector<f64, N> = outward(1);
        Normal::new(&PAPER, &inverse, det, &nu).n
    };
    let least = |g: &Mat<f64, N>| -greatest(&eigenvalues(&-g));
    let mu = 1.0 / least(g[0]).min(least(g[1]));
    let sizes: Vec<f64> = eigenvalues(&(g[0] - g[1]))
        .iter()
        .map(|x| x.abs())
        .collect();
    (normal(g[0]) - normal(g[1])).norm() / (mu.powf(1.5) * greatest(&sizes))
}

fn normals_in<const N: usize>(effort: &Effort) -> Finding {
    let mut random = SplitMix64::new(effort.seed + N as u64);
    let mut ratios = vec![0.0];
    for _ in 0..samples(effort) {
        let one = random_metric::<N>(&mut random, 1.0);
        // Near and far: sizes from 10⁻³ to 1 of the least eigenvalue and beyond.
        let size = 10f64.powf(1.5 * random.symmetric() - 1.5);
        let two = one + random_tensor(&mut random, size);
        if frame_of(&two).is_some() && frame_of(&one).is_some() {
            ratios[0] = f64::max(ratios[0], normals_ratio([&one, &two]));
        }
    }
    for size in [1e-1, 1e-2, 1e-3] {
        let one = identity::<f64, N>() * 3.0;
        let off = |i: usize, j: usize| if (i, j) == (0, 1) { size } else { 0.0 };
        ratios.push(normals_ratio([&one, &(one + symmetric(off))]));
    }
    Finding::new(
        format!("N = {N}"),
        Rule::Sharp(1.0, 0.99),
        Series::samples(ratios),
    )
}

fn normals(effort: &Effort) -> Result<Vec<Finding>, Error> {
    Ok(vec![
        normals_in::<2>(effort),
        normals_in::<3>(effort),
        normals_in::<4>(effort),
    ])
}

/// eq. (ThetaSbound), cell by cell.
pub const A10: Claim = Claim {
    label: "A10",
    paper: &["ThetaSbound"],
    title: "The dihedral angles of two metrics, with the best constant",
    statement: r"|\theta_{ST}(g_h) - \theta_{ST}(g)| \le \tfrac12\ln\frac{\lambda_{\max}(g^{-1}g_h)}{\lambda_{\min}(g^{-1}g_h)},
        \qquad |\Theta_S(g_h)| \le \sum_{T\supset S}|\theta_{ST}(g_h) - \theta_{ST}(g)|",
    how: "By lemma:angledot the angle changes by at most half the difference of the greatest and the least eigenvalue of σ in g̃(t); \
        integrated over t that is the right side. No angle enters: neither lemma:anglebound nor the lemma after it is needed. \
        Angles by the library: at random pairs of metrics, and where the constant is attained, for a right angle and σ that is \
        small and off the diagonal. The right side is at most C |g_h − g|, which is the paper's bound.",
    measure: angles,
};

/// |θ(g_h) − θ(g)| over ½ ln λ_max/λ_min, for the reference simplex' angle between its faces 1 and 2.
fn angle_ratio<const N: usize>(g: &Mat<f64, N>, g_h: &Mat<f64, N>) -> Option<f64> {
    let angle = |g: &Mat<f64, N>| {
        let (inverse, det) = inverse_and_det(g);
        let nu: [Vector<f64, N>; 2] = [outward(1), outward(2)];
        Corner::new(&PAPER, &inverse, det, [&nu[0], &nu[1]]).angle()
    };
    let frame = frame_of(g)?;
    frame_of(g_h)?;
    let relative = eigenvalues(&(frame.transpose() * g_h * frame));
    let least = relative.iter().fold(f64::INFINITY, |min, x| min.min(*x));
    let bound = 0.5 * (greatest(&relative) / least).ln();
    Some((angle(g_h) - angle(g)).abs() / bound)
}

fn angles_in<const N: usize>(effort: &Effort) -> Finding {
    let mut random = SplitMix64::new(effort.seed + 10 + N as u64);
    let mut ratios = vec![0.0];
    for _ in 0..samples(effort) {
        let g = random_metric::<N>(&mut random, 1.0);
        let size = 10f64.powf(1.5 * random.symmetric() - 1.5);
        let g_h = g + random_tensor(&mut random, size);
        ratios[0] = f64::max(ratios[0], angle_ratio(&g, &g_h).unwrap_or(0.0));
    }
    for size in [1e-1, 1e-2, 1e-3] {
        let delta = identity::<f64, N>();
        let off = |i: usize, j: usize| if (i, j) == (0, 1) { size } else { 0.0 };
        ratios.extend(angle_ratio(&delta, &(delta + symmetric(off))));
    }
    Finding::new(
        format!("N = {N}"),
        Rule::Sharp(1.0, 0.99),
        Series::samples(ratios),
    )
}

fn angles(effort: &Effort) -> Result<Vec<Finding>, Error> {
    Ok(vec![
        angles_in::<2>(effort),
        angles_in::<3>(effort),
        angles_in::<4>(effort),
    ])
}

/// lemma:anglebound.
pub const A11: Claim = Claim {
    label: "A11",
    paper: &["lemma:anglebound"],
    title: "The constant 2 in the bound of dihedral angles is the best one",
    statement: r"\sin\theta_{ST} \ge \frac{2\rho_T}{h_T}",
    how: "2ρ/(h sin θ), over random simplices, and along a family of slender ones: a small hinge at distance 1 of a \
        much smaller edge. 2.0001 for 2 is refuted for N = 2, 2.0008 for N = 3 and 4, where rounding in sin² θ sets the limit. Dihedral angles by the library, ρ and h from the lengths of dλ_f and of edges.",
    measure: slender,
};

/// 2ρ/(h sin θ) for the angle of the reference simplex between its faces 0 and 1, and the least of all its angles' sines.
fn shape_ratio<const N: usize>(g: &Mat<f64, N>) -> f64 {
    let (inverse, det) = inverse_and_det(g);
    let nu: Vec<Vector<f64, N>> = (0..=N).map(outward).collect();
    // 1/|dλ_f| is the height over the face f, and 1/ρ is the sum of the reciprocal heights.
    let heights = nu
        .iter()
        .map(|nu| (nu.transpose() * inverse * nu)[0].sqrt());
    let inradius = 1.0 / heights.sum::<f64>();
    let (mut diameter, mut sine) = (0.0_f64, 1.0_f64);
    for a in 0..=N {
        for b in 0..a {
            let (sin, cos) = Corner::new(&PAPER, &inverse, det, [&nu[a], &nu[b]]).dihedral();
            sine = sine.min(sin / sin.hypot(cos));
            let at = |v: usize, k: usize| f64::from(u8::from(k + 1 == v));
            let edge: Vector<f64, N> = vector(|k| at(a, k) - at(b, k));
            diameter = diameter.max((edge.transpose() * g * edge)[0].sqrt());
        }
    }
    2.0 * inradius / (diameter * sine)
}

/// A vertex, from it an edge of length b, and, orthogonal to it at distance 1, a hinge with edges of length q.
fn slender_metric<const N: usize>(q: f64, b: f64) -> Mat<f64, N> {
    let edges: [Vector<f64, N>; N] = std::array::from_fn(|i| {
        vector(|k| match i {
            0 if k == 0 => b,
            0 => 0.0,
            // Towards the hinge, and to its other vertices, along axes of their own.
            _ if k == 1 => 1.0,
            _ if i >= 2 && k == i => q,
            _ => 0.0,
        })
    });
    symmetric(|i, j| edges[i].dot(&edges[j]))
}

/// Sizes q and b of slender simplices. The ratio falls short of 1 by about b/q + q²/2, and rounding in sin²θ ≈ b² keeps b from
/// being much smaller; for N = 2 there is no q, and the shortfall is b.
const SLENDER: [(f64, f64); 4] = [(0.3, 1e-2), (0.1, 1e-3), (0.03, 1e-4), (0.014, 1.8e-6)];

/// For N = 2 there is no q, and the shortfall is about b.
const FLAT: [(f64, f64); 4] = [(0.0, 1e-2), (0.0, 1e-3), (0.0, 1e-4), (0.0, 2e-5)];

fn slender_in<const N: usize>(effort: &Effort) -> Finding {
    let mut random = SplitMix64::new(effort.seed + 20 + N as u64);
    let mut ratios = vec![0.0];
    for _ in 0..samples(effort) {
        ratios[0] = f64::max(
            ratios[0],
            shape_ratio(&random_metric::<N>(&mut random, 2.0)),
        );
    }
    let (family, share) = match N {
        2 => (&FLAT, 1.0 / 1.000_05),
        _ => (&SLENDER, 1.0 / 1.000_4),
    };
    ratios.extend(
        family
            .iter()
            .map(|&(q, b)| shape_ratio(&slender_metric::<N>(q, b))),
    );
    Finding::new(
        format!("N = {N}"),
        Rule::Sharp(1.0, share),
        Series::samples(ratios),
    )
}

fn slender(effort: &Effort) -> Result<Vec<Finding>, Error> {
    Ok(vec![
        slender_in::<2>(effort),
        slender_in::<3>(effort),
        slender_in::<4>(effort),
    ])
}

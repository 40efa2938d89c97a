//! Floor 5. Metrics by formula: the paper's graphs, spaces of constant curvature, a generic one.

mod smooth;

pub use smooth::{AffineMap, Smooth, SmoothTensor};

use crate::linalg::{Mat, symmetric};
use crate::scalar::Real;

/// The metrics that the command line knows by name, in any dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Metric {
    /// δ.
    Flat,
    /// The graph of f = Σ x²/2 − x⁴/12: I + ∇f ⊗ ∇f. Paper: section 5.
    GraphQuartic,
    /// 4/(1+|x|²)² δ: the unit sphere, R = N(N−1).
    Sphere,
    /// 4/(1−|x|²/ρ²)² δ with ρ² = 4N: hyperbolic space as the ball |x| < ρ, R = −N(N−1)/ρ².
    Hyperbolic,
    /// g_ii = 1 + 0.15 sin(1.5 x_i + 0.6 i), g_ij = 0.09 sin(x_i + x_j/2 + 0.3(i+j)) for i < j, indices from 0.
    Trig,
}

impl Metric {
    /// All of them, by name.
    pub const ALL: [(&'static str, Self); 5] = [
        ("flat", Self::Flat),
        ("graph-quartic", Self::GraphQuartic),
        ("conformal-sphere", Self::Sphere),
        ("hyperbolic", Self::Hyperbolic),
        ("trig", Self::Trig),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|m| m.1 == self).map_or("?", |m| m.0)
    }

    /// R where a closed form is known; of the graph from the paper, section 5, in any dimension N ≥ 2.
    pub fn scalar_curvature<const N: usize>(self, x: &[f64; N]) -> Option<f64> {
        let n = N as f64;
        match self {
            Self::Flat => Some(0.0),
            Self::Sphere => Some(n * (n - 1.0)),
            Self::Hyperbolic => Some(-n * (n - 1.0) / hyperbolic_square::<N>()),
            Self::GraphQuartic => Some(graph_curvature(x)),
            Self::Trig => None,
        }
    }
}

/// ρ²: the ball |x| < ρ holds the cube [−1, 1]^N with room to spare.
fn hyperbolic_square<const N: usize>() -> f64 {
    4.0 * N as f64
}

/// With f_i = x_i − x_i³/3 and k_i = f_ii = 1 − x_i²: the graph's second form is Hess f/√(1+|∇f|²), and Gauss'
/// equation gives R = Σ_{i≠j} k_i k_j (1 + |∇f|² − f_i² − f_j²)/(1 + |∇f|²)².
fn graph_curvature<const N: usize>(x: &[f64; N]) -> f64 {
    let f = x.map(|x| x - x * x * x / 3.0);
    let k = x.map(|x| 1.0 - x * x);
    let w = 1.0 + f.iter().map(|f| f * f).sum::<f64>();
    let mut sum = 0.0;
    for i in 0..N {
        for j in (0..N).filter(|&j| j != i) {
            sum += k[i] * k[j] * (w - f[i] * f[i] - f[j] * f[j]);
        }
    }
    sum / (w * w)
}

impl<const N: usize> SmoothTensor<N> for Metric {
    fn contains(&self, x: &[f64; N]) -> bool {
        let square: f64 = x.iter().map(|x| x * x).sum();
        *self != Self::Hyperbolic || square < hyperbolic_square::<N>()
    }

    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        let c = S::from_f64;
        let delta = |i: usize, j: usize| if i == j { S::one() } else { S::zero() };
        let square = || {
            let mut sum = S::zero();
            for x in x {
                sum += *x * *x;
            }
            sum
        };
        match self {
            Self::Flat => symmetric(delta),
            Self::GraphQuartic => {
                let f = x.map(|x| x - x * x * x * S::ratio(1, 3));
                symmetric(|i, j| delta(i, j) + f[i] * f[j])
            }
            Self::Sphere => conformal(S::one() + square()),
            Self::Hyperbolic => conformal(S::one() - square() * c(1.0 / hyperbolic_square::<N>())),
            Self::Trig => symmetric(|i, j| {
                let (a, b) = (i as f64, j as f64);
                if i == j {
                    S::one() + c(0.15) * (c(1.5) * x[i] + c(0.6 * a)).sin()
                } else {
                    c(0.09) * (x[i] + x[j] * S::half() + c(0.3 * (a + b))).sin()
                }
            }),
        }
    }
}

/// 4/w² δ.
fn conformal<S: Real, const N: usize>(w: S) -> Mat<S, N> {
    let factor = S::from_int(4) / (w * w);
    symmetric(|i, j| if i == j { factor } else { S::zero() })
}

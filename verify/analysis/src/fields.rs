//! Floor 0. The smooth metrics of these measurements, and one that is not.

use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::metrics::SmoothTensor;
use regge_curvature::scalar::Real;

/// A metric on ℝ^N/2ℤ^N.
#[derive(Clone, Copy, Debug)]
pub struct Waves;

impl<const N: usize> SmoothTensor<N> for Waves {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        let wave = |size: f64, y: S, phase: f64| {
            S::from_f64(size) * (S::from_f64(std::f64::consts::PI) * y + S::from_f64(phase)).sin()
        };
        symmetric(|i, j| match i == j {
            true => S::one() + wave(0.15, x[i], 0.6 * i as f64),
            false => wave(0.06, x[i] + x[j], 0.3 * (i + j) as f64),
        })
    }
}

/// A metric on (−1, 1)^N that is flat near the boundary, to so high an order that its curvature vanishes there.
#[derive(Clone, Copy, Debug)]
pub struct Dome;

impl<const N: usize> SmoothTensor<N> for Dome {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        let bump = x.iter().fold(S::one(), |product, x| {
            let factor = S::one() - *x * *x;
            product * factor * factor * factor * factor
        });
        symmetric(|i, j| match i == j {
            true => S::one() + bump * (S::from_f64(0.4) + S::from_f64(0.2) * x[(i + 1) % N]),
            false => bump * (S::from_f64(0.15) + S::from_f64(0.1) * x[i]),
        })
    }
}

/// δ times 1 + |x|^α/4 with a half-integer α, and what makes it no conformal metric: not smooth at 0.
#[derive(Clone, Copy, Debug)]
pub struct Pointed {
    /// α = k + 1/2.
    pub k: usize,
}

impl<const N: usize> SmoothTensor<N> for Pointed {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        // Differentiable at 0, where nothing but an upper bound is looked at.
        let tiny = S::from_f64(1e-24);
        let radius = x.iter().fold(tiny, |sum, x| sum + *x * *x).sqrt();
        let power = (0..self.k).fold(radius.sqrt(), |power, _| power * radius);
        symmetric(|i, j| match i == j {
            true => S::one() + power * S::from_f64(0.25 + 0.1 * i as f64),
            false => power * S::from_f64(0.1),
        })
    }
}

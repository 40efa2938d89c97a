//! Formulas on a small random patch.

use crate::harness::Draw;
use regge_curvature::linalg::Mat;
use regge_curvature::metrics::{Metric, SmoothTensor};
use regge_curvature::scalar::Real;

/// A formula at a third of the coordinates, around a random point: one cell sees little of it, and rules of moderate
/// order integrate to rounding.
#[derive(Clone, Copy, Debug)]
pub struct Patch<const N: usize> {
    formula: Metric,
    origin: [f64; N],
}

impl<const N: usize> Patch<N> {
    /// Around a point with coordinates in −½…½.
    pub fn new(formula: Metric, draw: &mut Draw) -> Self {
        let x = draw.numbers(N);
        Self {
            formula,
            origin: std::array::from_fn(|k| 0.5 * x[k]),
        }
    }
}

impl<const N: usize> SmoothTensor<N> for Patch<N> {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        let third = S::ratio(1, 3);
        let shifted = |k: usize| x[k] * third + S::from_f64(self.origin[k]);
        self.formula.at(&std::array::from_fn(shifted))
    }
}

//! Random test functions.

use crate::harness::Draw;
use regge_curvature::spaces::Lagrange;

/// The coefficients of a random function that vanishes on the boundary.
pub fn test_function<const N: usize>(space: &Lagrange<N>, draw: &mut Draw) -> Vec<f64> {
    let mut v = draw.numbers(space.len());
    for (dof, c) in v.iter_mut().enumerate() {
        if !space.vanishes_on_boundary(dof) {
            *c = 0.0;
        }
    }
    v
}

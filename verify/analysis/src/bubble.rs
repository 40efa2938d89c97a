//! Floor 1. One function of H²_0, a polynomial on all of the cube, and its norm.

use regge_curvature::jet::Jet2;
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::scalar::Real;

/// Π(1 − x_i²)² (1 + 0.3 x_1 + 0.2 x_2), which is in H²_0.
pub fn bubble<S: Real, const N: usize>(x: &[S; N]) -> S {
    let tilt = S::one() + S::from_f64(0.3) * x[0] + S::from_f64(0.2) * x[1];
    x.iter().fold(tilt, |product, x| {
        let factor = S::one() - *x * *x;
        product * factor * factor
    })
}

/// Its norm in H²((−1, 1)^N): a polynomial of degree 10 in each variable at most, squared.
pub fn bubble_norm<const N: usize>() -> f64 {
    let (points, weights) = gauss_legendre(11);
    let mut square = 0.0;
    for mut index in 0..points.len().pow(N as u32) {
        let mut weight = 1.0;
        let at: [Jet2<f64, N>; N] = std::array::from_fn(|i| {
            let digit = index % points.len();
            index /= points.len();
            weight *= 2.0 * weights[digit];
            Jet2::coordinate(2.0 * points[digit] - 1.0, i)
        });
        let v = bubble(&at);
        let first: f64 = v.d.iter().map(|x| x * x).sum();
        let second: f64 = v.dd.iter().flatten().map(|x| x * x).sum();
        square += weight * (v.value * v.value + first + second);
    }
    square.sqrt()
}

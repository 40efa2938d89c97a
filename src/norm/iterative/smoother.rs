//! Some steps of Richardson's iteration with an approximate inverse J of an operator A: the smoother of the cycles.
//!
//! The step's weights are those that are best within a cycle. With t an eigenvalue of J A by the largest, and p(t) the factor by
//! which the steps together multiply an error there, a cycle leaves at most C / (C + 1/E) of an error, where C says how good the coarse
//! correction is and E = max t p² / (1 − p²) over 0 < t ≤ 1 (J. Lottes, Optimal polynomial smoothers for multigrid V-cycles,
//! Numerical Linear Algebra with Applications 30, 2023). No least eigenvalue enters, as it does where max |p| over an interval is
//! made small.

use super::cg::{axpy, combine, dot, scale};
use super::number::Number;
use crate::mesh::SplitMix64;
use nalgebra::DMatrix;
use std::f64::consts::FRAC_PI_2;

/// How many steps of Lanczos' method find the largest eigenvalue, and what is added to what they find, which is too low. To end when
/// a step raises it by less than 0.5 % was tried: that of a flat cell shows late, and without it the preconditioner is indefinite.
const LANCZOS_STEPS: usize = 15;
const MARGIN: f64 = 1.1;
/// Lanczos' method ends when what is left of its vectors is rounding.
const EXHAUSTED: f64 = 1e-20;

/// What can be smoothed.
pub(super) trait Smoothed: Sized {
    /// What it computes with.
    type Number: Number;
    /// What an application of A overwrites.
    type Room;

    fn room(&self) -> Self::Room;

    /// How many unknowns.
    fn len(&self) -> usize;

    /// y = A x.
    fn apply(&self, x: &[Self::Number], y: &mut [Self::Number], room: &mut Self::Room);

    /// z = J r.
    fn invert(&self, r: &[Self::Number], z: &mut [Self::Number]);

    /// residual −= A correction.
    fn subtract_image(&self, room: &mut Room<Self>);

    /// residual −= A correction, correction = ω J residual and z += correction.
    fn step(&self, weight: f64, z: &mut [Self::Number], room: &mut Room<Self>);
}

/// Some steps of the iteration.
#[derive(Clone, Debug)]
pub(super) struct Smoother {
    /// What the steps multiply J r by.
    weights: Vec<f64>,
}

/// Vectors that a cycle works with.
pub(super) struct Room<S: Smoothed> {
    pub residual: Vec<S::Number>,
    pub correction: Vec<S::Number>,
    /// What an application of A overwrites.
    pub operator: S::Room,
}

impl<S: Smoothed> Room<S> {
    pub fn new(smoothed: &S) -> Self {
        let zero = vec![S::Number::ZERO; smoothed.len()];
        Self {
            residual: zero.clone(),
            correction: zero,
            operator: smoothed.room(),
        }
    }
}

impl Smoother {
    pub fn new<S: Smoothed>(steps: usize, smoothed: &S) -> Self {
        let largest = MARGIN * largest_eigenvalue(smoothed);
        Self {
            weights: weights(steps).map(|weight| weight / largest).collect(),
        }
    }

    /// z = S r for the residual r, which becomes that of z.
    pub fn begin<S: Smoothed>(&self, smoothed: &S, z: &mut [S::Number], room: &mut Room<S>) {
        let (first, others) = self.weights.split_first().expect("a smoother has steps");
        smoothed.invert(&room.residual, z);
        scale(z, *first);
        room.correction.copy_from_slice(z);
        for &weight in others {
            smoothed.step(weight, z, room);
        }
        smoothed.subtract_image(room);
    }

    /// Smooths z + correction; the residual is still that of z, and is not wanted any more.
    pub fn end<S: Smoothed>(&self, smoothed: &S, z: &mut [S::Number], room: &mut Room<S>) {
        axpy(z, 1.0, &room.correction);
        for &weight in &self.weights {
            smoothed.step(weight, z, room);
        }
    }
}

/// The reciprocals of the zeros of p. T_(2k+1)(s)/s is a polynomial of degree k in s²; with s² = e² + (1 − e²) t, where e is the least
/// place at which |T_(2k+1)| is 1, and scaled to 1 at t = 0 it is p: t p² / (1 − p²) ≤ E = e²/(1 − e²) is |T_(2k+1)(s)| ≤ 1, and is
/// attained k + 1 times.
///
/// Small weights and large ones take turns: with up to eight steps the first of them together amplify nothing by more than 2k, nor do
/// the last of them, which is what rounding sees.
fn weights(steps: usize) -> impl Iterator<Item = f64> {
    let zeros = (2 * steps + 1) as f64;
    let squared = move |i: usize| (FRAC_PI_2 * i as f64 / zeros).cos().powi(2);
    let least = squared(2 * steps);
    let places = (0..steps).map(move |i| match i % 2 {
        0 => i / 2,
        _ => steps - 1 - i / 2,
    });
    places.map(move |i| (1.0 - least) / (squared(2 * i + 1) - least))
}

/// The largest eigenvalue of J A, nearly, and not above it; 1 where nothing is free. The coefficients of conjugate gradients are
/// Lanczos' tridiagonal matrix.
fn largest_eigenvalue<S: Smoothed>(smoothed: &S) -> f64 {
    let mut random = SplitMix64::new(1);
    let random = (0..smoothed.len()).map(|_| S::Number::of(random.symmetric()));
    let mut r: Vec<_> = random.collect();
    let (mut z, mut q) = (r.clone(), r.clone());
    let mut room = smoothed.room();
    smoothed.invert(&r, &mut z);
    let mut p = z.clone();
    let mut square = dot(&r, &z);
    let first = square;
    let mut matrix = DMatrix::zeros(LANCZOS_STEPS, LANCZOS_STEPS);
    let mut found = 0;
    for step in 0..LANCZOS_STEPS {
        if square <= EXHAUSTED * first {
            break;
        }
        smoothed.apply(&p, &mut q, &mut room);
        let inverse = dot(&p, &q) / square;
        axpy(&mut r, -1.0 / inverse, &q);
        smoothed.invert(&r, &mut z);
        let beta = dot(&r, &z) / square;
        matrix[(step, step)] += inverse;
        if step + 1 < LANCZOS_STEPS {
            matrix[(step + 1, step + 1)] = beta * inverse;
            matrix[(step, step + 1)] = -beta.max(0.0).sqrt() * inverse;
            matrix[(step + 1, step)] = matrix[(step, step + 1)];
        }
        combine(beta, &mut p, 1.0, &z);
        square *= beta;
        found = step + 1;
    }
    match found {
        0 => 1.0,
        _ => matrix
            .view((0, 0), (found, found))
            .symmetric_eigenvalues()
            .max(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// t p² / (1 − p²) rises to E = tan²(π / (4k + 2)) at both ends and at k − 1 places between them, and never above; and the
    /// first and the last steps amplify by 2k at most.
    #[test]
    fn weights_are_the_best() {
        for k in 1..=8_usize {
            let weights: Vec<f64> = weights(k).collect();
            let largest = (std::f64::consts::PI / (4 * k + 2) as f64).tan().powi(2);
            let at = |t: f64| {
                let p: f64 = weights.iter().map(|weight| 1.0 - weight * t).product();
                t * p * p / (1.0 - p * p)
            };
            let values: Vec<f64> = (1..=20_000).map(|i| at(f64::from(i) / 2e4)).collect();
            let peak = |i: usize| values[i] >= values[i - 1] && values[i] >= values[i + 1];
            let peaks: Vec<f64> = (1..values.len() - 1)
                .filter(|&i| peak(i))
                .map(|i| values[i])
                .collect();
            assert_eq!(peaks.len(), k - 1, "{k} steps");
            // At t = 0 it is 1 / (2 Σ ω).
            let ends = [0.5 / weights.iter().sum::<f64>(), at(1.0)];
            for peak in peaks.iter().chain(&ends) {
                assert!(
                    (peak / largest - 1.0).abs() < 1e-5,
                    "{k} steps: {peak}, {largest}"
                );
            }
            for split in 0..k {
                for i in 0..=100 {
                    let factor = |weight: &f64| 1.0 - weight * f64::from(i) / 100.0;
                    let (first, last) = weights.split_at(split);
                    let product = |some: &[f64]| some.iter().map(factor).product::<f64>();
                    assert!(product(first).abs().max(product(last).abs()) <= 2.0 * k as f64);
                }
            }
        }
    }
}

//! Chebyshev's iteration with an approximate inverse J of an operator A: the smoother of the cycles.

use super::cg::{axpy, combine, dot, scale};
use super::number::Number;
use crate::mesh::SplitMix64;
use nalgebra::DMatrix;

/// How many steps of Lanczos' method find the largest eigenvalue, and what is added to what they find, which is too low.
const LANCZOS_STEPS: usize = 15;
const MARGIN: f64 = 1.1;
/// Lanczos' method ends when what is left of its vectors is rounding.
const EXHAUSTED: f64 = 1e-20;

/// What can be smoothed.
pub(super) trait Smoothed {
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
}

/// Some steps of the iteration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chebyshev {
    steps: usize,
    /// The largest eigenvalue over the least that is smoothed.
    ratio: f64,
    /// The largest eigenvalue of J A.
    largest: f64,
}

/// Vectors that a cycle works with.
pub(super) struct Room<S: Smoothed> {
    pub residual: Vec<S::Number>,
    pub correction: Vec<S::Number>,
    image: Vec<S::Number>,
    operator: S::Room,
}

impl<S: Smoothed> Room<S> {
    pub fn new(smoothed: &S) -> Self {
        let zero = vec![S::Number::ZERO; smoothed.len()];
        Self {
            residual: zero.clone(),
            correction: zero.clone(),
            image: zero,
            operator: smoothed.room(),
        }
    }

    /// residual −= A correction.
    pub fn subtract_image(&mut self, smoothed: &S) {
        smoothed.apply(&self.correction, &mut self.image, &mut self.operator);
        axpy(&mut self.residual, -1.0, &self.image);
    }
}

impl Chebyshev {
    pub fn new<S: Smoothed>(steps: usize, ratio: f64, smoothed: &S) -> Self {
        Self {
            steps,
            ratio,
            largest: MARGIN * largest_eigenvalue(smoothed),
        }
    }

    /// Smoothes z; the residual follows if it is still wanted.
    pub fn smooth<S: Smoothed>(
        &self,
        smoothed: &S,
        z: &mut [S::Number],
        room: &mut Room<S>,
        follow: bool,
    ) {
        let (a, b) = (self.largest / self.ratio, self.largest);
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let mut rho = half / middle;
        smoothed.invert(&room.residual, &mut room.correction);
        scale(&mut room.correction, 1.0 / middle);
        for step in 1..=self.steps {
            axpy(z, 1.0, &room.correction);
            let last = step == self.steps;
            if last && !follow {
                return;
            }
            room.subtract_image(smoothed);
            if last {
                return;
            }
            let next = 1.0 / (2.0 * middle / half - rho);
            smoothed.invert(&room.residual, &mut room.image);
            combine(
                next * rho,
                &mut room.correction,
                2.0 * next / half,
                &room.image,
            );
            rho = next;
        }
    }
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

//! Preconditioned conjugate gradients. Sums are made of fixed blocks: no bit depends on the number of threads.

use super::number::Number;
use crate::Error;
use crate::norm::dual::{Step, Target};
use crate::parallel::{for_chunks, for_chunks_together};

/// How many entries make one piece of work.
const BLOCK: usize = 1 << 14;

/// xᵀ y, in double precision.
pub(super) fn dot<S: Number, T: Number>(x: &[S], y: &[T]) -> f64 {
    let mut sums = vec![0.0; x.len().div_ceil(BLOCK)];
    for_chunks(&mut sums, 1, |i, sum| {
        let range = i * BLOCK..x.len().min((i + 1) * BLOCK);
        // Eight partial sums, which the compiler keeps in registers.
        let mut partial = [0.0; 8];
        for (x, y) in x[range.clone()].chunks(8).zip(y[range].chunks(8)) {
            for (p, (x, y)) in partial.iter_mut().zip(x.iter().zip(y)) {
                *p += x.double() * y.double();
            }
        }
        sum[0] = partial.iter().sum();
    });
    sums.iter().sum()
}

/// y += α x.
pub(super) fn axpy<T: Number>(y: &mut [T], alpha: f64, x: &[T]) {
    combine(1.0, y, alpha, x);
}

/// y = α y.
pub(super) fn scale<T: Number>(y: &mut [T], alpha: f64) {
    let alpha = T::of(alpha);
    for_chunks(y, BLOCK, |_, y| y.iter_mut().for_each(|y| *y *= alpha));
}

/// y = α y + β x, in the precision of y.
pub(super) fn combine<S: Number, T: Number>(alpha: f64, y: &mut [T], beta: f64, x: &[S]) {
    let (alpha, beta) = (T::of(alpha), T::of(beta));
    for_chunks(y, BLOCK, |i, y| {
        for (y, x) in y.iter_mut().zip(&x[i * BLOCK..]) {
            *y = alpha * *y + beta * T::of(x.double());
        }
    });
}

/// x = α x, and y += α x.
pub(super) fn add_scaled<T: Number>(alpha: f64, x: &mut [T], y: &mut [T]) {
    let alpha = T::of(alpha);
    for_chunks_together(
        [x, y],
        BLOCK,
        || (),
        |_, [x, y], ()| {
            for (x, y) in x.iter_mut().zip(y) {
                *x *= alpha;
                *y += *x;
            }
        },
    );
}

/// y = α x in another precision.
pub(super) fn convert<S: Number, T: Number>(x: &[S], alpha: f64, y: &mut [T]) {
    for_chunks(y, BLOCK, |i, y| {
        for (y, x) in y.iter_mut().zip(&x[i * BLOCK..]) {
            *y = T::of(alpha * x.double());
        }
    });
}

/// x with A x = r for symmetric positive definite A and preconditioner; `watch` is told of each step.
///
/// `apply(p, q, room)` is q = A p. `precondition(r, room)` leaves M⁻¹ r, divided by what it returns, where `preconditioned(room)` is.
///
/// # Errors
/// If the steps do not suffice, or what should be positive is not.
pub(super) fn solve<R, Z: Number>(
    mut r: Vec<f64>,
    target: Target,
    room: &mut R,
    apply: impl Fn(&[f64], &mut [f64], &mut R),
    precondition: impl Fn(&[f64], &mut R) -> f64,
    preconditioned: impl Fn(&R) -> &[Z],
    watch: &mut dyn FnMut(Step),
) -> Result<Vec<f64>, Error> {
    let mut x = vec![0.0; r.len()];
    let (mut p, mut q) = (x.clone(), x.clone());
    let mut size = precondition(&r, room);
    combine(0.0, &mut p, size, preconditioned(room));
    let mut square = size * dot(&r, preconditioned(room));
    let first = square;
    if first == 0.0 {
        return Ok(x);
    }
    for step in 1..=target.steps {
        apply(&p, &mut q, room);
        let energy = dot(&p, &q);
        if !(energy > 0.0 && square > 0.0 && energy.is_finite()) {
            return Err(Error::Solver(format!(
                "conjugate gradients broke down in step {step}: energy {energy:e}, residual {square:e}"
            )));
        }
        let alpha = square / energy;
        axpy(&mut x, alpha, &p);
        axpy(&mut r, -alpha, &q);
        size = precondition(&r, room);
        let before = std::mem::replace(&mut square, size * dot(&r, preconditioned(room)));
        if square < 0.0 {
            return Err(Error::Solver(format!(
                "conjugate gradients broke down in step {step}: the preconditioner is not positive definite"
            )));
        }
        let residual = (square / first).sqrt();
        watch(Step {
            number: step,
            residual,
        });
        if residual <= target.residual {
            return Ok(x);
        }
        combine(square / before, &mut p, size, preconditioned(room));
    }
    Err(Error::Solver(format!(
        "conjugate gradients: a relative residual of {:e} after {} steps, where {:e} was wanted",
        (square / first).sqrt(),
        target.steps,
        target.residual
    )))
}

//! Preconditioned conjugate gradients. Sums are made of fixed blocks: no bit depends on the number of threads.

use super::number::Number;
use crate::Error;
use crate::norm::dual::{Step, Target};
use crate::parallel::{for_chunks, within};

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

/// y = α x in another precision.
pub(super) fn convert<S: Number, T: Number>(x: &[S], alpha: f64, y: &mut [T]) {
    for_chunks(y, BLOCK, |i, y| {
        for (y, x) in y.iter_mut().zip(&x[i * BLOCK..]) {
            *y = T::of(alpha * x.double());
        }
    });
}

/// A x = r with a preconditioner M, both symmetric and positive definite.
pub(super) trait System: Send {
    /// What M is computed with.
    type Number: Number;

    /// q = A p.
    fn apply(&mut self, p: &[f64], q: &mut [f64]);

    /// Leaves M⁻¹ r, divided by what is returned, where [`System::preconditioned`] is.
    fn precondition(&mut self, r: &[f64]) -> f64;

    /// What the last [`System::precondition`] left.
    fn preconditioned(&self) -> &[Self::Number];
}

/// x with A x = r; `watch` is told of each step.
///
/// # Errors
/// If the steps do not suffice, or what should be positive is not.
pub(super) fn solve<S: System>(
    system: &mut S,
    r: Vec<f64>,
    target: Target,
    watch: &mut dyn FnMut(Step),
) -> Result<Vec<f64>, Error> {
    let mut state = within(|| State::new(system, r));
    let mut residual = 1.0;
    if state.first == 0.0 {
        return Ok(state.x);
    }
    for number in 1..=target.steps {
        residual = within(|| state.step(system)).map_err(|what| {
            Error::Solver(format!(
                "conjugate gradients broke down in step {number}: {what}"
            ))
        })?;
        watch(Step { number, residual });
        if residual <= target.residual {
            return Ok(state.x);
        }
    }
    Err(Error::Solver(format!(
        "conjugate gradients: a relative residual of {residual:e} after {} steps, where {:e} was wanted",
        target.steps, target.residual
    )))
}

/// The iteration after some steps.
struct State {
    x: Vec<f64>,
    /// What is left of the right-hand side.
    r: Vec<f64>,
    /// The direction of the last step, from which the next one's is made, and its image A p.
    p: Vec<f64>,
    q: Vec<f64>,
    /// M⁻¹ r, divided by this, is with the system.
    size: f64,
    /// rᵀ M⁻¹ r, what it was a step before, and at first. Before the first step it was infinite, so that its direction is M⁻¹ r alone.
    square: f64,
    before: f64,
    first: f64,
}

impl State {
    /// Before the first step.
    fn new<S: System>(system: &mut S, r: Vec<f64>) -> Self {
        let x = vec![0.0; r.len()];
        let size = system.precondition(&r);
        let square = size * dot(&r, system.preconditioned());
        Self {
            p: x.clone(),
            q: x.clone(),
            x,
            r,
            size,
            square,
            before: f64::INFINITY,
            first: square,
        }
    }

    /// A step, and the relative residual after it.
    ///
    /// # Errors
    /// What is not positive that should be.
    fn step<S: System>(&mut self, system: &mut S) -> Result<f64, String> {
        let beta = self.square / self.before;
        combine(beta, &mut self.p, self.size, system.preconditioned());
        system.apply(&self.p, &mut self.q);
        let (square, energy) = (self.square, dot(&self.p, &self.q));
        if !(energy > 0.0 && square > 0.0 && energy.is_finite()) {
            return Err(format!("energy {energy:e}, residual {square:e}"));
        }
        let alpha = square / energy;
        axpy(&mut self.x, alpha, &self.p);
        axpy(&mut self.r, -alpha, &self.q);
        self.size = system.precondition(&self.r);
        self.square = self.size * dot(&self.r, system.preconditioned());
        self.before = square;
        match self.square < 0.0 {
            true => Err("the preconditioner is not positive definite".into()),
            false => Ok((self.square / self.first).sqrt()),
        }
    }
}

//! Formulas as steps, each of which is there once: what several formulas have in common is computed once for all of them.

use super::code::Op;
use super::function::{Function, Pair};
use regge_curvature::scalar::Real;
use std::collections::HashMap;

/// One step: what is computed, from what other steps gave. It names these by their numbers in a [`Graph`], or by the places
/// where a program keeps them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// A number, by its bits.
    Constant(u64),
    /// The i-th coordinate.
    Coordinate(u32),
    /// −a.
    Negate(u32),
    /// a + b.
    Add(u32, u32),
    /// a − b.
    Subtract(u32, u32),
    /// a · b.
    Multiply(u32, u32),
    /// a / b.
    Divide(u32, u32),
    /// a^b = exp(b ln a).
    Power(u32, u32),
    /// f(a).
    Call(Function, u32),
    /// f(a, b).
    Pair(Pair, u32, u32),
}

impl Step {
    fn number(value: f64) -> Self {
        Self::Constant(value.to_bits())
    }

    /// With the operands renamed.
    pub fn renamed(self, name: impl Fn(u32) -> u32) -> Self {
        match self {
            Self::Constant(_) | Self::Coordinate(_) => self,
            Self::Negate(a) => Self::Negate(name(a)),
            Self::Add(a, b) => Self::Add(name(a), name(b)),
            Self::Subtract(a, b) => Self::Subtract(name(a), name(b)),
            Self::Multiply(a, b) => Self::Multiply(name(a), name(b)),
            Self::Divide(a, b) => Self::Divide(name(a), name(b)),
            Self::Power(a, b) => Self::Power(name(a), name(b)),
            Self::Call(function, a) => Self::Call(function, name(a)),
            Self::Pair(function, a, b) => Self::Pair(function, name(a), name(b)),
        }
    }

    /// The operands.
    pub fn operands(self) -> impl Iterator<Item = u32> {
        let list = match self {
            Self::Constant(_) | Self::Coordinate(_) => [None, None],
            Self::Negate(a) | Self::Call(_, a) => [Some(a), None],
            Self::Add(a, b)
            | Self::Subtract(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Power(a, b)
            | Self::Pair(_, a, b) => [Some(a), Some(b)],
        };
        list.into_iter().flatten()
    }

    /// Its value at x, with the values of the operands.
    #[inline]
    pub fn value<S: Real>(self, of: impl Fn(u32) -> S, x: &[S]) -> S {
        match self {
            Self::Constant(bits) => S::from_f64(f64::from_bits(bits)),
            Self::Coordinate(i) => x[i as usize],
            Self::Negate(a) => -of(a),
            Self::Add(a, b) => of(a) + of(b),
            Self::Subtract(a, b) => of(a) - of(b),
            Self::Multiply(a, b) => of(a) * of(b),
            Self::Divide(a, b) => of(a) / of(b),
            Self::Power(a, b) => (of(b) * of(a).ln()).exp(),
            Self::Call(function, a) => function.of(of(a)),
            Self::Pair(function, a, b) => function.of(of(a), of(b)),
        }
    }
}

/// Steps in an order in which each comes after its operands.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    steps: Vec<Step>,
    known: HashMap<Step, u32>,
}

impl Graph {
    /// The steps.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Adds a formula, as far as it is not there already: the number of the step that gives its value.
    pub fn add(&mut self, code: &[Op]) -> u32 {
        let mut stack: Vec<u32> = Vec::new();
        let known = "the parser writes no code that takes more than there is";
        for op in code {
            let step = match *op {
                Op::Constant(value) => Step::number(value),
                Op::Coordinate(i) => Step::Coordinate(i as u32),
                op => {
                    let last = stack.pop().expect(known);
                    match op {
                        Op::Negate => Step::Negate(last),
                        Op::Call(function) => Step::Call(function, last),
                        Op::Integer(n) => {
                            stack.push(self.integer_power(last, n));
                            continue;
                        }
                        op => binary(op, stack.pop().expect(known), last),
                    }
                }
            };
            stack.push(self.step(step));
        }
        stack.pop().expect("a formula has a value")
    }

    /// The number of a step. What is computed of constants is a constant.
    fn step(&mut self, step: Step) -> u32 {
        let step = match step {
            Step::Coordinate(_) => step,
            step if step.operands().all(|i| self.constant(i).is_some()) => {
                let of = |i: u32| self.constant(i).expect("all operands are constants");
                Step::number(step.value(of, &[]))
            }
            // The operands of a sum and of a product can be exchanged.
            Step::Add(a, b) => Step::Add(a.min(b), a.max(b)),
            Step::Multiply(a, b) => Step::Multiply(a.min(b), a.max(b)),
            step => step,
        };
        let next = self.steps.len() as u32;
        let number = *self.known.entry(step).or_insert(next);
        if number == next {
            self.steps.push(step);
        }
        number
    }

    /// The value of a step, if it is a constant.
    fn constant(&self, number: u32) -> Option<f64> {
        match self.steps[number as usize] {
            Step::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// aⁿ by repeated squaring.
    fn integer_power(&mut self, a: u32, n: i32) -> u32 {
        let (mut product, mut square, mut left) = (None, a, n.unsigned_abs());
        while left > 0 {
            if left & 1 == 1 {
                product = Some(match product {
                    Some(product) => self.step(Step::Multiply(product, square)),
                    None => square,
                });
            }
            left >>= 1;
            if left > 0 {
                square = self.step(Step::Multiply(square, square));
            }
        }
        let one = self.step(Step::number(1.0));
        match product {
            Some(product) if n < 0 => self.step(Step::Divide(one, product)),
            Some(product) => product,
            None => one,
        }
    }
}

fn binary(op: Op, a: u32, b: u32) -> Step {
    match op {
        Op::Add => Step::Add(a, b),
        Op::Subtract => Step::Subtract(a, b),
        Op::Multiply => Step::Multiply(a, b),
        Op::Divide => Step::Divide(a, b),
        Op::Pair(function) => Step::Pair(function, a, b),
        _ => Step::Power(a, b),
    }
}

/// The value of a formula without coordinates.
pub fn constant(code: &[Op]) -> Option<f64> {
    let mut graph = Graph::default();
    let value = graph.add(code);
    graph.constant(value)
}

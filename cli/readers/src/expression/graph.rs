//! Formulas as steps, each of which is there once: what several formulas have in common is computed once for all of them.

use super::code::Op;
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
    /// f(a).
    Elementary(Elementary, u32),
    /// The angle of the point (b, a), in (−π, π].
    Angle(u32, u32),
    /// b where a ≥ 0, c where a < 0, a where it is NaN.
    Select(u32, u32, u32),
}

/// The functions that a scalar has of its own; all others are made of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Elementary {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Arc tangent, in (−π/2, π/2).
    Atan,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Square root.
    Sqrt,
}

impl Elementary {
    fn of<S: Real>(self, a: S) -> S {
        match self {
            Self::Sin => a.sin(),
            Self::Cos => a.cos(),
            Self::Atan => a.atan(),
            Self::Exp => a.exp(),
            Self::Ln => a.ln(),
            Self::Sqrt => a.sqrt(),
        }
    }
}

impl Step {
    /// The step that gives a number.
    pub fn number(value: f64) -> Self {
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
            Self::Elementary(function, a) => Self::Elementary(function, name(a)),
            Self::Angle(a, b) => Self::Angle(name(a), name(b)),
            Self::Select(a, b, c) => Self::Select(name(a), name(b), name(c)),
        }
    }

    /// The operands.
    pub fn operands(self) -> impl Iterator<Item = u32> {
        let list = match self {
            Self::Constant(_) | Self::Coordinate(_) => [None; 3],
            Self::Negate(a) | Self::Elementary(_, a) => [Some(a), None, None],
            Self::Add(a, b)
            | Self::Subtract(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Angle(a, b) => [Some(a), Some(b), None],
            Self::Select(a, b, c) => [Some(a), Some(b), Some(c)],
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
            Self::Elementary(function, a) => function.of(of(a)),
            Self::Angle(a, b) => S::angle(of(a), of(b)),
            Self::Select(a, b, c) => of(a).select(of(b), of(c)),
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
            let value = match *op {
                Op::Constant(value) => self.number(value),
                Op::Coordinate(i) => self.step(Step::Coordinate(i as u32)),
                op => {
                    let last = stack.pop().expect(known);
                    match op {
                        Op::Negate => self.negate(last),
                        Op::Integer(n) => self.integer_power(last, n),
                        Op::Call(function) => self.call(function, last),
                        op => self.binary(op, stack.pop().expect(known), last),
                    }
                }
            };
            stack.push(value);
        }
        stack.pop().expect("a formula has a value")
    }

    fn binary(&mut self, op: Op, a: u32, b: u32) -> u32 {
        match op {
            Op::Add => self.plus(a, b),
            Op::Subtract => self.minus(a, b),
            Op::Multiply => self.times(a, b),
            Op::Divide => self.over(a, b),
            Op::Pair(function) => self.pair(function, a, b),
            _ => self.power(a, b),
        }
    }

    /// The number of a step. What is computed of constants is a constant.
    pub fn step(&mut self, step: Step) -> u32 {
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
    pub fn constant(&self, number: u32) -> Option<f64> {
        match self.steps[number as usize] {
            Step::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }
}

/// The value of a formula without coordinates.
pub fn constant(code: &[Op]) -> Option<f64> {
    let mut graph = Graph::default();
    let value = graph.add(code);
    graph.constant(value)
}

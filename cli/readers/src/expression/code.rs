//! What a formula is compiled to, and its evaluation over any real scalar.
//!
//! The code is postfix, a list and not a tree: neither its evaluation nor its end recurses, whatever its length.

use super::function::{Function, Pair};
use regge_curvature::scalar::Real;

/// One step on a stack of values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Op {
    /// Puts a number.
    Constant(f64),
    /// Puts the i-th coordinate.
    Coordinate(usize),
    /// −a.
    Negate,
    /// a + b.
    Add,
    /// a − b.
    Subtract,
    /// a · b.
    Multiply,
    /// a / b.
    Divide,
    /// aⁿ by multiplications: exact derivatives at a ≤ 0 too.
    Integer(i32),
    /// a^b = exp(b ln a).
    Power,
    /// f(a).
    Call(Function),
    /// f(a, b).
    Pair(Pair),
}

/// How many values the code puts on the stack at a time.
pub fn depth(code: &[Op]) -> usize {
    let (mut top, mut most) = (0usize, 0);
    for op in code {
        match op {
            Op::Constant(_) | Op::Coordinate(_) => top += 1,
            Op::Negate | Op::Integer(_) | Op::Call(_) => {}
            Op::Add | Op::Subtract | Op::Multiply | Op::Divide | Op::Power | Op::Pair(_) => {
                top -= 1
            }
        }
        most = most.max(top);
    }
    most
}

/// Most formulas need no more, and no memory but this.
const SMALL: usize = 8;

/// The value at x of code that the parser wrote, of this [`depth`].
pub fn run<S: Real>(code: &[Op], depth: usize, x: &[S]) -> S {
    match depth {
        0..=SMALL => run_on(&mut [S::zero(); SMALL], code, x),
        _ => run_on(&mut vec![S::zero(); depth], code, x),
    }
}

fn run_on<S: Real>(stack: &mut [S], code: &[Op], x: &[S]) -> S {
    let mut top = 0;
    for op in code {
        let value = match *op {
            Op::Constant(c) => S::from_f64(c),
            Op::Coordinate(i) => x[i],
            _ => {
                // The parser writes no code that takes more than there is.
                top -= 1;
                let last = stack[top];
                match *op {
                    Op::Negate => -last,
                    Op::Integer(n) => integer_power(last, n),
                    Op::Call(function) => function.of(last),
                    op => {
                        top -= 1;
                        binary(op, stack[top], last)
                    }
                }
            }
        };
        stack[top] = value;
        top += 1;
    }
    stack[0]
}

fn binary<S: Real>(op: Op, a: S, b: S) -> S {
    match op {
        Op::Add => a + b,
        Op::Subtract => a - b,
        Op::Multiply => a * b,
        Op::Divide => a / b,
        Op::Pair(function) => function.of(a, b),
        _ => (b * a.ln()).exp(),
    }
}

/// aⁿ by repeated squaring.
fn integer_power<S: Real>(a: S, n: i32) -> S {
    let (mut product, mut square, mut left) = (S::one(), a, n.unsigned_abs());
    while left > 0 {
        if left & 1 == 1 {
            product *= square;
        }
        left >>= 1;
        if left > 0 {
            square = square * square;
        }
    }
    if n < 0 { S::one() / product } else { product }
}

//! What the parser writes: postfix code, a list and not a tree, so that nothing recurses, whatever its length.

use super::function::{Function, Pair};

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

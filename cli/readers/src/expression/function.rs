//! The functions that a formula may call, by name. What they are made of is in `lower.rs`.

use std::ops::RangeInclusive;

/// What a name with brackets stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Callable {
    /// f(a).
    One(Function),
    /// f(a, b).
    Two(Pair),
    /// f(a, b, …), from the left.
    More(Pair),
    /// a^b, which is an operator.
    Power,
}

impl Callable {
    /// How it is called, by this name.
    pub fn written(self, name: &str) -> String {
        let arguments = match self {
            Self::One(_) => "a",
            Self::Two(_) | Self::Power => "a, b",
            Self::More(_) => "a, b, ...",
        };
        format!("{name}({arguments})")
    }

    /// How many arguments it takes.
    pub fn arguments(self) -> RangeInclusive<usize> {
        match self {
            Self::One(_) => 1..=1,
            Self::Two(_) | Self::Power => 2..=2,
            Self::More(_) => 2..=usize::MAX,
        }
    }
}

/// All of them, by name, those that have several names by the one to be told first.
pub const FUNCTIONS: [(&str, Callable); 26] = [
    ("sqrt", Callable::One(Function::Sqrt)),
    ("cbrt", Callable::One(Function::Cbrt)),
    ("exp", Callable::One(Function::Exp)),
    ("ln", Callable::One(Function::Ln)),
    ("log", Callable::One(Function::Ln)),
    ("log2", Callable::One(Function::Log2)),
    ("log10", Callable::One(Function::Log10)),
    ("pow", Callable::Power),
    ("sin", Callable::One(Function::Sin)),
    ("cos", Callable::One(Function::Cos)),
    ("tan", Callable::One(Function::Tan)),
    ("asin", Callable::One(Function::Asin)),
    ("acos", Callable::One(Function::Acos)),
    ("atan", Callable::One(Function::Atan)),
    ("atan2", Callable::Two(Pair::Atan2)),
    ("sinh", Callable::One(Function::Sinh)),
    ("cosh", Callable::One(Function::Cosh)),
    ("tanh", Callable::One(Function::Tanh)),
    ("asinh", Callable::One(Function::Asinh)),
    ("acosh", Callable::One(Function::Acosh)),
    ("atanh", Callable::One(Function::Atanh)),
    ("hypot", Callable::Two(Pair::Hypot)),
    ("abs", Callable::One(Function::Abs)),
    ("sign", Callable::One(Function::Sign)),
    ("min", Callable::More(Pair::Min)),
    ("max", Callable::More(Pair::Max)),
];

/// The functions of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Arc sine, in [−π/2, π/2].
    Asin,
    /// Arc cosine, in [0, π].
    Acos,
    /// Arc tangent, in (−π/2, π/2).
    Atan,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Logarithm to base 2.
    Log2,
    /// Logarithm to base 10.
    Log10,
    /// Square root.
    Sqrt,
    /// Cube root, of negative numbers too.
    Cbrt,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// The inverse function of sinh.
    Asinh,
    /// That of cosh, for a ≥ 1.
    Acosh,
    /// That of tanh, for |a| < 1.
    Atanh,
    /// Absolute value; at 0 differentiated as from the right.
    Abs,
    /// −1, 0 or 1.
    Sign,
}

/// The functions of two arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pair {
    /// The angle of the point (b, a), in (−π, π].
    Atan2,
    /// √(a² + b²).
    Hypot,
    /// The smaller one, the first where they are equal.
    Min,
    /// The larger one, the first where they are equal.
    Max,
}

impl Function {
    /// Is it not differentiable somewhere inside its domain?
    pub fn has_kink(self) -> bool {
        matches!(self, Self::Abs | Self::Sign)
    }
}

impl Pair {
    /// Is it not differentiable along a line where its arguments are harmless?
    pub fn has_kink(self) -> bool {
        matches!(self, Self::Min | Self::Max)
    }
}

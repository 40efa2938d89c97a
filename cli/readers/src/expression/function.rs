//! The functions that a formula may call, by name, over any real scalar.
//!
//! Derivatives are those of the formulas below, by the chain rule of the scalar. Where a function has a kink or a jump
//! they are those of one side: abs, sign, min and max differentiate what they take.

use regge_curvature::scalar::Real;
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
    /// f(a).
    pub fn of<S: Real>(self, a: S) -> S {
        match self {
            Self::Sin => a.sin(),
            Self::Cos => a.cos(),
            Self::Tan => a.tan(),
            Self::Asin => S::angle(a, beside(a)),
            Self::Acos => S::angle(beside(a), a),
            Self::Atan => a.atan(),
            Self::Exp => a.exp(),
            Self::Ln => a.ln(),
            Self::Log2 => a.ln() * S::from_f64(std::f64::consts::LOG2_E),
            Self::Log10 => a.ln() * S::from_f64(std::f64::consts::LOG10_E),
            Self::Sqrt => a.sqrt(),
            Self::Cbrt => {
                let root = (absolute(a).ln() * S::ratio(1, 3)).exp();
                a.select(root, -root)
            }
            Self::Sinh => a.sinh(),
            Self::Cosh => a.cosh(),
            // e^2a overflows for large a where tanh is 1; e^−2|a| would not, but has a kink at 0.
            Self::Tanh => S::one() - S::from_int(2) / ((a + a).exp() + S::one()),
            // Of −|a| the sum would cancel.
            Self::Asinh => {
                let size = absolute(a);
                let inverse = (size + hypotenuse(size, S::one())).ln();
                a.select(inverse, -inverse)
            }
            // a² − 1 in factors, which neither overflow nor cancel.
            Self::Acosh => (a + (a - S::one()).sqrt() * (a + S::one()).sqrt()).ln(),
            Self::Atanh => ((S::one() + a) / (S::one() - a)).ln() * S::half(),
            Self::Abs => absolute(a),
            Self::Sign => a.select((-a).select(S::zero(), S::one()), -S::one()),
        }
    }

    /// Is it not differentiable somewhere inside its domain?
    pub fn has_kink(self) -> bool {
        matches!(self, Self::Abs | Self::Sign)
    }
}

impl Pair {
    /// f(a, b).
    pub fn of<S: Real>(self, a: S, b: S) -> S {
        match self {
            Self::Atan2 => S::angle(a, b),
            Self::Hypot => hypotenuse(a, b),
            Self::Min => (b - a).select(a, b),
            Self::Max => (a - b).select(a, b),
        }
    }

    /// Is it not differentiable along a line where its arguments are harmless?
    pub fn has_kink(self) -> bool {
        matches!(self, Self::Min | Self::Max)
    }
}

/// |a|.
fn absolute<S: Real>(a: S) -> S {
    a.select(a, -a)
}

/// √(1 − a²), which with a makes the point of the unit circle; NaN for |a| > 1.
fn beside<S: Real>(a: S) -> S {
    ((S::one() - a) * (S::one() + a)).sqrt()
}

/// √(a² + b²) without overflow: the larger one in front. Both ways to write it are one smooth function.
fn hypotenuse<S: Real>(a: S, b: S) -> S {
    let larger = Pair::Max.of(absolute(a), absolute(b));
    let [x, y] = [a / larger, b / larger];
    // Where both are 0 there is a cone, without derivatives.
    (-larger).select((a * a + b * b).sqrt(), larger * (x * x + y * y).sqrt())
}

//! What the functions of formulas are made of: a few steps that every scalar has.
//!
//! Derivatives are those of these steps, by the chain rule. Where a function has a kink or a jump they are those of one
//! side: abs, sign, min and max differentiate what they take.

use super::function::{Function, Pair};
use super::graph::{Elementary, Graph, Step};
use std::f64::consts::{LOG2_E, LOG10_E};

/// Steps, by what they do.
impl Graph {
    /// A constant.
    pub fn number(&mut self, value: f64) -> u32 {
        self.step(Step::number(value))
    }

    /// −a.
    pub fn negate(&mut self, a: u32) -> u32 {
        self.step(Step::Negate(a))
    }

    /// a + b.
    pub fn plus(&mut self, a: u32, b: u32) -> u32 {
        self.step(Step::Add(a, b))
    }

    /// a − b.
    pub fn minus(&mut self, a: u32, b: u32) -> u32 {
        self.step(Step::Subtract(a, b))
    }

    /// a · b.
    pub fn times(&mut self, a: u32, b: u32) -> u32 {
        self.step(Step::Multiply(a, b))
    }

    /// a / b.
    pub fn over(&mut self, a: u32, b: u32) -> u32 {
        self.step(Step::Divide(a, b))
    }

    /// f(a).
    pub fn elementary(&mut self, function: Elementary, a: u32) -> u32 {
        self.step(Step::Elementary(function, a))
    }

    /// `above` where a ≥ 0, `below` where a < 0.
    pub fn select(&mut self, a: u32, above: u32, below: u32) -> u32 {
        self.step(Step::Select(a, above, below))
    }
}

/// Functions.
impl Graph {
    /// a^b = exp(b ln a).
    pub fn power(&mut self, a: u32, b: u32) -> u32 {
        let logarithm = self.elementary(Elementary::Ln, a);
        let exponent = self.times(b, logarithm);
        self.elementary(Elementary::Exp, exponent)
    }

    /// aⁿ by repeated squaring.
    pub fn integer_power(&mut self, a: u32, n: i32) -> u32 {
        let (mut product, mut square, mut left) = (None, a, n.unsigned_abs());
        while left > 0 {
            if left & 1 == 1 {
                product = Some(match product {
                    Some(product) => self.times(product, square),
                    None => square,
                });
            }
            left >>= 1;
            if left > 0 {
                square = self.times(square, square);
            }
        }
        let one = self.number(1.0);
        match product {
            Some(product) if n < 0 => self.over(one, product),
            Some(product) => product,
            None => one,
        }
    }

    /// A function of one argument.
    pub fn call(&mut self, function: Function, a: u32) -> u32 {
        match function {
            Function::Sin => self.elementary(Elementary::Sin, a),
            Function::Cos => self.elementary(Elementary::Cos, a),
            Function::Tan => {
                let (sine, cosine) = (self.call(Function::Sin, a), self.call(Function::Cos, a));
                self.over(sine, cosine)
            }
            Function::Asin => {
                let cosine = self.beside(a);
                self.step(Step::Angle(a, cosine))
            }
            Function::Acos => {
                let sine = self.beside(a);
                self.step(Step::Angle(sine, a))
            }
            Function::Atan => self.elementary(Elementary::Atan, a),
            Function::Sqrt => self.elementary(Elementary::Sqrt, a),
            Function::Abs => {
                let below = self.negate(a);
                self.select(a, a, below)
            }
            Function::Sign => self.sign(a),
            Function::Exp | Function::Sinh | Function::Cosh | Function::Tanh => {
                self.exponential(function, a)
            }
            _ => self.logarithmic(function, a),
        }
    }

    /// −1, 0 or 1.
    fn sign(&mut self, a: u32) -> u32 {
        let [minus, zero, one] = [-1.0, 0.0, 1.0].map(|value| self.number(value));
        let negative = self.negate(a);
        let above = self.select(negative, zero, one);
        self.select(a, above, minus)
    }

    /// The functions that are made of the exponential.
    fn exponential(&mut self, function: Function, a: u32) -> u32 {
        if function == Function::Tanh {
            // e^2a overflows for large a where tanh is 1; e^−2|a| would not, but has a kink at 0.
            let [one, two] = [1.0, 2.0].map(|value| self.number(value));
            let double = self.plus(a, a);
            let grown = self.elementary(Elementary::Exp, double);
            let sum = self.plus(grown, one);
            let quotient = self.over(two, sum);
            return self.minus(one, quotient);
        }
        let up = self.elementary(Elementary::Exp, a);
        if function == Function::Exp {
            return up;
        }
        let negative = self.negate(a);
        let down = self.elementary(Elementary::Exp, negative);
        let both = match function {
            Function::Sinh => self.minus(up, down),
            _ => self.plus(up, down),
        };
        let half = self.number(0.5);
        self.times(both, half)
    }

    /// The functions that are made of the logarithm.
    fn logarithmic(&mut self, function: Function, a: u32) -> u32 {
        let one = self.number(1.0);
        let (argument, factor) = match function {
            Function::Cbrt => {
                let size = self.call(Function::Abs, a);
                let third = self.number(1.0 / 3.0);
                let root = self.power(size, third);
                return self.odd(a, root);
            }
            Function::Asinh => {
                // Of −|a| the sum would cancel.
                let size = self.call(Function::Abs, a);
                let root = self.pair(Pair::Hypot, size, one);
                let sum = self.plus(size, root);
                let inverse = self.elementary(Elementary::Ln, sum);
                return self.odd(a, inverse);
            }
            Function::Acosh => {
                // a² − 1 in factors, which neither overflow nor cancel.
                let factors = [self.minus(a, one), self.plus(a, one)];
                let [x, y] = factors.map(|factor| self.elementary(Elementary::Sqrt, factor));
                let root = self.times(x, y);
                (self.plus(a, root), 1.0)
            }
            Function::Atanh => {
                let (above, below) = (self.plus(one, a), self.minus(one, a));
                (self.over(above, below), 0.5)
            }
            Function::Log2 => (a, LOG2_E),
            Function::Log10 => (a, LOG10_E),
            _ => (a, 1.0),
        };
        let logarithm = self.elementary(Elementary::Ln, argument);
        if factor == 1.0 {
            return logarithm;
        }
        let factor = self.number(factor);
        self.times(logarithm, factor)
    }

    /// The odd function of a that is `value` for a ≥ 0.
    fn odd(&mut self, a: u32, value: u32) -> u32 {
        let below = self.negate(value);
        self.select(a, value, below)
    }

    /// √(1 − a²), which with a makes the point of the unit circle; NaN for |a| > 1.
    fn beside(&mut self, a: u32) -> u32 {
        let one = self.number(1.0);
        let factors = [self.minus(one, a), self.plus(one, a)];
        let square = self.times(factors[0], factors[1]);
        self.elementary(Elementary::Sqrt, square)
    }

    /// A function of two arguments.
    pub fn pair(&mut self, function: Pair, a: u32, b: u32) -> u32 {
        match function {
            Pair::Atan2 => self.step(Step::Angle(a, b)),
            Pair::Hypot => self.hypotenuse(a, b),
            Pair::Min => {
                let ahead = self.minus(b, a);
                self.select(ahead, a, b)
            }
            Pair::Max => {
                let ahead = self.minus(a, b);
                self.select(ahead, a, b)
            }
        }
    }

    /// √(a² + b²) without overflow: the larger one in front. Both ways to write it are one smooth function.
    fn hypotenuse(&mut self, a: u32, b: u32) -> u32 {
        let sizes = [a, b].map(|side| self.call(Function::Abs, side));
        let larger = self.pair(Pair::Max, sizes[0], sizes[1]);
        let [x, y] = [a, b].map(|side| self.over(side, larger));
        let [plain, scaled] = [[a, b], [x, y]].map(|[a, b]| {
            let squares = [self.times(a, a), self.times(b, b)];
            let sum = self.plus(squares[0], squares[1]);
            self.elementary(Elementary::Sqrt, sum)
        });
        let scaled = self.times(larger, scaled);
        // Where both are 0 there is a cone, without derivatives.
        let vanishes = self.negate(larger);
        self.select(vanishes, plain, scaled)
    }
}

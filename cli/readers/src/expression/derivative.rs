//! Derivatives of formulas as formulas: what they have in common with each other and with the formulas is computed once.
//!
//! Over jets the chain rule of the scalar gives the same numbers; but a metric that is made of first derivatives and is
//! itself differentiated twice would ask for jets of jets, most of whose parts nobody needs.

use super::graph::{Elementary, Graph, Step};

/// A derivative: a step, or 0 where the formula does not depend on the coordinate.
type Derivative = Option<u32>;

impl Graph {
    /// The steps that give ∂_m of each of these results.
    pub fn derivatives(&mut self, results: &[u32], m: usize) -> Vec<u32> {
        let count = self.steps().len();
        let mut known: Vec<Derivative> = Vec::with_capacity(count);
        for i in 0..count {
            let step = self.steps()[i];
            let derivative = self.derivative(step, i as u32, m as u32, &known);
            known.push(derivative);
        }
        let zero = self.number(0.0);
        let of = |&i: &u32| known[i as usize].unwrap_or(zero);
        results.iter().map(of).collect()
    }

    /// That of one step, whose number is `itself`, from those of its operands.
    fn derivative(&mut self, step: Step, itself: u32, m: u32, known: &[Derivative]) -> Derivative {
        let of = |operand: u32| known[operand as usize];
        match step {
            Step::Constant(_) => None,
            Step::Coordinate(i) => (i == m).then(|| self.number(1.0)),
            Step::Negate(a) => of(a).map(|da| self.negate(da)),
            Step::Add(a, b) => self.sum(of(a), of(b)),
            Step::Subtract(a, b) => self.difference(of(a), of(b)),
            Step::Multiply(a, b) => {
                let terms = [self.product(of(a), b), self.product(of(b), a)];
                self.sum(terms[0], terms[1])
            }
            // q = a / b: q' = (a' − q b') / b.
            Step::Divide(a, b) => {
                let taken = self.product(of(b), itself);
                let above = self.difference(of(a), taken);
                above.map(|above| self.over(above, b))
            }
            Step::Elementary(function, a) => {
                of(a).map(|da| self.elementary_derivative(function, itself, a, da))
            }
            // (s' c − c' s) / (s² + c²).
            Step::Angle(s, c) => {
                let terms = [self.product(of(s), c), self.product(of(c), s)];
                let above = self.difference(terms[0], terms[1])?;
                let squares = [self.times(s, s), self.times(c, c)];
                let below = self.plus(squares[0], squares[1]);
                Some(self.over(above, below))
            }
            Step::Select(by, above, below) => {
                if of(above).is_none() && of(below).is_none() {
                    return None;
                }
                let zero = self.number(0.0);
                let [above, below] = [of(above), of(below)].map(|d| d.unwrap_or(zero));
                Some(self.select(by, above, below))
            }
        }
    }

    /// f'(a) a', where `itself` is the step f(a).
    fn elementary_derivative(&mut self, f: Elementary, itself: u32, a: u32, da: u32) -> u32 {
        match f {
            Elementary::Sin => {
                let cosine = self.elementary(Elementary::Cos, a);
                self.factor(da, cosine)
            }
            Elementary::Cos => {
                let sine = self.elementary(Elementary::Sin, a);
                let product = self.factor(da, sine);
                self.negate(product)
            }
            Elementary::Atan => {
                let (one, square) = (self.number(1.0), self.times(a, a));
                let below = self.plus(one, square);
                self.over(da, below)
            }
            Elementary::Exp => self.factor(da, itself),
            Elementary::Ln => self.over(da, a),
            Elementary::Sqrt => {
                let double = self.plus(itself, itself);
                self.over(da, double)
            }
        }
    }

    fn sum(&mut self, a: Derivative, b: Derivative) -> Derivative {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.plus(a, b)),
            (a, b) => a.or(b),
        }
    }

    fn difference(&mut self, a: Derivative, b: Derivative) -> Derivative {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.minus(a, b)),
            (None, Some(b)) => Some(self.negate(b)),
            (a, None) => a,
        }
    }

    fn product(&mut self, derivative: Derivative, by: u32) -> Derivative {
        derivative.map(|derivative| self.factor(derivative, by))
    }

    /// a · b, where a is often 1.
    fn factor(&mut self, a: u32, b: u32) -> u32 {
        match self.constant(a) {
            Some(1.0) => b,
            _ => self.times(a, b),
        }
    }
}

//! The straight-line program that a kernel executes, written down while it runs, and what can be found out about it.
//!
//! A [`Recorded`] number is a place in a list of operations. A kernel that computes with such numbers leaves its own program
//! behind, since nothing in a kernel depends on the value of a number: the same operations in the same order, what is
//! computed twice written once. The program is then run over any other scalar, and its [`Degrees`] are counted.

mod degrees;
mod recorded;
mod supports;

pub use degrees::{Degrees, degrees};
pub use recorded::{Recorded, record};
pub use supports::{MultiDegree, supports};

use regge_curvature::scalar::Algebraic;

/// One operation; operands are places of earlier ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// A number that is given, by its place in the list of them.
    Input(u32),
    /// A rational number in lowest terms, its denominator positive.
    Constant(i64, i64),
    /// a + b.
    Sum(u32, u32),
    /// a − b.
    Difference(u32, u32),
    /// a b.
    Product(u32, u32),
    /// a/b.
    Quotient(u32, u32),
    /// −a.
    Opposite(u32),
    /// √a.
    Root(u32),
}

impl Step {
    /// The places that it reads.
    pub fn operands(self) -> impl Iterator<Item = u32> {
        let (one, other) = match self {
            Self::Input(_) | Self::Constant(..) => (None, None),
            Self::Opposite(a) | Self::Root(a) => (Some(a), None),
            Self::Sum(a, b)
            | Self::Difference(a, b)
            | Self::Product(a, b)
            | Self::Quotient(a, b) => (Some(a), Some(b)),
        };
        one.into_iter().chain(other)
    }
}

/// A straight-line program.
#[derive(Clone, Debug, Default)]
pub struct Program {
    steps: Vec<Step>,
}

impl Program {
    /// Its steps.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Which steps the results at these places depend on.
    pub fn needed(&self, results: impl IntoIterator<Item = Recorded>) -> Vec<bool> {
        let mut needed = vec![false; self.steps.len()];
        for result in results {
            needed[result.place()] = true;
        }
        for k in (0..self.steps.len()).rev() {
            if needed[k] {
                for operand in self.steps[k].operands() {
                    needed[operand as usize] = true;
                }
            }
        }
        needed
    }

    /// The numbers of the inputs among these steps.
    pub fn inputs(&self, needed: &[bool]) -> Vec<usize> {
        let steps = self.steps.iter().zip(needed).filter(|(_, needed)| **needed);
        let inputs = steps.filter_map(|(step, _)| match step {
            Step::Input(k) => Some(*k as usize),
            _ => None,
        });
        inputs.collect()
    }

    /// Which steps depend on the inputs that are marked.
    pub fn depending(&self, marked: &dyn Fn(usize) -> bool) -> Vec<bool> {
        let mut depends: Vec<bool> = Vec::with_capacity(self.steps.len());
        for step in &self.steps {
            let operands = step.operands().any(|k| depends[k as usize]);
            let own = matches!(step, Step::Input(k) if marked(*k as usize));
            depends.push(own || operands);
        }
        depends
    }

    /// All steps that are needed, over another scalar; none if one of them yields what is `undefined`. What is not needed is
    /// zero.
    pub fn run<F: Algebraic>(
        &self,
        needed: &[bool],
        inputs: &[F],
        undefined: fn(F) -> bool,
    ) -> Option<Vec<F>> {
        self.run_with(needed, inputs, undefined, |_, value| value)
    }

    /// The same, where `replace` has the last word on what a step yields.
    pub fn run_with<F: Algebraic>(
        &self,
        needed: &[bool],
        inputs: &[F],
        undefined: fn(F) -> bool,
        replace: impl Fn(usize, F) -> F,
    ) -> Option<Vec<F>> {
        let mut values: Vec<F> = Vec::with_capacity(self.steps.len());
        for (k, (step, needed)) in self.steps.iter().zip(needed).enumerate() {
            let value = if *needed {
                replace(k, step.value(inputs, &values))
            } else {
                F::zero()
            };
            if undefined(value) {
                return None;
            }
            values.push(value);
        }
        Some(values)
    }
}

impl Step {
    /// What it yields, from the values of the steps before.
    #[inline]
    pub fn value<F: Algebraic>(self, inputs: &[F], values: &[F]) -> F {
        let at = |k: u32| values[k as usize];
        match self {
            Self::Input(k) => inputs[k as usize],
            Self::Constant(n, 1) => F::from_int(n),
            Self::Constant(n, d) => F::ratio(n, d),
            Self::Sum(a, b) => at(a) + at(b),
            Self::Difference(a, b) => at(a) - at(b),
            Self::Product(a, b) => at(a) * at(b),
            Self::Quotient(a, b) => at(a) / at(b),
            Self::Opposite(a) => -at(a),
            Self::Root(a) => at(a).sqrt(),
        }
    }
}

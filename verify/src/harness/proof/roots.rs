//! Roots of parameters, which are replaced by the products that they are.

use super::Variable;
use crate::exact::{Program, Ratio, Recorded, Step, record};
use crate::harness::equation::Equation;
use regge_curvature::scalar::Field;

/// A program without roots of anything but constants, and an equation of it.
pub(super) struct Rootless {
    pub program: Program,
    pub equation: Equation<Recorded>,
    /// What must vanish: left − right, the terms that are said to vanish, wrong versions that are said to be right, and a − b²
    /// for every root √a that was replaced by b. (b is positive, where the bases are.)
    pub compared: Vec<Recorded>,
    /// What must not vanish: left − right of each version that is wrong, by its name.
    pub wrong: Vec<(String, Vec<Recorded>)>,
}

/// A root at three points: c ∏ b_i^e_i with a constant c.
struct Product {
    constant: Ratio,
    exponents: Vec<i32>,
}

/// How large an exponent may be.
const MOST: i32 = 4;

/// Replaces √a by c ∏ b_i^e_i, if that is what it is at three points; whether it is, is one more identity to be proved. None
/// if it is not.
pub(super) fn replaced(
    program: &Program,
    equation: &Equation<Recorded>,
    bases: &[Recorded],
    variables: &[Variable],
) -> Option<Rootless> {
    let needed = program.needed(equation.numbers());
    let essential = program.needed(essential(equation));
    let all = program.needed(equation.numbers().chain(bases.iter().copied()));
    if is_undefined(program, &essential) {
        return None;
    }
    let samples: Vec<Vec<Ratio>> = (0..3)
        .map(|s| program.run(&all, &sample(variables, s), |_| false))
        .collect::<Option<_>>()?;
    let varies = program.depending(&|k| !variables[k].group.is_empty());
    let mut products: Vec<Option<Product>> = Vec::new();
    for (k, step) in program.steps().iter().enumerate() {
        let wanted = needed[k] && matches!(step, Step::Root(_));
        let found = if wanted && !varies[k] {
            product(k, bases, &samples)
        } else {
            None
        };
        if wanted && essential[k] && found.is_none() {
            return None;
        }
        products.push(found);
    }
    let (program, (equation, compared, wrong)) = record(variables.len(), |inputs| {
        let (mut values, mut compared) = (Vec::new(), Vec::new());
        for (k, step) in program.steps().iter().enumerate() {
            let mut value = Recorded::zero();
            if all[k] {
                value = step.value(inputs, &values);
            }
            if let (Some(product), Step::Root(a)) = (&products[k], step) {
                value = product.of(bases, &values);
                compared.push(values[*a as usize] - value * value);
            }
            values.push(value);
        }
        let equation = equation.map(&|x: Recorded| values[x.place()]);
        compared.extend(vanishing(&equation));
        let wrong = equation.forgeries().into_iter();
        let wrong = wrong.filter(|(_, forged)| forged.vacuous.is_none());
        let wrong = wrong.map(|(name, forged)| (name, equation.difference(&forged.replaced)));
        (equation.clone(), compared, wrong.collect())
    });
    Some(Rootless {
        program,
        equation,
        compared,
        wrong,
    })
}

/// Does it depend on what a position leaves undefined, 1/0?
fn is_undefined(program: &Program, essential: &[bool]) -> bool {
    let zero = |k: u32| program.steps()[k as usize] == Step::Constant(0, 1);
    let steps = program.steps().iter().zip(essential);
    let mut needed = steps.filter(|(_, essential)| **essential);
    needed.any(|(step, _)| matches!(step, Step::Quotient(_, b) if zero(*b)))
}

/// What an equation states is about these numbers.
fn essential(equation: &Equation<Recorded>) -> Vec<Recorded> {
    let terms = equation.terms().flat_map(|t| &t.value);
    let vacuous = equation.forged.iter().filter(|f| f.vacuous.is_some());
    let replaced = vacuous.flat_map(|f| f.replaced.iter().flat_map(|r| &r.1));
    terms.chain(replaced).copied().collect()
}

/// What must vanish.
fn vanishing(equation: &Equation<Recorded>) -> Vec<Recorded> {
    let mut all = equation.difference(&[]);
    for term in equation.terms().filter(|t| t.vanishes.is_some()) {
        all.extend(&term.value);
    }
    for forged in equation.forged.iter().filter(|f| f.vacuous.is_some()) {
        all.extend(equation.difference(&forged.replaced));
    }
    all
}

/// Parameters at different primes, all jets zero.
fn sample(variables: &[Variable], number: usize) -> Vec<Ratio> {
    const PRIMES: [i64; 15] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47];
    let mut primes = PRIMES.iter().cycle().skip(5 * number);
    let value = |v: &Variable| match v.group.as_str() {
        "" => Ratio::from_int(*primes.next().expect("they go round")),
        _ => Ratio::zero(),
    };
    variables.iter().map(value).collect()
}

/// The product that step k is at all samples.
fn product(k: usize, bases: &[Recorded], samples: &[Vec<Ratio>]) -> Option<Product> {
    if samples.iter().any(|s| s[k].is_poison()) {
        return None;
    }
    let mut exponents = vec![-MOST; bases.len()];
    loop {
        let rest = |s: &Vec<Ratio>| {
            let values = bases.iter().map(|b| s[b.place()]);
            s[k] / monomial(values, &exponents)
        };
        let constant = rest(&samples[0]);
        if !constant.is_poison() && samples.iter().all(|s| rest(s) == constant) {
            return Some(Product {
                constant,
                exponents,
            });
        }
        // The next list of exponents.
        let place = exponents.iter().position(|e| *e < MOST)?;
        exponents[..place].fill(-MOST);
        exponents[place] += 1;
    }
}

/// ∏ b_i^e_i.
fn monomial<F: Field>(values: impl Iterator<Item = F>, exponents: &[i32]) -> F {
    let mut product = F::one();
    for (value, e) in values.zip(exponents) {
        for _ in 0..e.abs() {
            product = if *e > 0 {
                product * value
            } else {
                product / value
            };
        }
    }
    product
}

impl Product {
    fn of(&self, bases: &[Recorded], values: &[Recorded]) -> Recorded {
        let constant: Recorded = self.constant.over();
        constant * monomial(bases.iter().map(|b| values[b.place()]), &self.exponents)
    }
}

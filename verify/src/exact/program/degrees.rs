//! How large the degree of a result is, as a polynomial in the inputs: counted along the program, by nobody's hand.
//!
//! Every number is P · ∏ f_i^e_i with whole exponents e_i: P is a polynomial, and the f_i are the polynomials that something
//! is divided by. A sum takes out what both terms have of each f_i. A root of a polynomial of degree d that is no known
//! square has the degree d/2. A result vanishes where P does; multiplied by its conjugates, one for each choice of the roots'
//! signs, P becomes a polynomial without roots, of 2^roots times its degree.

use super::{Program, Recorded, Step};
use std::collections::HashMap;

/// A half, a quarter, … of a degree, as roots of roots have it, are counted in whole numbers of this part of one.
const UNIT: u64 = 1 << 10;

/// The degrees of some results, the largest of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Degrees {
    /// In all inputs together, cleared of denominators, a root counting half of what is under it; rounded up.
    pub total: u64,
    /// In the inputs of each group.
    pub by_group: Vec<u64>,
    /// How many different roots the results contain.
    pub roots: u32,
}

/// Of the results at these places; `groups[k]` is the group of input k.
pub fn degrees(program: &Program, groups: &[usize], results: &[Recorded]) -> Degrees {
    let needed = program.needed(results.iter().copied());
    let factors = Factors::of(program, &needed);
    let largest = |weight: &dyn Fn(usize) -> u64| {
        let degrees = factors.degrees(program, &needed, weight);
        let all = results.iter().map(|r| degrees[r.place()]);
        all.max().unwrap_or(0).div_ceil(UNIT)
    };
    let count = groups.iter().max().map_or(0, |g| g + 1);
    let roots = program.steps().iter().zip(&needed);
    let roots = roots.filter(|(step, needed)| **needed && matches!(step, Step::Root(_)));
    Degrees {
        total: largest(&|_| UNIT),
        by_group: (0..count)
            .map(|g| largest(&|k| if groups[k] == g { UNIT } else { 0 }))
            .collect(),
        roots: roots.count() as u32,
    }
}

/// Exponents e_i by the steps f_i, none of them zero, in the order of the steps.
type Exponents = Vec<(u32, i32)>;

/// Which powers of the divisors each step has for a factor. Different lists of exponents are kept once.
struct Factors {
    lists: Vec<Exponents>,
    numbers: HashMap<Exponents, u32>,
    /// By step, the number of its list.
    of: Vec<u32>,
    /// By step: is something divided by it?
    divides: Vec<bool>,
}

impl Factors {
    fn of(program: &Program, needed: &[bool]) -> Self {
        let steps = program.steps();
        let mut divides = vec![false; steps.len()];
        for (step, _) in steps.iter().zip(needed).filter(|(_, needed)| **needed) {
            if let Step::Quotient(_, b) = step {
                divides[*b as usize] = !matches!(steps[*b as usize], Step::Constant(..));
            }
        }
        let mut all = Self {
            lists: Vec::new(),
            numbers: HashMap::new(),
            of: Vec::with_capacity(steps.len()),
            divides,
        };
        all.number(Vec::new());
        for (k, step) in steps.iter().enumerate() {
            let mut number = if needed[k] { all.taken_out(*step) } else { 0 };
            if all.divides[k] {
                let own = [(k as u32, 1)];
                number = all.merged(number, &own, |a, b| a + b);
            }
            all.of.push(number);
        }
        all
    }

    /// The exponents that a step has from its operands.
    fn taken_out(&mut self, step: Step) -> u32 {
        let of = |k: u32| self.of[k as usize];
        let list = |k: u32| self.lists[of(k) as usize].clone();
        match step {
            Step::Input(_) | Step::Constant(..) => 0,
            Step::Opposite(a) => of(a),
            Step::Sum(a, b) | Step::Difference(a, b) if of(a) == of(b) => of(a),
            Step::Sum(a, b) | Step::Difference(a, b) => self.merged(of(a), &list(b), i32::min),
            Step::Product(a, b) => self.merged(of(a), &list(b), |a, b| a + b),
            Step::Quotient(a, b) => self.merged(of(a), &list(b), |a, b| a - b),
            Step::Root(a) => {
                let halves = list(a).into_iter().map(|(f, e)| (f, e.div_euclid(2)));
                let kept = halves.filter(|(_, e)| *e != 0).collect();
                self.number(kept)
            }
        }
    }

    /// The list whose exponents `f` makes of those of two lists.
    fn merged(&mut self, a: u32, b: &[(u32, i32)], f: fn(i32, i32) -> i32) -> u32 {
        let list = merge(&self.lists[a as usize], b, f);
        self.number(list)
    }

    fn number(&mut self, list: Exponents) -> u32 {
        if let Some(number) = self.numbers.get(&list) {
            return *number;
        }
        let number = self.lists.len() as u32;
        self.lists.push(list.clone());
        self.numbers.insert(list, number);
        number
    }

    /// By step, the degree of P, where input k has the degree `weight(k)`; for a divisor, that of f itself.
    fn degrees(
        &self,
        program: &Program,
        needed: &[bool],
        weight: &dyn Fn(usize) -> u64,
    ) -> Vec<u64> {
        let mut degrees: Vec<u64> = Vec::with_capacity(needed.len());
        for (k, step) in program.steps().iter().enumerate() {
            let degree = if needed[k] {
                self.degree(*step, k, &degrees, weight)
            } else {
                0
            };
            degrees.push(degree);
        }
        degrees
    }

    fn degree(&self, step: Step, k: usize, degrees: &[u64], weight: &dyn Fn(usize) -> u64) -> u64 {
        // A divisor is its own factor, and its P is 1.
        let rest = |a: u32| {
            if self.divides[a as usize] {
                0
            } else {
                degrees[a as usize]
            }
        };
        match step {
            Step::Input(input) => weight(input as usize),
            Step::Constant(..) => 0,
            Step::Opposite(a) => rest(a) + self.excess(a, k, 1, degrees),
            Step::Sum(a, b) | Step::Difference(a, b) => {
                let side = |a: u32| rest(a) + self.excess(a, k, 1, degrees);
                side(a).max(side(b))
            }
            Step::Product(a, b) => rest(a) + rest(b),
            Step::Quotient(a, _) => rest(a),
            Step::Root(a) => (rest(a) + self.excess(a, k, 2, degrees)).div_ceil(2),
        }
    }

    /// The degree of what operand a has of the factors beyond `times` what was taken out for step k.
    fn excess(&self, a: u32, k: usize, times: i32, degrees: &[u64]) -> u64 {
        let list = |k: usize| &self.lists[self.of[k] as usize];
        // A divisor's own factor is not taken out of its operands.
        let taken: Exponents = (list(k).iter().copied())
            .filter(|(f, _)| *f as usize != k)
            .collect();
        let beyond = merge(
            list(a as usize),
            &taken,
            match times {
                1 => |a, b| a - b,
                _ => |a, b| a - 2 * b,
            },
        );
        let degree = |(f, e): &(u32, i32)| u64::from(e.unsigned_abs()) * degrees[*f as usize];
        beyond.iter().map(degree).sum()
    }
}

/// The exponents that `f` makes of those of two lists; those that are missing are 0.
fn merge(a: &[(u32, i32)], b: &[(u32, i32)], f: fn(i32, i32) -> i32) -> Exponents {
    let (mut i, mut j, mut merged) = (0, 0, Vec::new());
    while i < a.len() || j < b.len() {
        let left = a.get(i).map_or(u32::MAX, |x| x.0);
        let right = b.get(j).map_or(u32::MAX, |x| x.0);
        let factor = left.min(right);
        let (mut x, mut y) = (0, 0);
        if left == factor {
            x = a[i].1;
            i += 1;
        }
        if right == factor {
            y = b[j].1;
            j += 1;
        }
        let exponent = f(x, y);
        if exponent != 0 {
            merged.push((factor, exponent));
        }
    }
    merged
}

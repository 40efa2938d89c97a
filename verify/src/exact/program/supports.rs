//! Of which degrees in several groups of inputs the terms of a result can be.

use super::{Program, Recorded, Step};
use std::collections::{BTreeSet, HashMap};

/// The degrees of a monomial in each group.
pub type MultiDegree = Vec<u8>;

/// The multi-degrees that the terms of some results can have, as polynomials in the inputs that belong to one of so many groups. Inputs
/// without a group are parameters: they may occur in any way, under roots and in denominators too.
///
/// Constants are known, and what is multiplied by zero was never recorded, so that the list is short. None where a group's input
/// is divided by or is under a root: the results are no polynomials then.
pub fn supports(
    program: &Program,
    groups: &[Option<usize>],
    count: usize,
    needed: &[bool],
    results: &[Recorded],
) -> Option<BTreeSet<MultiDegree>> {
    let mut table = Table::default();
    let nothing = table.number(BTreeSet::from([vec![0; count]]));
    let mut of: Vec<u32> = Vec::with_capacity(needed.len());
    for (step, needed) in program.steps().iter().zip(needed) {
        let at = |k: u32| of[k as usize];
        let number = match *step {
            _ if !needed => nothing,
            Step::Constant(..) => nothing,
            Step::Input(k) => match groups[k as usize] {
                None => nothing,
                Some(group) => {
                    let mut degree = vec![0; count];
                    degree[group] = 1;
                    table.number(BTreeSet::from([degree]))
                }
            },
            Step::Opposite(a) => at(a),
            Step::Sum(a, b) | Step::Difference(a, b) => table.union(at(a), at(b)),
            Step::Product(a, b) => table.product(at(a), at(b)),
            Step::Quotient(a, b) if at(b) == nothing => at(a),
            Step::Root(a) if at(a) == nothing => nothing,
            Step::Quotient(..) | Step::Root(_) => return None,
        };
        of.push(number);
    }
    let all = results.iter().map(|r| of[r.place()]);
    let all: BTreeSet<u32> = all.collect();
    let sets = all.into_iter().flat_map(|n| table.sets[n as usize].iter());
    Some(sets.cloned().collect())
}

/// Sets of multi-degrees, each kept once, and what was made of two of them.
#[derive(Default)]
struct Table {
    sets: Vec<BTreeSet<MultiDegree>>,
    numbers: HashMap<BTreeSet<MultiDegree>, u32>,
    unions: HashMap<(u32, u32), u32>,
    products: HashMap<(u32, u32), u32>,
}

impl Table {
    fn number(&mut self, set: BTreeSet<MultiDegree>) -> u32 {
        if let Some(number) = self.numbers.get(&set) {
            return *number;
        }
        let number = self.sets.len() as u32;
        self.sets.push(set.clone());
        self.numbers.insert(set, number);
        number
    }

    fn union(&mut self, a: u32, b: u32) -> u32 {
        if a == b {
            return a;
        }
        let pair = (a.min(b), a.max(b));
        if let Some(number) = self.unions.get(&pair) {
            return *number;
        }
        let (one, other) = (&self.sets[a as usize], &self.sets[b as usize]);
        let number = self.number(one.union(other).cloned().collect());
        self.unions.insert(pair, number);
        number
    }

    /// The sums of two multi-degrees, one of each set.
    fn product(&mut self, a: u32, b: u32) -> u32 {
        let pair = (a.min(b), a.max(b));
        if let Some(number) = self.products.get(&pair) {
            return *number;
        }
        let mut sums = BTreeSet::new();
        for x in &self.sets[a as usize] {
            for y in &self.sets[b as usize] {
                sums.insert(x.iter().zip(y).map(|(x, y)| x + y).collect());
            }
        }
        let number = self.number(sums);
        self.products.insert(pair, number);
        number
    }
}

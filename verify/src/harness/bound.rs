//! Why an identity that holds at random elements of a large field holds: its degree, which is counted along its program.

use super::equation::Equation;
use super::scalar::Drawn;
use crate::exact::{Fp, Fq, Program, Recorded, degrees};
use serde::Serialize;

/// A bound of the degree of a claim in the numbers that are drawn for it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Bound {
    /// Of left − right, cleared of denominators, a root counting half of what is under it: of the equation that is worst off.
    pub degree: u64,
    /// In the numbers of each group, the largest over all equations.
    pub by_group: Vec<(String, u64)>,
    /// How many different roots that equation contains.
    pub roots: u32,
    /// How many a draw must have, all equations and forgeries together.
    pub roots_drawn: u32,
}

impl Bound {
    /// Of the equations of a program whose inputs belong to these groups.
    pub(super) fn new(
        program: &Program,
        groups: &[String],
        identities: &[Vec<Recorded>],
        all: &[Recorded],
    ) -> Self {
        let (names, numbers) = numbered(groups);
        let mut bound = Self {
            degree: 1,
            by_group: names.into_iter().map(|name| (name, 0)).collect(),
            roots: 0,
            roots_drawn: degrees(program, &numbers, all).roots,
        };
        for identity in identities {
            let of = degrees(program, &numbers, identity);
            for (known, new) in bound.by_group.iter_mut().zip(of.by_group) {
                known.1 = known.1.max(new);
            }
            if times_signs(of.total, of.roots) > times_signs(bound.degree, bound.roots) {
                (bound.degree, bound.roots) = (of.total, of.roots);
            }
        }
        bound.by_group.retain(|(_, degree)| *degree > 0);
        bound
    }

    /// log₂ of the chance that a false identity survives so many draws from a field with 2^`size_log2` elements.
    ///
    /// Multiplied by its conjugates, one for each choice of signs of its roots, the identity is a polynomial of 2^roots times
    /// the degree, which vanishes at a draw with at most degree/p (Schwartz and Zippel). Of all draws one in 2^roots has the
    /// roots that are asked for: among those the share of zeros may be as many times larger.
    pub fn chance_log2(&self, size_log2: f64, draws: usize) -> f64 {
        let one = times_signs(self.degree, self.roots) + f64::from(self.roots_drawn) - size_log2;
        draws as f64 * one.min(0.0)
    }
}

impl Bound {
    /// The same for so many draws from either field. The chance is that of the draws from one alone: a false identity may hold
    /// modulo the other prime.
    pub(super) fn chance_of_both(&self, of_p: usize, of_q: usize) -> f64 {
        let of_p = self.chance_log2(Fp::SIZE_LOG2, of_p);
        of_p.max(self.chance_log2(Fq::SIZE_LOG2, of_q))
    }
}

/// log₂ of degree · 2^roots.
fn times_signs(degree: u64, roots: u32) -> f64 {
    (degree as f64).log2() + f64::from(roots)
}

/// The names of the groups, each once, and the number of the group of each input.
pub(super) fn numbered(groups: &[String]) -> (Vec<String>, Vec<usize>) {
    let mut names: Vec<String> = Vec::new();
    let mut numbers = Vec::with_capacity(groups.len());
    for group in groups {
        let known = names.iter().position(|name| name == group);
        numbers.push(known.unwrap_or_else(|| {
            names.push(group.clone());
            names.len() - 1
        }));
    }
    (names, numbers)
}

/// left − right of each equation.
pub(super) fn identities(equations: &[Equation<Recorded>]) -> Vec<Vec<Recorded>> {
    equations.iter().map(|e| e.difference(&[])).collect()
}

//! Equations in the normal positions that there are, one after the other.

use super::parts::Parts;
use super::roots::{self, Rootless};
use super::{Proofs, lattice};
use crate::exact::{Recorded, record};
use crate::harness::bound::numbered;
use crate::harness::case::Key;
use crate::harness::equation::Equation;
use regge_curvature::formulas::Formulas;
use std::collections::BTreeSet;

/// An equation in a normal position.
pub(super) struct InPosition<'a> {
    /// Which position.
    pub form: usize,
    /// Which equation, or part of one.
    pub equation: usize,
    /// The parts of all equations.
    pub parts: &'a Parts,
    /// Its program, without roots.
    pub rootless: &'a Rootless,
    /// What the numbers of the position are.
    pub jets: &'a lattice::Jets<'a>,
    /// log₂ of the chance that it may not be brought there.
    pub chance: f64,
}

/// A normal position, and what was found out about it.
struct Place<'a> {
    form: usize,
    chance: f64,
    parts: &'a Parts,
}

impl Proofs {
    /// Brings each equation to one position after the other, until `settle` says that it is settled there. Returns those that
    /// never are.
    pub(super) fn in_positions(
        &self,
        key: Key<'_>,
        formulas: &Formulas,
        settle: &mut dyn FnMut(&InPosition<'_>) -> bool,
    ) -> BTreeSet<usize> {
        let parts = Parts::of(self, key);
        let depends = self.dependences(&parts, formulas);
        let mut open: BTreeSet<usize> = (0..depends.len()).collect();
        for form in 0..self.forms {
            let allowed = |k: &usize| depends[*k].iter().all(|g| (self.allows)(form, g));
            let wanted: BTreeSet<usize> = open.iter().copied().filter(|k| allowed(k)).collect();
            if wanted.is_empty() {
                continue;
            }
            let (wanted, chance) = self.equivariant(form, &wanted, key, formulas, &parts);
            let place = Place {
                form,
                chance,
                parts: &parts,
            };
            for k in self.in_one(&place, &wanted, formulas, settle) {
                open.remove(&k);
            }
        }
        open
    }

    /// Tries these equations in one position; returns those that are settled.
    fn in_one(
        &self,
        place: &Place<'_>,
        wanted: &BTreeSet<usize>,
        formulas: &Formulas,
        settle: &mut dyn FnMut(&InPosition<'_>) -> bool,
    ) -> Vec<usize> {
        let variables = (self.variables)(place.form);
        let groups: Vec<String> = variables.iter().map(|v| v.group.clone()).collect();
        let (names, numbers) = numbered(&groups);
        let jets = lattice::Jets {
            variables: &variables,
            names: &names,
            groups: &numbers,
        };
        let (program, (equations, bases)) = record(variables.len(), |x| {
            let (equations, bases) = self.claim.reduced(place.form, x, formulas);
            (place.parts.cut(&equations), bases)
        });
        let settled = |k: &usize| {
            let rootless = roots::replaced(&program, &equations[*k], &bases, &variables);
            rootless.is_some_and(|rootless| {
                settle(&InPosition {
                    form: place.form,
                    equation: *k,
                    parts: place.parts,
                    rootless: &rootless,
                    jets: &jets,
                    chance: place.chance,
                })
            })
        };
        wanted.iter().copied().filter(settled).collect()
    }

    /// Which groups of numbers the terms of each part of an equation depend on.
    fn dependences(&self, parts: &Parts, formulas: &Formulas) -> Vec<BTreeSet<String>> {
        let groups = (self.groups)();
        let (program, equations) = record(groups.len(), |x| {
            parts.cut(&self.claim.equations(x, formulas))
        });
        let of = |equation: &Equation<Recorded>| {
            let terms = equation.terms().flat_map(|t| &t.value).copied();
            let inputs = program.inputs(&program.needed(terms));
            inputs.into_iter().map(|k| groups[k].clone()).collect()
        };
        equations.iter().map(of).collect()
    }
}

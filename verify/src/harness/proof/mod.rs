//! Proof by a determining set: a claim that is a polynomial holds if it holds at the points of a lattice.
//!
//! Every equation is brought to a normal position where its two sides are polynomials in the jets. That it may be brought
//! there is an identity of its own, which is tested ([`motion`]); which monomials the polynomials can have is found along their
//! program; and the program is run over rational numbers at points that determine such a polynomial ([`lattice`]).

mod elsewhere;
mod lattice;
mod motion;
mod roots;
mod trial;

pub use motion::{Moved, Moves};

use super::bound::numbered;
use super::case::Key;
use super::entry::{Failure, Forgery, Vacuous};
use super::equation::Equation;
use super::proved::Proof;
use crate::exact::{Recorded, record};
use regge_curvature::formulas::Formulas;
use std::collections::BTreeSet;

/// A number of an instance in normal position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// In which group of jets it is; none for a parameter, which is positive and may occur in denominators.
    pub group: String,
    /// Its name.
    pub name: String,
}

/// What is known of a claim for its proof.
#[derive(Clone, Copy, Debug)]
pub struct Proofs {
    /// How many normal positions there are.
    pub forms: usize,
    /// What they are, in words.
    pub describe: fn(usize) -> &'static str,
    /// May an equation that depends on what is drawn by this name be brought to the position?
    pub allows: fn(usize, &str) -> bool,
    /// What each number of an instance in any position is, by name.
    pub groups: fn() -> Vec<String>,
    /// The equations in any position.
    pub equations: fn(&[Recorded], &Formulas) -> Vec<Equation<Recorded>>,
    /// What each number of an instance in normal position is.
    pub variables: fn(usize) -> Vec<Variable>,
    /// The equations there, and the numbers of which roots are products.
    pub reduced: fn(usize, &[Recorded], &Formulas) -> (Vec<Equation<Recorded>>, Vec<Recorded>),
    /// The equations at the same instance in other coordinates, which are fixed.
    pub elsewhere: fn(usize, &[Recorded], &Formulas) -> Vec<Equation<Recorded>>,
    /// How many further numbers a change of coordinates takes; none where nothing is changed.
    pub changes: fn(usize) -> usize,
    /// The equations in two systems of coordinates.
    pub moved: fn(usize, &[Recorded], &Formulas) -> Moved,
}

/// How it went.
pub(super) struct Outcome {
    pub proof: Proof,
    pub forgeries: Vec<Forgery>,
    pub vacuous: Vec<Vacuous>,
    pub failure: Option<Failure>,
}

impl Proofs {
    /// Proves all equations, or says why not.
    pub(super) fn run(&self, key: Key<'_>, formulas: &Formulas) -> Outcome {
        let mut outcome = Outcome {
            proof: Proof {
                points: 0,
                degree: 0,
                equations: Vec::new(),
                motion_log2: f64::NEG_INFINITY,
            },
            forgeries: Vec::new(),
            vacuous: Vec::new(),
            failure: None,
        };
        let depends = self.dependences(formulas);
        let mut open: BTreeSet<usize> = (0..depends.len()).collect();
        for form in 0..self.forms {
            let allowed = |k: &usize| depends[*k].iter().all(|g| (self.allows)(form, g));
            let wanted: BTreeSet<usize> = open.iter().copied().filter(|k| allowed(k)).collect();
            if wanted.is_empty() || outcome.failure.is_some() {
                continue;
            }
            let (wanted, chance) = self.equivariant(form, &wanted, key, formulas);
            for k in self.prove(form, &wanted, formulas, &mut outcome) {
                open.remove(&k);
                outcome.proof.motion_log2 = outcome.proof.motion_log2.max(chance);
            }
        }
        if outcome.failure.is_none() && !open.is_empty() {
            let what = format!("equations {open:?} are polynomials in no position that is known");
            outcome.fail(what, Vec::new());
        }
        outcome
    }

    /// Which groups of numbers the terms of each equation depend on.
    fn dependences(&self, formulas: &Formulas) -> Vec<BTreeSet<String>> {
        let groups = (self.groups)();
        let (program, equations) =
            record(groups.len(), |numbers| (self.equations)(numbers, formulas));
        let of = |equation: &Equation<Recorded>| {
            let terms = equation.terms().flat_map(|t| &t.value).copied();
            let inputs = program.inputs(&program.needed(terms));
            inputs.into_iter().map(|k| groups[k].clone()).collect()
        };
        equations.iter().map(of).collect()
    }

    /// Tries these equations in normal position; returns those that are settled.
    fn prove(
        &self,
        form: usize,
        wanted: &BTreeSet<usize>,
        formulas: &Formulas,
        outcome: &mut Outcome,
    ) -> Vec<usize> {
        let variables = (self.variables)(form);
        let groups: Vec<String> = variables.iter().map(|v| v.group.clone()).collect();
        let (names, numbers) = numbered(&groups);
        let jets = lattice::Jets {
            variables: &variables,
            names: &names,
            groups: &numbers,
        };
        let (program, (equations, bases)) =
            record(variables.len(), |x| (self.reduced)(form, x, formulas));
        let mut settled = Vec::new();
        for k in wanted {
            let rooted = roots::replaced(&program, &equations[*k], &bases, &variables);
            let proved = rooted.and_then(|r| lattice::settle(&r, &jets));
            if let Some(mut result) = proved {
                settled.push(*k);
                self.refute(form, *k, formulas, &variables, &mut result);
                outcome.add(result, (self.describe)(form));
            }
        }
        settled
    }
}

impl Proofs {
    /// What no point in normal position refutes.
    fn refute(
        &self,
        form: usize,
        k: usize,
        formulas: &Formulas,
        variables: &[Variable],
        result: &mut lattice::Settled,
    ) {
        if result.counterexample.is_some() || result.forgeries.iter().all(|f| f.caught) {
            return;
        }
        let (program, equations) = record(variables.len(), |x| (self.elsewhere)(form, x, formulas));
        if !elsewhere::refute(&program, &equations[k], variables, &mut result.forgeries) {
            let what = format!("{}: fails in other coordinates", equations[k].name);
            result.counterexample = Some((what, Vec::new()));
        }
    }
}

impl Outcome {
    fn add(&mut self, mut settled: lattice::Settled, form: &str) {
        settled.proved.position = form.to_owned();
        self.proof.points += settled.proved.points;
        self.proof.degree = self.proof.degree.max(settled.degree);
        self.proof.equations.push(settled.proved);
        self.forgeries.extend(settled.forgeries);
        self.vacuous.extend(settled.vacuous);
        if let Some((what, point)) = settled.counterexample {
            self.fail(what, point);
        }
    }

    fn fail(&mut self, what: String, instance: Vec<String>) {
        self.failure.get_or_insert(Failure {
            case: 0,
            detail: String::new(),
            what,
            instance,
        });
    }
}

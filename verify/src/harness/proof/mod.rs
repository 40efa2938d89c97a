//! Proof by a determining set: a claim that is a polynomial holds if it holds at the points of a lattice.
//!
//! Every equation is brought to a normal position where its two sides are polynomials in the jets. That it may be brought
//! there is an identity of its own, which is tested ([`motion`]); which monomials the polynomials can have is found along their
//! program; and the program is run over rational numbers at points that determine such a polynomial ([`lattice`]).

mod draws;
mod elsewhere;
mod goal;
mod lattice;
mod motion;
mod parts;
mod position;
mod roots;
mod trial;

pub use goal::{Goal, Wrong};
pub use motion::{Moved, Moves};

use super::case::Key;
use super::entry::{Failure, Forgery, Vacuous};
use super::equation::Equation;
use super::proved::Proof;
use crate::exact::{Recorded, record};
use position::InPosition;
use regge_curvature::formulas::Formulas;
use std::fmt::Debug;

/// A number of an instance in normal position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// In which group of jets it is; none for a parameter, which is positive and may occur in denominators.
    pub group: String,
    /// Its name.
    pub name: String,
}

/// The equations of a claim at an instance that is made of these numbers, the library computing by these formulas.
pub trait AtPoints: Debug + Sync {
    /// In any position.
    fn equations(&self, numbers: &[Recorded], formulas: &Formulas) -> Vec<Equation<Recorded>>;

    /// In this normal position, and the numbers of which roots are products.
    fn reduced(
        &self,
        form: usize,
        numbers: &[Recorded],
        formulas: &Formulas,
    ) -> (Vec<Equation<Recorded>>, Vec<Recorded>);

    /// At the same instance in other coordinates, which are fixed.
    fn elsewhere(
        &self,
        form: usize,
        numbers: &[Recorded],
        formulas: &Formulas,
    ) -> Vec<Equation<Recorded>>;

    /// In two systems of coordinates.
    fn moved(&self, form: usize, numbers: &[Recorded], formulas: &Formulas) -> Moved;
}

/// What is known of a claim for its proof.
#[derive(Clone, Copy, Debug)]
pub struct Proofs {
    /// Its equations.
    pub claim: &'static dyn AtPoints,
    /// How many normal positions there are.
    pub forms: usize,
    /// What they are, in words.
    pub describe: fn(usize) -> &'static str,
    /// Is what is drawn by this name of a second metric?
    pub second: fn(&str) -> bool,
    /// May an equation that depends on what is drawn by this name be brought to the position?
    pub allows: fn(usize, &str) -> bool,
    /// What each number of an instance in any position is, by name.
    pub groups: fn() -> Vec<String>,
    /// What each number of an instance in normal position is.
    pub variables: fn(usize) -> Vec<Variable>,
    /// How many further numbers a change of coordinates takes; none where nothing is changed.
    pub changes: fn(usize) -> usize,
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
        let mut outcome = Outcome::default();
        let open = self.in_positions(key, formulas, &mut |at| {
            if outcome.failure.is_some() {
                return false;
            }
            let Some(mut result) = lattice::settle(at.rootless, at.jets) else {
                return false;
            };
            self.refute(at, formulas, &mut result);
            result.proved.equation = at.parts.label(at.equation, &at.rootless.equation);
            outcome.add(result, (self.describe)(at.form), at.chance);
            true
        });
        if outcome.failure.is_none() && !open.is_empty() {
            let what = format!("equations {open:?} are polynomials in no position that is known");
            outcome.fail(what, Vec::new());
        }
        outcome
    }

    /// What there is to be proved, as programs that another judge can read; equations that are polynomials in no position are
    /// left out.
    pub(super) fn goals(&self, key: Key<'_>, formulas: &Formulas) -> Vec<Goal> {
        let mut goals = Vec::new();
        self.in_positions(key, formulas, &mut |at| {
            let polynomial = lattice::is_polynomial(at.rootless, at.jets);
            if polynomial {
                goals.push(Goal::new(at, (self.describe)(at.form)));
            }
            polynomial
        });
        goals
    }
}

impl Proofs {
    /// What no point in normal position refutes.
    fn refute(&self, at: &InPosition<'_>, formulas: &Formulas, result: &mut lattice::Settled) {
        if result.counterexample.is_some() || result.forgeries.iter().all(|f| f.caught) {
            return;
        }
        let variables = at.jets.variables;
        let in_others = |x: &[Recorded]| at.parts.cut(&self.claim.elsewhere(at.form, x, formulas));
        let (program, equations) = record(variables.len(), in_others);
        let equation = &equations[at.equation];
        if !elsewhere::refute(&program, equation, variables, &mut result.forgeries) {
            let what = format!("{}: fails in other coordinates", equation.name);
            result.counterexample = Some((what, Vec::new()));
        }
    }
}

impl Default for Outcome {
    /// Nothing is proved yet.
    fn default() -> Self {
        Self {
            proof: Proof {
                points: 0,
                degree: 0,
                equations: Vec::new(),
                motion_log2: f64::NEG_INFINITY,
            },
            forgeries: Vec::new(),
            vacuous: Vec::new(),
            failure: None,
        }
    }
}

impl Outcome {
    fn add(&mut self, mut settled: lattice::Settled, form: &str, chance: f64) {
        self.proof.motion_log2 = self.proof.motion_log2.max(chance);
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

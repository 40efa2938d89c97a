//! Judges the equations of all cases of one entry, and their forgeries.

use super::equation::{Equation, Forged, Relation, Term, largest};
use super::{Ground, Judgement, Method, Record};
use crate::report::{Entry, Failure, Forgery, Vacuous, Verdict};

/// A wrong forgery margin: a forgery counts as caught when its residual is this many times the tolerance.
const CLEARLY: f64 = 10.0;

/// What happened to one forgery over all cases.
#[derive(Clone, Debug)]
struct Trial {
    name: String,
    somewhere: bool,
    caught: usize,
    missed: usize,
    /// Residual over tolerance: the least one, or the greatest where one catch is enough.
    margin: Option<f64>,
    vacuous: Option<&'static str>,
}

/// Where a case came from, for a message that lets one replay it.
#[derive(Clone, Debug, Default)]
pub struct Case {
    /// Its number.
    pub number: usize,
    /// What else is needed: the degree r, the mesh.
    pub detail: String,
}

/// The cases of one entry, added one by one.
#[derive(Clone, Debug)]
pub struct Tally {
    judgement: Judgement,
    cases: usize,
    worst: f64,
    failure: Option<Failure>,
    trials: Vec<Trial>,
    redraws: usize,
}

impl Tally {
    /// No case yet.
    pub fn new(judgement: Judgement) -> Self {
        Self {
            judgement,
            cases: 0,
            worst: 0.0,
            failure: None,
            trials: Vec::new(),
            redraws: 0,
        }
    }

    /// Notes draws that were thrown away for want of a root.
    pub fn redrawn(&mut self, times: usize) {
        self.redraws += times;
    }

    /// Judges the equations of one case. False if one does not hold.
    pub fn add<B: Ground>(&mut self, case: &Case, equations: &[Equation<B>]) -> bool {
        self.cases += 1;
        let mut holds = true;
        for equation in equations {
            if let Err(what) = self.judge(equation) {
                holds = false;
                self.fail(case, what);
            }
            self.forge(equation);
        }
        holds
    }

    /// Notes a failure that is no residual.
    pub fn fail(&mut self, case: &Case, what: String) {
        self.failure.get_or_insert(Failure {
            case: case.number,
            detail: case.detail.clone(),
            what,
            instance: Vec::new(),
        });
    }

    /// Adds the numbers of the smallest failing instance that was found.
    pub fn shrunk(&mut self, instance: Vec<String>) {
        if let Some(failure) = &mut self.failure {
            failure.instance = instance;
        }
    }

    /// Does the equation hold, and do the terms vanish that are said to?
    fn judge<B: Ground>(&mut self, equation: &Equation<B>) -> Result<(), String> {
        let residual = equation.residual(&[]);
        self.worst = if residual.is_nan() {
            f64::INFINITY
        } else {
            self.worst.max(residual)
        };
        let tolerance = self.judgement.tolerance();
        for term in equation.terms().filter(|t| t.vanishes.is_some()) {
            let size = largest(&term.value) / equation.scale();
            if size.is_nan() || size > tolerance {
                let reason = term.vanishes.unwrap_or_default();
                return Err(format!(
                    "{}: the term {} was declared to vanish ({reason}) and is {size:.1e} of the sum of the terms",
                    equation.name, term.name
                ));
            }
        }
        if residual <= tolerance {
            return Ok(());
        }
        Err(format!(
            "{}: residual {residual:.2e}, allowed {tolerance:.1e}",
            equation.name
        ))
    }

    /// Drops, flips and doubles every term, and tries the forgeries made by hand.
    fn forge<B: Ground>(&mut self, equation: &Equation<B>) {
        let mut forgeries = Vec::new();
        if equation.relation == Relation::Equal {
            for term in equation.terms() {
                for (kind, factor) in [("drop", 0), ("flip", -1), ("double", 2)] {
                    let value = term
                        .value
                        .iter()
                        .map(|x| B::from_int(factor) * *x)
                        .collect();
                    forgeries.push((
                        format!("{}: {kind} {}", equation.name, term.name),
                        Forged {
                            name: "",
                            replaced: vec![(term.name, value)],
                            somewhere: false,
                            vacuous: term.vanishes,
                        },
                    ));
                }
            }
        }
        let by_hand = equation.forged.iter();
        forgeries.extend(by_hand.map(|f| (format!("{}: {}", equation.name, f.name), f.clone())));
        for (name, forged) in forgeries {
            let residual = equation.residual(&forged.replaced);
            self.trial(name, &forged, residual);
        }
    }

    /// Notes one forgery's residual at one case.
    fn trial<B>(&mut self, name: String, forged: &Forged<B>, residual: f64) {
        let tolerance = self.judgement.tolerance();
        let exact = matches!(self.judgement, Judgement::Exact { .. });
        let place = self
            .trials
            .iter()
            .position(|t| t.name == name)
            .unwrap_or_else(|| {
                self.trials.push(Trial {
                    name,
                    somewhere: forged.somewhere,
                    caught: 0,
                    missed: 0,
                    margin: None,
                    vacuous: None,
                });
                self.trials.len() - 1
            });
        let trial = &mut self.trials[place];
        if let Some(reason) = forged.vacuous {
            trial.vacuous = Some(reason);
            // Said to change nothing: then the forged equation holds as well.
            if residual.is_nan() || residual > tolerance {
                let what = format!(
                    "{}: declared vacuous ({reason}), but it is caught",
                    trial.name
                );
                self.fail(
                    &Case {
                        number: self.cases - 1,
                        ..Case::default()
                    },
                    what,
                );
            }
            return;
        }
        let clearly = if matches!(self.judgement, Judgement::Bound | Judgement::Rate) {
            1.0
        } else {
            CLEARLY
        };
        // Written so that NaN is no catch.
        if residual > tolerance * clearly {
            trial.caught += 1;
        } else {
            trial.missed += 1;
        }
        if !exact {
            let margin = residual / tolerance;
            let worse = if trial.somewhere { f64::max } else { f64::min };
            trial.margin = Some(trial.margin.map_or(margin, |m| worse(m, margin)));
        }
    }

    /// The entry of the report.
    pub fn finish(self, record: &Record, dimension: usize, scalar: &str, method: Method) -> Entry {
        let (mut forgeries, mut vacuous) = (Vec::new(), Vec::new());
        for trial in &self.trials {
            match trial.vacuous {
                Some(reason) if trial.caught + trial.missed == 0 => {
                    vacuous.push(Vacuous {
                        name: trial.name.clone(),
                        reason: reason.to_owned(),
                    });
                }
                _ => forgeries.push(Forgery {
                    name: trial.name.clone(),
                    caught: trial.caught > 0 && (trial.somewhere || trial.missed == 0),
                    margin: trial.margin,
                }),
            }
        }
        let passed = self.cases > 0 && self.failure.is_none() && forgeries.iter().all(|f| f.caught);
        Entry {
            label: record.label.to_owned(),
            paper: record.paper.iter().map(|&l| l.to_owned()).collect(),
            dimension,
            scalar: scalar.to_owned(),
            method: method.name().to_owned(),
            cases: self.cases,
            worst_residual: self.worst,
            tolerance: self.judgement.tolerance(),
            verdict: if passed { Verdict::Pass } else { Verdict::Fail },
            forgeries,
            vacuous,
            false_accept_log2: self.judgement.false_accept_log2(self.cases),
            redraws: self.redraws,
            failure: self.failure,
        }
    }
}

impl<B: Ground> Equation<B> {
    fn terms(&self) -> impl Iterator<Item = &Term<B>> {
        self.left.iter().chain(&self.right)
    }

    /// Σ of the terms' magnitudes, never zero; 1 where numbers have no size.
    fn scale(&self) -> f64 {
        if B::METHOD == Method::Exact {
            return 1.0;
        }
        let sum = self.terms().map(|t| largest(&t.value)).sum::<f64>() + self.magnitude;
        if sum == 0.0 { 1.0 } else { sum }
    }

    /// |left − right| over the scale, or left/right; with some terms replaced.
    pub(super) fn residual(&self, replaced: &[(&'static str, Vec<B>)]) -> f64 {
        let side = |terms: &[Term<B>]| -> Vec<B> {
            let mut sum: Vec<B> = Vec::new();
            for term in terms {
                let value = replaced
                    .iter()
                    .find(|r| r.0 == term.name)
                    .map_or(&term.value, |r| &r.1);
                sum.resize(value.len(), B::zero());
                for (s, x) in sum.iter_mut().zip(value) {
                    *s += *x;
                }
            }
            sum
        };
        let (mut left, mut right) = (side(&self.left), side(&self.right));
        let len = left.len().max(right.len());
        left.resize(len, B::zero());
        right.resize(len, B::zero());
        if self.relation == Relation::AtMost {
            return largest(&left) / largest(&right);
        }
        let difference: Vec<B> = left.iter().zip(&right).map(|(l, r)| *l - *r).collect();
        largest(&difference) / self.scale()
    }

    /// Did a root or an inverse not exist?
    pub fn is_poisoned(&self) -> bool {
        let forged = self
            .forged
            .iter()
            .flat_map(|f| f.replaced.iter().flat_map(|r| &r.1));
        self.terms()
            .flat_map(|t| &t.value)
            .chain(forged)
            .any(|x| x.is_poison())
    }
}

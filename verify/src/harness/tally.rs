//! Judges the equations of all cases of one entry, and their forgeries.

use super::entry::{Entry, Failure, Forgery, Vacuous, Verdict};
use super::equation::{Equation, Forged, largest};
use super::judgement::{Judgement, Method};
use super::record::Record;
use super::scalar::Ground;

/// A forgery counts as caught when its residual is this many times the tolerance.
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

impl Trial {
    fn new(name: String, somewhere: bool) -> Self {
        Self {
            name,
            somewhere,
            caught: 0,
            missed: 0,
            margin: None,
            vacuous: None,
        }
    }

    /// Caught or missed, and by how much.
    fn note(&mut self, judgement: Judgement, residual: f64) {
        let clearly = match judgement {
            Judgement::Bound | Judgement::Rate => 1.0,
            _ => CLEARLY,
        };
        // NaN is no catch.
        if residual > judgement.tolerance() * clearly {
            self.caught += 1;
        } else {
            self.missed += 1;
        }
        if judgement.tolerance() > 0.0 {
            let margin = residual / judgement.tolerance();
            let worse = if self.somewhere { f64::max } else { f64::min };
            self.margin = Some(self.margin.map_or(margin, |m| worse(m, margin)));
        }
    }
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
        for term in equation.terms() {
            let Some(reason) = term.vanishes else {
                continue;
            };
            let size = largest(&term.value) / equation.scale();
            if size.is_nan() || size > tolerance {
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

    /// Tries all wrong versions.
    fn forge<B: Ground>(&mut self, equation: &Equation<B>) {
        for (name, forged) in equation.forgeries() {
            let residual = equation.residual(&forged.replaced);
            self.trial(name, &forged, residual);
        }
    }

    /// Notes one forgery's residual at one case.
    fn trial<B>(&mut self, name: String, forged: &Forged<B>, residual: f64) {
        let tolerance = self.judgement.tolerance();
        let place = self
            .trials
            .iter()
            .position(|t| t.name == name)
            .unwrap_or_else(|| {
                self.trials.push(Trial::new(name, forged.somewhere));
                self.trials.len() - 1
            });
        let Some(reason) = forged.vacuous else {
            self.trials[place].note(self.judgement, residual);
            return;
        };
        self.trials[place].vacuous = Some(reason);
        // Said to change nothing: then the forged equation holds as well.
        if residual.is_nan() || residual > tolerance {
            let name = &self.trials[place].name;
            let what = format!("{name}: declared vacuous ({reason}), but it is caught");
            self.fail(
                &Case {
                    number: self.cases - 1,
                    ..Case::default()
                },
                what,
            );
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
                    refuted_at: None,
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
            on_meshes: false,
            cases: self.cases,
            worst_residual: self.worst,
            tolerance: self.judgement.tolerance(),
            verdict: if passed { Verdict::Pass } else { Verdict::Fail },
            forgeries,
            vacuous,
            bound: None,
            proof: None,
            false_accept_log2: None,
            redraws: self.redraws,
            one_method: None,
            few_cases: None,
            failure: self.failure,
        }
    }
}

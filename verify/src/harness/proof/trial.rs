//! What a single point shows: that an equation holds there, and which wrong versions do not.

use super::roots::Rootless;
use crate::exact::{Ratio, Recorded};
use crate::harness::entry::{Forgery, Vacuous};
use crate::harness::equation::{Equation, Forged};
use regge_curvature::scalar::Field;

/// What does not hold, if something does not.
pub(super) type Wrong = Option<String>;

/// One wrong version of an equation.
pub(super) struct Trial {
    name: String,
    /// Why it changes nothing, if it is said to.
    reason: Option<&'static str>,
    refuted_at: Option<String>,
}

impl Trial {
    fn new(name: &str, forged: &Forged<Ratio>) -> Self {
        Self {
            name: name.to_owned(),
            reason: forged.vacuous,
            refuted_at: None,
        }
    }

    /// Is it still to be refuted, or to be seen to change nothing?
    pub fn is_open(&self) -> bool {
        self.refuted_at.is_none()
    }

    pub fn is_vacuous(&self) -> bool {
        self.reason.is_some()
    }

    pub fn forgery(self) -> Forgery {
        Forgery {
            name: self.name,
            caught: self.refuted_at.is_some(),
            margin: None,
            refuted_at: self.refuted_at,
        }
    }

    pub fn vacuous(self) -> Option<Vacuous> {
        let reason = self.reason?.to_owned();
        Some(Vacuous {
            name: self.name,
            reason,
        })
    }
}

/// Do both sides agree, do the terms vanish that are said to, and are the roots what they were taken for?
pub(super) fn judged(rootless: &Rootless, values: &[Ratio]) -> Wrong {
    let zero = |x: &Recorded| values[x.place()] == Ratio::zero();
    if rootless.compared.iter().all(zero) {
        return None;
    }
    let equation = rootless.equation.map(&|x| values[x.place()]);
    let name = equation.name;
    for term in equation.terms() {
        if term.value.iter().any(|x| x.is_poison()) {
            let term = term.name;
            return Some(format!("{name}: {term} is no rational number of 127 bits"));
        }
        if let (Some(reason), Some(x)) = (term.vanishes, first(&term.value)) {
            let term = term.name;
            return Some(format!(
                "{name}: {term} = {x:?} was declared to vanish ({reason})"
            ));
        }
    }
    match first(&equation.difference(&[])) {
        Some(x) => Some(format!("{name}: left − right = {x:?}")),
        None => Some(format!("{name}: a root is not what it was taken for")),
    }
}

/// The first component that does not vanish.
fn first(values: &[Ratio]) -> Option<Ratio> {
    values.iter().copied().find(|x| *x != Ratio::zero())
}

/// Which wrong versions this point refutes. One that was said to change nothing and is refuted is wrong.
pub(super) fn tried(
    here: &Equation<Ratio>,
    trials: &mut Vec<Trial>,
    point: &dyn Fn() -> String,
) -> Wrong {
    let forgeries = here.forgeries();
    if trials.is_empty() {
        trials.extend(
            forgeries
                .iter()
                .map(|(name, forged)| Trial::new(name, forged)),
        );
    }
    for (trial, (name, forged)) in trials.iter_mut().zip(&forgeries) {
        if !trial.is_open() {
            continue;
        }
        let difference = here.difference(&forged.replaced);
        let found = first(&difference).filter(|_| difference.iter().all(|x| !x.is_poison()));
        let Some(x) = found else {
            continue;
        };
        if let Some(reason) = trial.reason {
            return Some(format!(
                "{name}: declared vacuous ({reason}), but it is caught"
            ));
        }
        trial.refuted_at = Some(format!("left − right = {x:?} where {}", point()));
    }
    None
}

//! What a check found: one entry of the report, as data.

use super::bound::Bound;
use super::proved::Proof;
use serde::Serialize;

/// One claim in one dimension by one method.
#[derive(Clone, Debug, Serialize)]
pub struct Entry {
    /// The row of the catalogue.
    pub label: String,
    /// Labels in the paper's LaTeX source.
    pub paper: Vec<String>,
    /// N.
    pub dimension: usize,
    /// What it was computed in.
    pub scalar: String,
    /// AD, exact, oracle or homotopy.
    pub method: String,
    /// Is it about integrals over meshes, and not about a point?
    pub on_meshes: bool,
    /// How many random instances, or points of a proof.
    pub cases: usize,
    /// Over all cases; for a bound the worst left/right.
    pub worst_residual: f64,
    /// What it may be.
    pub tolerance: f64,
    /// Did it hold, and was every forgery caught?
    pub verdict: Verdict,
    /// The forgeries that must be caught here.
    pub forgeries: Vec<Forgery>,
    /// Those that cannot be.
    pub vacuous: Vec<Vacuous>,
    /// The degree of an exact run's identities.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<Bound>,
    /// What a proof rests on.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proof: Option<Proof>,
    /// log₂ of the chance that a false identity was accepted, of exact runs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub false_accept_log2: Option<f64>,
    /// Draws thrown away because a root did not exist.
    pub redraws: usize,
    /// Why no second method checks the claim, if none does.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub one_method: Option<String>,
    /// Why it has few instances, if it has.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub few_cases: Option<String>,
    /// What went wrong, if something did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<Failure>,
}

/// Pass or fail.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// It holds, and every forgery was caught.
    Pass,
    /// It does not.
    Fail,
}

/// A wrong version of the claim.
#[derive(Clone, Debug, Serialize)]
pub struct Forgery {
    /// Equation and what is wrong with it.
    pub name: String,
    /// Was it?
    pub caught: bool,
    /// Its residual over the tolerance, at the instance where it is hardest to see; none where any mismatch
    /// decides.
    pub margin: Option<f64>,
    /// The point that refutes it, where exact numbers do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refuted_at: Option<String>,
}

/// A forgery that changes nothing here.
#[derive(Clone, Debug, Serialize)]
pub struct Vacuous {
    /// Which.
    pub name: String,
    /// Why.
    pub reason: String,
}

/// The first case that failed.
#[derive(Clone, Debug, Serialize)]
pub struct Failure {
    /// Its number.
    pub case: usize,
    /// The degree r, the mesh.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub detail: String,
    /// Equation and residual.
    pub what: String,
    /// The numbers of the smallest failing instance that do not vanish.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub instance: Vec<String>,
}

//! What there is to be proved of an equation in normal position, for a judge from elsewhere.

use super::Variable;
use super::position::InPosition;
use super::roots::Rootless;
use crate::exact::{Program, Ratio, Recorded};
use regge_curvature::scalar::Field;

/// An equation in normal position: a program without roots, and which of its results vanish.
#[derive(Clone, Debug)]
pub struct Goal {
    /// Which equation.
    pub equation: &'static str,
    /// The position.
    pub position: &'static str,
    /// What the inputs are. Parameters are positive.
    pub variables: Vec<Variable>,
    /// What is done with them.
    pub program: Program,
    /// Left − right, component by component, and what else is stated to vanish.
    pub vanishing: Vec<Recorded>,
    /// Wrong versions, each refuted at a point.
    pub wrong: Vec<Wrong>,
}

/// A wrong version of an equation.
#[derive(Clone, Debug)]
pub struct Wrong {
    /// What is wrong.
    pub name: String,
    /// A component of left − right that does not vanish everywhere.
    pub difference: Recorded,
}

impl Goal {
    pub(super) fn new(at: &InPosition<'_>, position: &'static str) -> Self {
        let rootless = at.rootless;
        Self {
            equation: rootless.equation.name,
            position,
            variables: at.jets.variables.to_vec(),
            program: rootless.program.clone(),
            vanishing: rootless.compared.clone(),
            wrong: refuted(rootless, at.jets.variables),
        }
    }
}

/// The wrong versions that a point without zeros refutes, with a component that does not vanish there.
fn refuted(rootless: &Rootless, variables: &[Variable]) -> Vec<Wrong> {
    let numbers: Vec<Ratio> = (0..variables.len())
        .map(|k| Ratio::from_int(1 + (7 * k % 5) as i64))
        .collect();
    let all = rootless.wrong.iter().flat_map(|(_, difference)| difference);
    let needed = rootless.program.needed(all.copied());
    let values = rootless.program.run(&needed, &numbers, |_| false);
    let values = values.expect("nothing is refused");
    let differs = |x: &&Recorded| {
        let value = values[x.place()];
        value != Ratio::zero() && !value.is_poison()
    };
    let of = |(name, difference): &(String, Vec<Recorded>)| {
        Some(Wrong {
            name: name.clone(),
            difference: *difference.iter().find(differs)?,
        })
    };
    rootless.wrong.iter().filter_map(of).collect()
}

//! Wrong versions that are right in normal position, as a trace without g⁻¹ is where g = δ: other coordinates refute them.

use super::Variable;
use crate::exact::{Program, Ratio, Recorded};
use crate::harness::entry::Forgery;
use crate::harness::equation::Equation;
use regge_curvature::scalar::Field;

/// Tries the wrong versions that are left at an instance in other coordinates, one number after the other being 1; parameters
/// are 2. False if the equation itself does not hold there.
pub(super) fn refute(
    program: &Program,
    equation: &Equation<Recorded>,
    variables: &[Variable],
    forgeries: &mut [Forgery],
) -> bool {
    let needed = program.needed(equation.numbers());
    let start = |v: &Variable| Ratio::from_int(if v.group.is_empty() { 2 } else { 0 });
    let origin: Vec<Ratio> = variables.iter().map(start).collect();
    let used = program.inputs(&needed).into_iter();
    let jets: Vec<usize> = used.filter(|k| !variables[*k].group.is_empty()).collect();
    let single = jets
        .iter()
        .map(|k| (vec![*k], format!("{} = 1", variables[*k].name)));
    let first = (Vec::new(), "all jets vanish".to_owned());
    let last = (jets.clone(), "all jets are 1".to_owned());
    for (ones, place) in [first].into_iter().chain(single).chain([last]) {
        if forgeries.iter().all(|f| f.caught) {
            return true;
        }
        let mut numbers = origin.clone();
        for k in ones {
            numbers[k] = Ratio::one();
        }
        let values = program.run(&needed, &numbers, |_| false);
        let values = values.expect("nothing is refused");
        let here = equation.map(&|x| values[x.place()]);
        if here.difference(&[]).iter().any(|x| *x != Ratio::zero()) {
            return false;
        }
        for forgery in forgeries.iter_mut().filter(|f| !f.caught) {
            forgery.refuted_at = refuted(&here, &forgery.name, &place);
            forgery.caught = forgery.refuted_at.is_some();
        }
    }
    true
}

/// Where the wrong version of this name is refuted, if it is here.
fn refuted(here: &Equation<Ratio>, name: &str, place: &str) -> Option<String> {
    let (_, forged) = here
        .forgeries()
        .into_iter()
        .find(|(known, _)| known == name)?;
    let difference = here.difference(&forged.replaced);
    let x = difference
        .iter()
        .find(|x| **x != Ratio::zero() && !x.is_poison())?;
    Some(format!(
        "left − right = {x:?} in other coordinates, where {place} before (parameters are 2)"
    ))
}

//! Equations in parts: what has to do with a second metric, and what has not.

use super::Proofs;
use super::draws::draw;
use crate::exact::{Fp, Program, Recorded, record};
use crate::harness::case::Key;
use crate::harness::equation::{Equation, Term};
use regge_curvature::formulas::PAPER;
use regge_curvature::scalar::Field;

/// What is to be proved, in the order of the equations: each of them, or two parts of it that vanish one by one.
///
/// ⟦II⟧ = II⁺ + II⁻ is an equation between two metrics, but its terms with either are equal among themselves: each part can be
/// brought to a normal position of its own metric. That the parts vanish is seen at one draw, and then proved.
pub(super) struct Parts(Vec<Part>);

struct Part {
    /// The number of the equation.
    equation: usize,
    /// Which of its terms; none if it is not in parts.
    terms: Option<Vec<bool>>,
}

impl Parts {
    /// Of all equations of a claim. That their parts vanish is so by the paper's formulas, whichever are to be proved.
    pub fn of(proofs: &Proofs, key: Key<'_>) -> Self {
        let groups = (proofs.groups)();
        let (program, equations) = record(groups.len(), |x| proofs.claim.equations(x, &PAPER));
        let second = program.depending(&|k| (proofs.second)(&groups[k]));
        let mut parts = Vec::new();
        for (equation, whole) in equations.iter().enumerate() {
            let halves = halves(whole, &second).map(|terms| {
                let of = |terms| Part { equation, terms };
                let others = terms.iter().map(|x| !x).collect();
                [of(Some(others)), of(Some(terms))]
            });
            match halves.filter(|halves| vanish(halves, proofs, key)) {
                Some(halves) => parts.extend(halves),
                None => parts.push(Part {
                    equation,
                    terms: None,
                }),
            }
        }
        Self(parts)
    }

    /// These parts of the equations.
    pub fn cut(&self, equations: &[Equation<Recorded>]) -> Vec<Equation<Recorded>> {
        self.0.iter().map(|part| part.cut(equations)).collect()
    }

    /// What part k is called: the equation's name, and the terms if these are not all.
    pub fn label(&self, k: usize, part: &Equation<Recorded>) -> String {
        if self.0[k].terms.is_none() {
            return part.name.to_owned();
        }
        let terms: Vec<&str> = part.terms().map(|t| t.name).collect();
        format!("{} (the terms {})", part.name, terms.join("; "))
    }
}

impl Part {
    fn cut(&self, equations: &[Equation<Recorded>]) -> Equation<Recorded> {
        let mut part = equations[self.equation].clone();
        let Some(terms) = &self.terms else {
            return part;
        };
        let mut kept = terms.iter();
        let mut is_kept = |_: &Term<Recorded>| *kept.next().expect("there is one for each term");
        part.left.retain(&mut is_kept);
        part.right.retain(&mut is_kept);
        let names: Vec<&str> = part.terms().map(|t| t.name).collect();
        let mut forged = std::mem::take(&mut part.forged);
        forged.retain(|f| f.replaced.iter().all(|r| names.contains(&r.0)));
        part.forged = forged;
        part
    }
}

/// Which terms have to do with a second metric, as these steps have; none if all or no terms do, or if a wrong version changes
/// terms of both kinds.
fn halves(equation: &Equation<Recorded>, second: &[bool]) -> Option<Vec<bool>> {
    let depends = |t: &Term<Recorded>| t.value.iter().any(|x| second[x.place()]);
    let terms: Vec<bool> = equation.terms().map(depends).collect();
    let is_second = |name: &str| {
        let term = equation.terms().find(|t| t.name == name);
        term.is_some_and(depends)
    };
    let one_kind = |kinds: &[bool]| kinds.iter().all(|kind| *kind == kinds[0]);
    let mixed = !one_kind(&terms);
    let apart = equation.forged.iter().all(|f| {
        let kinds: Vec<bool> = f.replaced.iter().map(|r| is_second(r.0)).collect();
        one_kind(&kinds)
    });
    (mixed && apart).then_some(terms)
}

/// Does either half vanish at a draw?
fn vanish(halves: &[Part; 2], proofs: &Proofs, key: Key<'_>) -> bool {
    let count = (proofs.groups)().len();
    let recorded = |x: &[Recorded]| {
        let equations = proofs.claim.equations(x, &PAPER);
        let differences = halves.iter().map(|h| h.cut(&equations).difference(&[]));
        differences.flatten().collect::<Vec<_>>()
    };
    let (program, differences): (Program, Vec<Recorded>) = record(count, recorded);
    let values = draw::<Fp>(&program, count, &differences, key);
    values.is_some_and(|v| differences.iter().all(|x| v[x.place()] == Fp::zero()))
}

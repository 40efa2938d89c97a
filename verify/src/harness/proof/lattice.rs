//! One equation in normal position: the points that determine it, and what is found there.

use super::Variable;
use super::roots::Rootless;
use super::trial::{Trial, judged, tried};
use crate::exact::{
    MultiDegree, Program, Ratio, Recorded, Sparse, degrees, determining, positive, supports,
};
use crate::harness::entry::{Forgery, Vacuous};
use crate::harness::proved::Proved;
use regge_curvature::scalar::Field;
use std::collections::BTreeSet;

/// The numbers of a normal position, and their groups.
pub(super) struct Jets<'a> {
    pub variables: &'a [Variable],
    /// The names of the groups; that of the parameters is empty.
    pub names: &'a [String],
    /// By variable, the number of its group.
    pub groups: &'a [usize],
}

/// What was found at the points.
pub(super) struct Settled {
    pub proved: Proved,
    /// In the jets.
    pub degree: u64,
    pub forgeries: Vec<Forgery>,
    pub vacuous: Vec<Vacuous>,
    /// What does not hold, and where.
    pub counterexample: Option<(String, Vec<String>)>,
}

/// More points than this are not tried.
const MOST: usize = 4_000_000;

/// The equation at the points that determine it; none if it is no polynomial in the jets, or has too many.
pub(super) fn settle(rootless: &Rootless, jets: &Jets<'_>) -> Option<Settled> {
    let (program, equation) = (&rootless.program, &rootless.equation);
    let terms = equation.terms().flat_map(|t| &t.value);
    let essential: Vec<Recorded> = terms.chain(&rootless.compared).copied().collect();
    let needed = program.needed(essential.iter().copied());
    let all = program.needed(essential.iter().copied().chain(equation.numbers()));
    let used = program.inputs(&all);
    let points = Points::new(rootless, &all, jets)?;
    let mut trials: Vec<Trial> = Vec::new();
    let (mut counterexample, mut at) = (None, Vec::new());
    points.visit(jets, &mut |numbers| {
        let open = trials.is_empty() || trials.iter().any(Trial::is_open);
        let values = program.run(if open { &all } else { &needed }, numbers, |_| false);
        let values = values.expect("nothing is refused");
        counterexample = judged(rootless, &values);
        if counterexample.is_none() && open {
            let here = equation.map(&|x| values[x.place()]);
            counterexample = tried(&here, &mut trials, &|| jets.list(&used, numbers).join(", "));
        }
        if counterexample.is_some() {
            at = jets.list(&used, numbers);
        }
        counterexample.is_none()
    });
    Some(points.settled(
        equation.name,
        trials,
        counterexample.map(|what| (what, at)),
        jets,
    ))
}

/// Is what the equation states a polynomial in the jets?
pub(super) fn is_polynomial(rootless: &Rootless, jets: &Jets<'_>) -> bool {
    jets.supports(&rootless.program, &rootless.compared)
        .is_some()
}

impl Jets<'_> {
    /// The number of the group of the parameters.
    fn parameter(&self) -> Option<usize> {
        self.names.iter().position(String::is_empty)
    }

    /// The multi-degrees of results, if they are polynomials in the jets.
    fn supports(&self, program: &Program, results: &[Recorded]) -> Option<BTreeSet<MultiDegree>> {
        let parameter = self.parameter();
        let grouped: Vec<Option<usize>> = (self.groups.iter())
            .map(|g| (Some(*g) != parameter).then_some(*g))
            .collect();
        let needed = program.needed(results.iter().copied());
        supports(program, &grouped, self.names.len(), &needed, results)
    }

    /// The jets that are not zero, and the parameters among these inputs.
    fn list(&self, used: &[usize], numbers: &[Ratio]) -> Vec<String> {
        let named = |k: &usize| format!("{} = {:?}", self.variables[*k].name, numbers[*k]);
        let shown = used.iter().filter(|k| numbers[**k] != Ratio::zero());
        let (parameters, jets): (Vec<usize>, Vec<usize>) =
            shown.partition(|k| self.variables[**k].group.is_empty());
        let mut listed: Vec<String> = jets.iter().map(named).collect();
        if listed.is_empty() {
            listed.push("all jets vanish".to_owned());
        }
        listed.extend(parameters.iter().map(named));
        listed
    }

    /// A product of powers of the groups: `∂g² σ`.
    fn monomial(&self, degree: &MultiDegree) -> String {
        const POWERS: [&str; 10] = ["", "", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"];
        let factors = self.names.iter().zip(degree).filter(|(_, d)| **d > 0);
        let power = |d: u8| POWERS.get(usize::from(d)).copied().unwrap_or("ⁿ");
        let factors: Vec<String> = factors
            .map(|(name, d)| format!("({name}){}", power(*d)))
            .collect();
        if factors.is_empty() {
            return "1".to_owned();
        }
        factors.join(" ")
    }
}

/// A lattice for the parameters and one for the jets.
struct Points {
    parameters: Vec<Sparse>,
    jets: Vec<Sparse>,
    supports: BTreeSet<MultiDegree>,
    /// In the parameters.
    degree: u64,
}

impl Points {
    fn new(rootless: &Rootless, all: &[bool], jets: &Jets<'_>) -> Option<Self> {
        let (program, compared) = (&rootless.program, &rootless.compared);
        let of = |results: &[Recorded]| jets.supports(program, results);
        let parameter = jets.parameter();
        let stated = of(compared)?;
        // A wrong version can have monomials that the right one has not.
        let wrong = rootless.wrong.iter().filter_map(|(_, w)| of(w)).flatten();
        let supports: BTreeSet<MultiDegree> = stated.into_iter().chain(wrong).collect();
        let used = program.inputs(all);
        let mut groups = vec![Vec::new(); jets.names.len()];
        for k in used {
            groups[jets.groups[k]].push(k);
        }
        let (mut degree, mut parameters) = (0, vec![Vec::new()]);
        if let Some(p) = parameter.filter(|p| !groups[*p].is_empty()) {
            degree = degrees(program, jets.groups, compared).by_group[p];
            let most = binomial(degree + groups[p].len() as u64, groups[p].len() as u64);
            if most > MOST as f64 {
                return None;
            }
            parameters = positive(&groups[p], degree);
        }
        let jets = determining(&supports, &groups);
        (parameters.len() * jets.len() <= MOST).then_some(Self {
            parameters,
            jets,
            supports,
            degree,
        })
    }

    /// All points, as long as `visit` wants to go on.
    fn visit(&self, jets: &Jets<'_>, visit: &mut dyn FnMut(&[Ratio]) -> bool) {
        let start = |v: &Variable| {
            if v.group.is_empty() {
                Ratio::one()
            } else {
                Ratio::zero()
            }
        };
        let mut numbers: Vec<Ratio> = jets.variables.iter().map(start).collect();
        for parameters in &self.parameters {
            for (k, x) in parameters {
                numbers[*k] = Ratio::from_int(*x);
            }
            for point in &self.jets {
                for (k, x) in point {
                    numbers[*k] = Ratio::from_int(*x);
                }
                if !visit(&numbers) {
                    return;
                }
                for (k, _) in point {
                    numbers[*k] = Ratio::zero();
                }
            }
        }
    }

    fn settled(
        &self,
        equation: &str,
        trials: Vec<Trial>,
        counterexample: Option<(String, Vec<String>)>,
        jets: &Jets<'_>,
    ) -> Settled {
        let sums = self
            .supports
            .iter()
            .map(|d| d.iter().map(|x| u64::from(*x)).sum());
        let degree: u64 = sums.max().unwrap_or(0);
        let (vacuous, forged): (Vec<Trial>, Vec<Trial>) =
            trials.into_iter().partition(Trial::is_vacuous);
        Settled {
            proved: Proved {
                equation: equation.to_owned(),
                position: String::new(),
                points: self.parameters.len() * self.jets.len(),
                monomials: self.supports.iter().map(|d| jets.monomial(d)).collect(),
                parameters: self.degree,
            },
            degree,
            forgeries: forged.into_iter().map(Trial::forgery).collect(),
            vacuous: vacuous.into_iter().filter_map(Trial::vacuous).collect(),
            counterexample,
        }
    }
}

/// C(n, k), roughly where it is large.
fn binomial(n: u64, k: u64) -> f64 {
    (1..=k).fold(1.0, |product, i| product * (n - k + i) as f64 / i as f64)
}

//! Is an equation the same in all coordinates? Each of its terms must transform as a tensor, which is tested at random elements
//! of two prime fields.

use super::Proofs;
use super::draws::draw;
use super::parts::Parts;
use crate::exact::{Fp, Fq, Program, Recorded, record};
use crate::harness::bound::Bound;
use crate::harness::case::Key;
use crate::harness::equation::Equation;
use crate::harness::scalar::{Drawn, Ground};
use regge_curvature::formulas::Formulas;
use regge_curvature::scalar::Field;
use std::collections::BTreeSet;

/// A change of coordinates x = A y.
#[derive(Clone, Debug)]
pub struct Moves<B> {
    /// A, row by row.
    pub matrix: Vec<B>,
    /// A⁻¹.
    pub inverse: Vec<B>,
    /// Factors by powers of which densities and covectors that are not normalised change.
    pub scales: Vec<B>,
}

/// A claim in two systems of coordinates.
pub struct Moved {
    /// In x.
    pub before: Vec<Equation<Recorded>>,
    /// In y.
    pub after: Vec<Equation<Recorded>>,
    /// The change.
    pub moves: Moves<Recorded>,
}

impl Moved {
    /// These parts of the equations.
    fn cut(self, parts: &Parts) -> Self {
        Self {
            before: parts.cut(&self.before),
            after: parts.cut(&self.after),
            moves: self.moves,
        }
    }
}

/// How the components of all terms of an equation change.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Kind {
    /// By index, whether it is a lower one; none for invariants, however many.
    lower: Vec<bool>,
    /// The exponents of the factors.
    weights: Vec<i32>,
}

/// The largest exponent of a factor, either way.
const WEIGHT: i32 = 2;
/// The largest rank of a tensor.
const RANK: usize = 3;
/// How many draws from either field must agree.
const DRAWS: usize = 4;

impl Proofs {
    /// Those of these equations whose terms change as tensors do, and log₂ of the chance that one does not and was not noticed.
    pub(super) fn equivariant(
        &self,
        form: usize,
        wanted: &BTreeSet<usize>,
        key: Key<'_>,
        formulas: &Formulas,
        parts: &Parts,
    ) -> (BTreeSet<usize>, f64) {
        let extra = (self.changes)(form);
        if extra == 0 {
            return (wanted.clone(), f64::NEG_INFINITY);
        }
        let mut groups = (self.groups)();
        groups.extend(std::iter::repeat_n("A".to_owned(), extra));
        let in_both = |x: &[Recorded]| self.claim.moved(form, x, formulas).cut(parts);
        let (program, moved) = record(groups.len(), in_both);
        let kinds = kinds(&program, groups.len(), &moved, wanted, key);
        let (program, differences) = record(groups.len(), |x| {
            let moved = in_both(x);
            let of = |(k, kind): &(usize, Kind)| kind.differences(&moved, *k);
            kinds.iter().map(of).collect::<Vec<_>>()
        });
        let mut equivariant = BTreeSet::new();
        let mut chance = f64::NEG_INFINITY;
        for ((k, _), difference) in kinds.iter().zip(&differences) {
            let bound = Bound::new(
                &program,
                &groups,
                std::slice::from_ref(difference),
                difference,
            );
            if vanishes::<Fp>(&program, groups.len(), difference, key)
                && vanishes::<Fq>(&program, groups.len(), difference, key)
            {
                equivariant.insert(*k);
                chance = chance.max(bound.chance_of_both(DRAWS, DRAWS));
            }
        }
        (equivariant, chance)
    }
}

/// Does everything vanish at all draws?
fn vanishes<B: Drawn>(
    program: &Program,
    inputs: usize,
    results: &[Recorded],
    key: Key<'_>,
) -> bool {
    (0..DRAWS).all(|case| {
        let key = Key { case, ..key };
        let values = draw::<B>(program, inputs, results, key);
        values.is_some_and(|v| results.iter().all(|r| v[r.place()] == B::zero()))
    })
}

/// The kind of each equation that has one, as one draw shows it.
fn kinds(
    program: &Program,
    inputs: usize,
    moved: &Moved,
    wanted: &BTreeSet<usize>,
    key: Key<'_>,
) -> Vec<(usize, Kind)> {
    let terms =
        |e: &Equation<Recorded>| e.terms().flat_map(|t| t.value.clone()).collect::<Vec<_>>();
    let moves = &moved.moves;
    let changes = [&moves.matrix, &moves.inverse, &moves.scales]
        .map(Vec::as_slice)
        .concat();
    let mut found = Vec::new();
    for k in wanted {
        let (before, after) = (&moved.before[*k], &moved.after[*k]);
        let all = [terms(before), terms(after), changes.clone()].concat();
        let Some(values) = draw::<Fp>(program, inputs, &all, key) else {
            continue;
        };
        let at = |x: Recorded| values[x.place()];
        let here = Moves {
            matrix: moves.matrix.iter().map(|x| at(*x)).collect(),
            inverse: moves.inverse.iter().map(|x| at(*x)).collect(),
            scales: moves.scales.iter().map(|x| at(*x)).collect(),
        };
        let (before, after) = (before.map(&at), after.map(&at));
        let fits = |kind: &Kind| {
            kind.between(&before, &after, &here)
                .iter()
                .all(|x| *x == Fp::zero())
        };
        let kind = Kind::all(&here, &before).into_iter().find(fits);
        found.extend(kind.map(|kind| (*k, kind)));
    }
    found
}

impl Kind {
    /// All that the terms of an equation can have by the number of their components.
    fn all(moves: &Moves<Fp>, equation: &Equation<Fp>) -> Vec<Self> {
        let dimension = moves.matrix.len().isqrt();
        let fits = |rank: usize| {
            equation
                .terms()
                .all(|t| t.value.len() == dimension.pow(rank as u32))
        };
        let mut indices = vec![Vec::new()];
        for rank in (1..=RANK).filter(|r| fits(*r)) {
            indices.extend(
                (0..1 << rank).map(|bits: usize| {
                    (0..rank).map(|i| bits >> i & 1 == 1).collect::<Vec<bool>>()
                }),
            );
        }
        let mut weights = vec![Vec::new()];
        for _ in &moves.scales {
            let more = |w: &Vec<i32>| {
                let longer = |e: i32| [w.as_slice(), &[e]].concat();
                (-WEIGHT..=WEIGHT).map(longer).collect::<Vec<_>>()
            };
            weights = weights.iter().flat_map(more).collect();
        }
        // What does not change at all comes first.
        weights.sort_by_key(|w| w.iter().map(|e| e.abs()).sum::<i32>());
        let with = |lower: &Vec<bool>| {
            let kind = |w: &Vec<i32>| Self {
                lower: lower.clone(),
                weights: w.clone(),
            };
            weights.iter().map(kind).collect::<Vec<_>>()
        };
        indices.iter().flat_map(with).collect()
    }

    /// What must vanish for equation k.
    fn differences(&self, moved: &Moved, k: usize) -> Vec<Recorded> {
        self.between(&moved.before[k], &moved.after[k], &moved.moves)
    }

    /// The terms after, minus what the terms before are changed to.
    fn between<B: Ground>(
        &self,
        before: &Equation<B>,
        after: &Equation<B>,
        moves: &Moves<B>,
    ) -> Vec<B> {
        let mut factor = B::one();
        for (scale, e) in moves.scales.iter().zip(&self.weights) {
            for _ in 0..e.abs() {
                factor = if *e > 0 {
                    factor * *scale
                } else {
                    factor / *scale
                };
            }
        }
        let mut all = Vec::new();
        for (x, y) in before.terms().zip(after.terms()) {
            let changed = self.changed(&x.value, moves);
            all.extend(
                changed
                    .into_iter()
                    .zip(&y.value)
                    .map(|(x, y)| *y - factor * x),
            );
        }
        all
    }

    /// Components in other coordinates, index by index.
    fn changed<B: Field>(&self, components: &[B], moves: &Moves<B>) -> Vec<B> {
        let n = moves.matrix.len().isqrt();
        let mut all = components.to_vec();
        for (place, lower) in self.lower.iter().enumerate() {
            let stride = n.pow(place as u32);
            let old = all.clone();
            for (k, x) in all.iter_mut().enumerate() {
                let (index, start) = (k / stride % n, k - k / stride % n * stride);
                *x = B::zero();
                for other in 0..n {
                    // T'_k = A_ak T_a, T'^k = (A⁻¹)_ka T^a.
                    let entry = match lower {
                        true => moves.matrix[other * n + index],
                        false => moves.inverse[index * n + other],
                    };
                    *x += entry * old[start + other * stride];
                }
            }
        }
        all
    }
}

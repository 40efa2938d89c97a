//! Pairing: what the numbers that a cell has of a density give with the test functions. It knows nothing of geometry.

use super::Rules;
use super::measure::Part;
use super::seen::{Sites, weights};
use crate::quadrature::Rule;
use crate::scalar::Real;
use crate::spaces::{TestSpace, Value};

/// The traces of a test space at the points of the rules, and what a cell's numbers give with them.
pub(super) struct Pairing<T> {
    /// How many functions live on a cell.
    len: usize,
    /// By codimension; None where the measure has no density.
    traces: [Option<Tables<T>>; 3],
}

/// The traces on the simplices of one codimension.
struct Tables<T> {
    /// By polynomial, then by block: weight times value; summed up where one block stands for all.
    basis: Vec<Vec<T>>,
    /// By place, then by direction and polynomial: which function of the cell.
    numbers: Vec<Vec<usize>>,
}

impl<T: Real> Tables<T> {
    fn new<V: Value, const N: usize>(
        space: &dyn TestSpace<N, Value = V>,
        sites: &Sites,
        rule: &Rule,
        part: &Part,
    ) -> Self {
        let traces: Vec<_> = sites.vertices.iter().map(|on| space.trace(on)).collect();
        let values = traces[0].basis.tabulate::<T>(rule.points());
        let mut basis = vec![vec![T::zero(); part.blocks]; values[0].len()];
        for (block, (row, weight)) in values.iter().zip(weights::<T>(rule)).enumerate() {
            for (basis, value) in basis.iter_mut().zip(row) {
                basis[block.min(part.blocks - 1)] += *value * weight;
            }
        }
        Self {
            basis,
            numbers: traces.into_iter().map(|trace| trace.numbers).collect(),
        }
    }

    /// Calls `add` with the integral of the densities on a simplex against each polynomial, by direction.
    #[inline]
    fn integrals(&self, densities: &[T], mut add: impl FnMut(usize, T)) {
        let directions = densities.len() / self.basis[0].len();
        for direction in 0..directions {
            for (p, basis) in self.basis.iter().enumerate() {
                let sum = match directions {
                    1 => product(densities.iter(), basis),
                    _ => product(densities[direction..].iter().step_by(directions), basis),
                };
                add(direction * self.basis.len() + p, sum);
            }
        }
    }

    /// Adds the integrals of a cell's densities against the traces, by function of the cell.
    fn add(&self, part: &Part, densities: &[T], acc: &mut [T]) {
        let places = densities[part.start..].chunks_exact(part.blocks * part.directions);
        for (numbers, densities) in self.numbers.iter().zip(places) {
            self.integrals(densities, |i, sum| acc[numbers[i]] += sum);
        }
    }
}

impl<T: Real> Pairing<T> {
    pub fn new<V: Value, const N: usize>(
        space: &dyn TestSpace<N, Value = V>,
        sites: &[Sites; 3],
        rules: &Rules,
        parts: &[Part; 3],
    ) -> Self {
        let rules = [&rules.cells, &rules.faces, &rules.hinges];
        let tables = |c: usize| Tables::new(space, &sites[c], rules[c], &parts[c]);
        Self {
            len: space.cell_len(),
            traces: std::array::from_fn(|c| parts[c].present.then(|| tables(c))),
        }
    }

    /// How long a cell's row is: an entry for each function in each of the two sums over cells and faces that are there.
    pub fn width(&self) -> usize {
        self.len * self.traces[..2].iter().flatten().count()
    }

    /// The entries of these two sums for the functions of a cell.
    pub fn row(&self, parts: &[Part; 3], densities: &[T], acc: &mut Vec<T>, row: &mut [T::Sum]) {
        acc.clear();
        acc.resize(self.width(), T::zero());
        let present =
            (self.traces[..2].iter().zip(parts)).filter_map(|(t, part)| Some((t.as_ref()?, part)));
        for ((traces, part), acc) in present.zip(acc.chunks_exact_mut(self.len)) {
            traces.add(part, densities, acc);
        }
        reduce(acc, row);
    }

    /// Which of the functions of a cell have a trace on the hinge at this place, by direction and polynomial.
    pub fn on_hinge(&self, place: usize) -> &[usize] {
        let [_, _, hinges] = &self.traces;
        hinges.as_ref().map_or(&[], |hinges| &hinges.numbers[place])
    }

    /// The entries of the sum over hinges for these functions.
    pub fn hinge_row(&self, densities: &[T], acc: &mut Vec<T>, row: &mut [T::Sum]) {
        acc.clear();
        acc.resize(row.len(), T::zero());
        if let [_, _, Some(hinges)] = &self.traces {
            hinges.integrals(densities, |i, sum| acc[i] = sum);
        }
        reduce(acc, row);
    }
}

/// Σ aᵢ bᵢ.
#[inline(always)]
fn product<'a, T: Real>(a: impl Iterator<Item = &'a T>, b: &[T]) -> T {
    let mut sum = T::zero();
    for (a, b) in a.zip(b) {
        sum.add_product(*a, *b);
    }
    sum
}

fn reduce<T: Real>(acc: &[T], row: &mut [T::Sum]) {
    for (entry, sum) in row.iter_mut().zip(acc) {
        *entry = sum.reduce();
    }
}

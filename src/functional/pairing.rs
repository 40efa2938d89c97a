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
    /// By block, then by polynomial: weight times value; summed up where one block stands for all.
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
        let weights = weights::<T>(rule);
        let mut basis = traces[0].basis.tabulate::<T>(rule.points());
        for (row, weight) in basis.iter_mut().zip(weights) {
            row.iter_mut().for_each(|b| *b *= weight);
        }
        while basis.len() > part.blocks {
            let last = basis.pop().expect("there is a block at least");
            let first = basis[0].iter_mut();
            first.zip(last).for_each(|(sum, b)| *sum += b);
        }
        Self {
            basis,
            numbers: traces.into_iter().map(|trace| trace.numbers).collect(),
        }
    }

    /// Adds the integrals of a hinge's densities against the traces, by direction and polynomial.
    fn add_alone(&self, densities: &[T], acc: &mut [T]) {
        let directions = densities.len() / self.basis.len();
        for (basis, densities) in self.basis.iter().zip(densities.chunks_exact(directions)) {
            for (acc, density) in acc.chunks_exact_mut(basis.len()).zip(densities) {
                for (a, b) in acc.iter_mut().zip(basis) {
                    *a += *density * *b;
                }
            }
        }
    }

    /// Adds the integrals of a cell's densities against the traces, by function of the cell.
    fn add(&self, part: &Part, densities: &[T], acc: &mut [T]) {
        let mut densities = densities[part.start..].iter();
        for numbers in &self.numbers {
            for basis in &self.basis {
                for (numbers, density) in numbers.chunks_exact(basis.len()).zip(&mut densities) {
                    for (&number, b) in numbers.iter().zip(basis) {
                        acc[number] += *density * *b;
                    }
                }
            }
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
            hinges.add_alone(densities, acc);
        }
        reduce(acc, row);
    }
}

fn reduce<T: Real>(acc: &[T], row: &mut [T::Sum]) {
    for (entry, sum) in row.iter_mut().zip(acc) {
        *entry = sum.reduce();
    }
}

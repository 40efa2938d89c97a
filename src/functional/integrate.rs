//! Integrals over the simplices of a mesh of a density that every cell around sees for itself.

use super::seen::weights;
use crate::mesh::Side;
use crate::parallel::rows_in_order;
use crate::quadrature::Rule;
use crate::scalar::{Field, Real};
use crate::simplex::subsets;
use crate::spaces::{Scalar, TestSpace};

/// Σ_D Σ_{T ⊃ D} ∫_D q_T v dμ for every test function v, D from a list of k-simplices and dμ the coordinate measure.
///
/// `density(D, side, block)` is q as the cell `side.cell` sees it, at a block of the rule's points on its k-simplex
/// `side.place` (1 cell when k = N, 2 when D is an interior face). With v = 1 on both sides of a face it integrates
/// the paper's jump ⟦q⟧, the sum of both sides.
pub fn integrate<T: Real, const N: usize>(
    space: &impl TestSpace<N, Value = Scalar>,
    k: usize,
    rule: &Rule,
    simplices: impl Iterator<Item = usize>,
    density: impl Fn(usize, Side, usize) -> T + Sync,
) -> Vec<T::Sum> {
    over(space, k, rule, &simplices.collect::<Vec<_>>(), &density)
}

fn over<T: Real, const N: usize>(
    space: &dyn TestSpace<N, Value = Scalar>,
    k: usize,
    rule: &Rule,
    simplices: &[usize],
    density: &(dyn Fn(usize, Side, usize) -> T + Sync),
) -> Vec<T::Sum> {
    let (mesh, places) = (space.mesh(), subsets(N + 1, k + 1));
    let traces: Vec<_> = places.iter().map(|on| space.trace(on)).collect();
    let basis = traces[0].basis.tabulate::<T>(rule.points());
    let weights = weights::<T>(rule);
    let on_simplex = |i: usize, row: &mut [T::Sum], acc: &mut Vec<T>| {
        acc.clear();
        acc.resize(row.len(), T::zero());
        let own = [mesh.first_side(k, simplices[i])];
        let around: Vec<Side> = match k == N {
            true => own.to_vec(),
            false => mesh.star(k, simplices[i]).collect(),
        };
        for side in around {
            for (block, weight) in weights.iter().enumerate() {
                let weighted = density(simplices[i], side, block) * *weight;
                for (a, b) in acc.iter_mut().zip(&basis[block]) {
                    *a += weighted * *b;
                }
            }
        }
        for (entry, sum) in row.iter_mut().zip(acc) {
            *entry = sum.reduce();
        }
    };
    let (mut sum, zero) = (vec![T::Sum::zero(); space.len()], T::Sum::zero());
    let (width, mut dofs) = (basis[0].len(), Vec::new());
    let add = |i: usize, row: &[T::Sum]| {
        let side = mesh.first_side(k, simplices[i]);
        dofs.clear();
        space.push_dofs(side.cell, &mut dofs);
        for (&number, value) in traces[side.place].numbers.iter().zip(row) {
            sum[dofs[number]] += *value;
        }
    };
    rows_in_order(simplices.len(), width, zero, Vec::new, on_simplex, add);
    sum
}

//! Integrals over the simplices of a mesh of a density that every cell around sees for itself.

use super::site::{Sites, sum_over};
use crate::mesh::Side;
use crate::quadrature::Rule;
use crate::scalar::Real;
use crate::spaces::Lagrange;

/// Σ_D Σ_{T ⊃ D} ∫_D q_T v dμ for every basis function v, D from a list of k-simplices and dμ the coordinate measure.
///
/// `density(D, side, block)` is q as the cell `side.cell` sees it, at a block of the rule's points on its k-simplex
/// `side.place` (1 cell when k = N, 2 when D is an interior face). With v = 1 on both sides of a face it integrates
/// the paper's jump ⟦q⟧, the sum of both sides.
pub fn integrate<T: Real, const N: usize>(
    space: &Lagrange<N>,
    k: usize,
    rule: &Rule,
    simplices: impl Iterator<Item = usize>,
    density: impl Fn(usize, Side, usize) -> T + Sync,
) -> Vec<T::Sum> {
    let mesh = space.mesh();
    let sites = Sites::<T>::new(k, rule, space);
    sum_over(space, &sites, simplices, |simplex, acc| {
        let around: Vec<Side> = if k == N {
            vec![mesh.first_side(N, simplex)]
        } else {
            mesh.star(k, simplex).collect()
        };
        for side in around {
            for block in 0..sites.weights.len() {
                sites.accumulate(block, density(simplex, side, block), acc);
            }
        }
    })
}

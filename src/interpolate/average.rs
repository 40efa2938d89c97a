//! The average of the paper's appendix: canonical degrees of freedom, averaged over the cells that share them.
//!
//! The local L² projections ḡ of g are not single-valued on faces. On every cell around a simplex D they have a
//! ℓ_{D,ab,β}(ḡ) of their own; the interpolant has the mean of these.

use super::canonical::Canonical;
use crate::parallel::in_order;
use crate::spaces::ReggeSpace;

/// The coefficients of the Regge function whose degrees of freedom are the means of those of the given local
/// polynomials, `[cell][edge][α]`.
pub(super) fn coefficients<const N: usize>(space: &ReggeSpace<N>, cells: &[Vec<f64>]) -> Vec<f64> {
    let canonical = Canonical::new(space);
    let means = means(space, &canonical, cells);
    canonical.solve(&means)
}

/// The degrees of freedom of the given local polynomials, averaged over the cells that share them.
fn means<const N: usize>(
    space: &ReggeSpace<N>,
    canonical: &Canonical<N>,
    cells: &[Vec<f64>],
) -> Vec<f64> {
    let (mut means, mut shares) = (vec![0.0; space.len()], vec![0.0; space.len()]);
    let of_cell = |cell: usize| {
        let mut list = Vec::with_capacity(cells[cell].len());
        canonical.of_cell(cell, &cells[cell], |dof, value| list.push((dof, value)));
        list
    };
    in_order(cells.len(), of_cell, |_, list| {
        for (dof, value) in list {
            means[dof] += value;
            shares[dof] += 1.0;
        }
    });
    for (mean, share) in means.iter_mut().zip(shares) {
        *mean /= share;
    }
    means
}

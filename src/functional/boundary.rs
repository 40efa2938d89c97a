//! What the boundary adds to the curvature: the terms that make Gauss' and Bonnet's total 4πχ.

use super::local::{Sides, Wedges};
use super::site::{Sites, sum_over};
use super::{Rules, Sums};
use crate::field::TensorField;
use crate::mesh::Mesh;
use crate::scalar::Real;
use crate::spaces::Lagrange;

/// 2 Σ_{F⊂∂Ω} ∫ H v ω_F + 2 Σ_{S⊂∂Ω} ∫ (π − Σ_T θ_ST) v ω_S for every basis function v; the sum over cells is empty.
///
/// H is that of the outward normal. Added to [`distributional_curvature`](super::distributional_curvature), it makes
/// the total at v = 1 equal to 4πχ when N = 2 (Gauss and Bonnet), on every triangle and so for every Regge metric; for
/// N ≥ 3 they are twice the terms of Gibbons, Hawking and York with the corners of Hartle and Sorkin.
pub fn boundary_curvature<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    let mut sums = Sums::zero(space.len());
    if !g.is_constant() {
        sums.faces = mean_curvature_sum::<T, N, G>(g, space, rules);
    }
    sums.hinges = corner_sum::<T, N, G>(g, space, rules);
    sums
}

fn outer<const N: usize>(mesh: &Mesh<N>, k: usize) -> impl Iterator<Item = usize> + '_ {
    (0..mesh.count(k)).filter(move |&s| !mesh.is_interior(k, s))
}

fn mean_curvature_sum<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Vec<T::Sum> {
    let mesh = space.mesh();
    let sites = Sites::<T>::new(N - 1, &rules.faces, space);
    let sides = Sides::<T, N, G>::new(g, &rules.faces);
    sum_over(space, &sites, outer(mesh, N - 1), |face, acc| {
        let side = mesh.first_side(N - 1, face);
        let local = g.on_cell(side.cell);
        for block in 0..sites.weights.len() {
            let h = sides.mean_curvature(&local, side, block);
            sites.accumulate(block, h + h, acc);
        }
    })
}

fn corner_sum<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Vec<T::Sum> {
    let mesh = space.mesh();
    let sites = Sites::<T>::new(N - 2, &rules.hinges, space);
    let wedges = Wedges::<T, N, G>::new(g, &rules.hinges);
    let pi = T::from_f64(std::f64::consts::PI);
    sum_over(space, &sites, outer(mesh, N - 2), |hinge, acc| {
        let around = wedges.around(mesh, hinge);
        for (block, (angle, omega_s)) in around.into_iter().enumerate() {
            let rest = pi - angle;
            sites.accumulate(block, (rest + rest) * omega_s, acc);
        }
    })
}

//! The distributional densitized scalar curvature. Paper: def:distcurv.

use super::site::{Sites, sum_over};
use super::{Rules, Sums};
use crate::field::TensorField;
use crate::formulas::{Formulas, Paper};
use crate::hinge::Hinge;
use crate::hypersurface::{self, Normal};
use crate::jet::Jet1;
use crate::lagrange::Lagrange;
use crate::linalg::{Vector, inverse_and_det};
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::riemann::Connection;
use crate::scalar::Real;

/// ⟨(Rω)_dist(g), v⟩ = Σ_T ∫ R v ω + 2 Σ̊_F ∫ ⟦H⟧ v ω_F + 2 Σ̊_S ∫ Θ_S v ω_S for every basis function v.
///
/// Functions that do not vanish on the boundary are tested as they are: no boundary term is added.
/// Paper: def:distcurv.
pub fn distributional_curvature<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<'_, N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    distributional_curvature_with::<Paper, T, N, G>(g, space, rules)
}

/// [`distributional_curvature`] by the formulas K.
pub fn distributional_curvature_with<K: Formulas, T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<'_, N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    let mut sums = Sums::zero(space.len());
    if !g.is_constant() {
        sums.element = smooth_curvature(g, space, &rules.element);
        sums.face = face_sum::<K, T, N, G>(g, space, &rules.face);
    }
    sums.hinge = hinge_sum::<K, T, N, G>(g, space, &rules.hinge);
    sums
}

/// Σ_T ∫_T R v ω for every basis function v: all of ⟨(Rω)(g), v⟩ when g is smooth on the whole domain.
pub fn smooth_curvature<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<'_, N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let sites = Sites::<T>::new(N, rule, space);
    let table = g.tabulate(rule.points());
    sum_over(space, &sites, 0..space.mesh().cells(), |cell, acc| {
        let local = g.on_cell(cell);
        for block in 0..sites.weights.len() {
            let connection = Connection::new(&g.jet2(&local, &table, block));
            let omega = connection.det.value.sqrt();
            sites.accumulate(block, connection.scalar() * omega, acc);
        }
    })
}

/// 2 Σ̊_F ∫ ⟦H⟧ v ω_F: H from both cells, each with its own outward normal.
fn face_sum<K: Formulas, T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<'_, N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let mesh = space.mesh();
    let sites = Sites::<T>::new(N - 1, rule, space);
    let tables = sites.tables(g);
    sum_over(space, &sites, mesh.interior_faces(), |face, acc| {
        for side in mesh.star(N - 1, face) {
            let local = g.on_cell(side.cell);
            let nu = sites.outward::<N>(side.place)[0];
            for block in 0..sites.weights.len() {
                let connection = Connection::new(&g.jet1(&local, &tables[side.place], block));
                let density = densitized_mean_curvature::<K, T, N>(&connection, &nu);
                sites.accumulate(block, density * K::face_factor(), acc);
            }
        }
    })
}

/// H ω_F of the plane {λ_f = 0} with constant covector ν, on one side.
pub(super) fn densitized_mean_curvature<K: Formulas, T: Real, const N: usize>(
    connection: &Connection<T, N>,
    nu: &Vector<T, N>,
) -> T {
    let normal = Normal::new(&connection.inverse, nu);
    let second_form = K::second_form(connection, &nu.map(Jet1::constant), &normal);
    hypersurface::mean_curvature(&normal, &second_form) * normal.length * connection.det.sqrt()
}

/// 2 Σ̊_S ∫ Θ_S v ω_S.
fn hinge_sum<K: Formulas, T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<'_, N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let sites = Sites::<T>::new(N - 2, rule, space);
    let around = Around::<T, N, G>::new(g, &sites);
    sum_over(
        space,
        &sites,
        space.mesh().interior_hinges(),
        |hinge, acc| {
            let defects = around.angle_defect::<K>(space, hinge);
            for (block, (defect, omega_s)) in defects.into_iter().enumerate() {
                sites.accumulate(block, defect * omega_s * K::hinge_factor(), acc);
            }
        },
    )
}

/// What is needed to walk around the hinges of a mesh with a metric.
pub(super) struct Around<'a, T: Real, const N: usize, G: TensorField<T, N>> {
    g: &'a G,
    blocks: usize,
    tables: Vec<G::Table>,
    outward: Vec<[Vector<T, N>; 2]>,
}

impl<'a, T: Real, const N: usize, G: TensorField<T, N>> Around<'a, T, N, G> {
    /// At the points of these sites, which are hinges.
    pub fn new(g: &'a G, sites: &Sites<T>) -> Self {
        let outward = (0..sites.vertices.len())
            .map(|place| {
                let nu = sites.outward::<N>(place);
                [nu[0], nu[1]]
            })
            .collect();
        Self {
            g,
            blocks: sites.weights.len(),
            tables: sites.tables(g),
            outward,
        }
    }

    /// (Θ_S, ω_S) at each block of points of a hinge: Θ_S = 2π − Σ_T θ_ST, ω_S from the first cell.
    pub fn angle_defect<K: Formulas>(&self, space: &Lagrange<'_, N>, hinge: usize) -> Vec<(T, T)> {
        let two_pi = T::from_f64(std::f64::consts::TAU);
        let mut defects = vec![(two_pi, T::zero()); self.blocks];
        for (first, side) in space.mesh().star(N - 2, hinge).enumerate() {
            let local = self.g.on_cell(side.cell);
            let [a, b] = &self.outward[side.place];
            for (block, (defect, omega_s)) in defects.iter_mut().enumerate() {
                let g = self.g.value(&local, &self.tables[side.place], block);
                let (inverse, det) = inverse_and_det(&g);
                let corner = Hinge::new(&inverse, [a, b]);
                let (sin, cos) = K::dihedral(&corner);
                *defect -= T::angle(sin, cos);
                if first == 0 {
                    *omega_s = corner.omega_s(det);
                }
            }
        }
        defects
    }
}

/// Θ_S at the barycentre of each interior hinge, in the order of the mesh: (hinge, Θ_S, |S| by a rule of `order`).
pub fn angle_defects<const N: usize, G: TensorField<f64, N>>(
    g: &G,
    space: &Lagrange<'_, N>,
    order: usize,
) -> Vec<(usize, f64, f64)> {
    let (centre, rule) = (Rule::new(N - 2, 1), Rule::new(N - 2, order));
    let at_centre = Sites::<f64>::new(N - 2, &centre, space);
    let sites = Sites::<f64>::new(N - 2, &rule, space);
    let (middle, around) = (Around::new(g, &at_centre), Around::new(g, &sites));
    let hinges: Vec<usize> = space.mesh().interior_hinges().collect();
    let mut all = Vec::with_capacity(hinges.len());
    let on_hinge = |index: usize| {
        let defect = middle.angle_defect::<Paper>(space, hinges[index])[0].0;
        let volumes = around.angle_defect::<Paper>(space, hinges[index]);
        let volume = volumes
            .iter()
            .zip(&sites.weights)
            .map(|((_, omega), w)| omega * w)
            .sum();
        (hinges[index], defect, volume)
    };
    in_order(hinges.len(), on_hinge, |_, row| all.push(row));
    all
}

//! The distributional densitized scalar curvature. Paper: def:distcurv.

use super::corner::{Corners, Defects};
use super::site::{Sites, sum_over};
use super::{Rules, Sums};
use crate::field::TensorField;
use crate::formulas::{Formulas, Paper};
use crate::hypersurface::{self, Normal};
use crate::jet::{Jet1, lower, lower_vector};
use crate::linalg::Vector;
use crate::mesh::{Mesh, Slot};
use crate::parallel::rows_in_order;
use crate::quadrature::Rule;
use crate::riemann::{Connection, Curvature};
use crate::scalar::Real;
use crate::spaces::Lagrange;

/// ⟨(Rω)_dist(g), v⟩ = Σ_T ∫ R v ω + 2 Σ̊_F ∫ ⟦H⟧ v ω_F + 2 Σ̊_S ∫ Θ_S v ω_S for every basis function v.
///
/// Functions that do not vanish on the boundary are tested as they are: no boundary term is added.
/// Paper: def:distcurv.
pub fn distributional_curvature<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    distributional_curvature_with::<Paper, T, N, G>(g, space, rules)
}

/// [`distributional_curvature`] by the formulas K.
pub fn distributional_curvature_with<K: Formulas, T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    let (mesh, len) = (space.mesh(), space.cell_len());
    let element = CellTerm::new(g, space, &rules.cells);
    let face = FaceTerm::new(g, space, &rules.faces);
    let hinges = Sites::<T>::new(N - 2, &rules.hinges, space);
    let corners = Corners::new(g, mesh, &hinges);
    let (mut sums, mut defects) = (Sums::zero(space.len()), corners.before());
    let flat = g.is_constant();
    let on_cell = |cell: usize, row: &mut [T]| {
        let local = g.on_cell(cell);
        let (sums, angles) = row.split_at_mut(2 * len);
        if !flat {
            let (r, h) = sums.split_at_mut(len);
            element.add(&local, r);
            face.add::<K>(mesh, cell, &local, h);
        }
        corners.fill::<K>(cell, &local, angles);
    };
    let width = 2 * len + corners.width();
    rows_in_order(mesh.cell_count(), width, T::zero(), on_cell, |cell, row| {
        for (i, dof) in space.cell_dofs(cell).enumerate() {
            sums.cells[dof] += row[i].reduce();
            sums.faces[dof] += row[len + i].reduce();
        }
        defects.subtract(mesh, cell, &row[2 * len..]);
    });
    sums.hinges = hinge_sum::<K, T, N>(&defects, space, &hinges);
    sums
}

/// Σ_T ∫_T R v ω for every basis function v: all of ⟨(Rω)(g), v⟩ when g is smooth on the whole domain.
pub fn smooth_curvature<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &Lagrange<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let term = CellTerm::new(g, space, rule);
    sum_over(
        space,
        &term.sites,
        0..space.mesh().cell_count(),
        |cell, acc| {
            term.add(&g.on_cell(cell), acc);
        },
    )
}

/// ∫_T R v ω.
struct CellTerm<'a, T: Real, const N: usize, G: TensorField<T, N>> {
    g: &'a G,
    sites: Sites<T>,
    table: G::Table,
}

impl<'a, T: Real, const N: usize, G: TensorField<T, N>> CellTerm<'a, T, N, G> {
    fn new(g: &'a G, space: &Lagrange<N>, rule: &Rule) -> Self {
        Self {
            g,
            sites: Sites::new(N, rule, space),
            table: g.tabulate(rule.points()),
        }
    }

    /// Adds the integrals over a cell, by its basis functions.
    fn add(&self, local: &G::Local, acc: &mut [T]) {
        for block in 0..self.sites.weights.len() {
            let g = self.g.jet2(local, &self.table, block);
            let connection = Connection::new(&lower(&g));
            let r = Curvature::new(&g, &connection).scalar();
            self.sites.accumulate(block, r * connection.det.sqrt(), acc);
        }
    }
}

/// 2 ∫_F H v ω_F over the interior faces of a cell, with its own outward normal: ⟦H⟧ is the sum of both sides.
struct FaceTerm<'a, T: Real, const N: usize, G: TensorField<T, N>> {
    g: &'a G,
    sites: Sites<T>,
    tables: Vec<G::Table>,
    outward: Vec<Vector<Jet1<T, N>, N>>,
    /// By place, the cell's number for each function of the trace basis.
    numbers: Vec<Vec<usize>>,
}

impl<'a, T: Real, const N: usize, G: TensorField<T, N>> FaceTerm<'a, T, N, G> {
    fn new(g: &'a G, space: &Lagrange<N>, rule: &Rule) -> Self {
        let sites = Sites::<T>::new(N - 1, rule, space);
        let all: Vec<usize> = (0..=N).collect();
        let on_cell = space.trace_slots(&all);
        let number = |slot: &Slot| on_cell.iter().position(|s| s == slot).unwrap_or_default();
        Self {
            g,
            tables: sites.tables(g),
            outward: (0..=N)
                .map(|place| sites.outward::<N>(place)[0].map(Jet1::constant))
                .collect(),
            numbers: sites
                .slots
                .iter()
                .map(|slots| slots.iter().map(number).collect())
                .collect(),
            sites,
        }
    }

    /// Adds the integrals over the faces of a cell, by the cell's basis functions.
    fn add<K: Formulas>(&self, mesh: &Mesh<N>, cell: usize, local: &G::Local, acc: &mut [T]) {
        for (place, &face) in mesh.simplices_of(cell, N - 1).iter().enumerate() {
            if !mesh.is_interior(N - 1, face as usize) {
                continue;
            }
            for block in 0..self.sites.weights.len() {
                let connection = Connection::new(&self.g.jet1(local, &self.tables[place], block));
                let density =
                    densitized_mean_curvature::<K, T, N>(&connection, &self.outward[place]);
                let weighted = density * K::face_factor() * self.sites.weights[block];
                for (&number, v) in self.numbers[place].iter().zip(&self.sites.basis[block]) {
                    acc[number] += weighted * *v;
                }
            }
        }
    }
}

/// H ω_F of a hypersurface with covector ν, on one side, relative to a coordinate measure on {λ_f = 0} for ν = −dλ_f.
#[inline]
fn densitized_mean_curvature<K: Formulas, T: Real, const N: usize>(
    connection: &Connection<T, N>,
    nu: &Vector<Jet1<T, N>, N>,
) -> T {
    let normal = Normal::new(&connection.inverse, &lower_vector(nu));
    let second_form = K::second_form(connection, nu, &normal);
    hypersurface::mean_curvature(&normal, &second_form) * normal.length * connection.det.sqrt()
}

/// 2 Σ̊_S ∫ Θ_S v ω_S.
fn hinge_sum<K: Formulas, T: Real, const N: usize>(
    defects: &Defects<T>,
    space: &Lagrange<N>,
    sites: &Sites<T>,
) -> Vec<T::Sum> {
    let hinges = space.mesh().interior_hinges();
    sum_over(space, sites, hinges, |hinge, acc| {
        for block in 0..sites.weights.len() {
            let (defect, omega_s) = defects.at(hinge, block);
            sites.accumulate(block, defect * omega_s * K::hinge_factor(), acc);
        }
    })
}

/// Θ_S at the barycentre of each interior hinge, in the order of the mesh: (hinge, Θ_S, |S| by a rule of `order`).
pub fn angle_defects<const N: usize, G: TensorField<f64, N>>(
    g: &G,
    space: &Lagrange<N>,
    order: usize,
) -> Vec<(usize, f64, f64)> {
    let mesh = space.mesh();
    let on_rule = |order: usize| {
        let sites = Sites::<f64>::new(N - 2, &Rule::new(N - 2, order), space);
        (Defects::new::<Paper, N, G>(g, mesh, &sites), sites.weights)
    };
    let ((middle, _), (around, weights)) = (on_rule(1), on_rule(order));
    let row = |hinge: usize| {
        let volumes = weights.iter().enumerate();
        let volume = volumes.map(|(q, w)| around.at(hinge, q).1 * w).sum();
        (hinge, middle.at(hinge, 0).0, volume)
    };
    mesh.interior_hinges().map(row).collect()
}

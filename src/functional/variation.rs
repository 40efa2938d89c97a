//! The forms b_h and a_h of the first variation, and the distributional Einstein tensor. Paper: thm:distcurvdot.

use super::corner::Defects;
use super::site::{Sites, sum_over};
use super::{Rules, Sums};
use crate::field::TensorField;
use crate::formulas::{Formulas, Paper};
use crate::hinge::Hinge;
use crate::hypersurface::{self, Normal, outward};
use crate::jet::{Jet1, Jet2, lower};
use crate::linalg::{Vector, contract, inverse_and_det};
use crate::parallel::rows_in_order;
use crate::quadrature::Rule;
use crate::riemann::{Connection, Curvature, differential};
use crate::scalar::Real;
use crate::spaces::Lagrange;

/// b_h(g; σ, v) = Σ_T ∫ ⟨𝕊σ, ∇∇v⟩ ω − Σ_F ∫ 𝕊σ(n,n) ⟦∇_n v⟧ ω_F for every basis function v.
///
/// The face sum is over all faces; on the boundary the jump is the one-sided value. The hinge sum is empty.
/// Paper: thm:distcurvdot.
pub fn b_h<T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    b_h_with::<Paper, T, N, G, H>(g, sigma, space, rules)
}

/// [`b_h`] by the formulas K.
pub fn b_h_with<
    K: Formulas,
    T: Real,
    const N: usize,
    G: TensorField<T, N>,
    H: TensorField<T, N>,
>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    let mesh = space.mesh();
    let element = HessianTerm::new(g, sigma, space, &rules.cells);
    let face = NormalTerm::new(g, sigma, space, &rules.faces);
    let mut sums = Sums::zero(space.len());
    let len = space.cell_len();
    let on_cell = |cell: usize, row: &mut [T]| {
        let (g, sigma) = (g.on_cell(cell), sigma.on_cell(cell));
        let (hessian, normal) = row.split_at_mut(len);
        element.on_cell::<K>(&g, &sigma, hessian);
        for place in 0..=N {
            let interior = mesh.is_interior(N - 1, mesh.simplices_of(cell, N - 1)[place] as usize);
            if K::face_in_b(interior) {
                face.on_face::<K>(&g, &sigma, place, normal);
            }
        }
    };
    rows_in_order(
        mesh.cell_count(),
        2 * len,
        T::zero(),
        on_cell,
        |cell, row| {
            for (i, dof) in space.cell_dofs(cell).enumerate() {
                sums.cells[dof] += row[i].reduce();
                sums.faces[dof] += row[len + i].reduce();
            }
        },
    );
    sums
}

/// ∫_T ⟨𝕊σ, ∇∇v⟩ ω.
struct HessianTerm<'a, T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>> {
    g: &'a G,
    sigma: &'a H,
    tables: (G::Table, H::Table),
    weights: Vec<T>,
    basis: Vec<Vec<Jet2<T, N>>>,
}

impl<'a, T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>>
    HessianTerm<'a, T, N, G, H>
{
    fn new(g: &'a G, sigma: &'a H, space: &Lagrange<N>, rule: &Rule) -> Self {
        Self {
            g,
            sigma,
            tables: (g.tabulate(rule.points()), sigma.tabulate(rule.points())),
            weights: super::site::weights(rule),
            basis: space.basis(N).tabulate_jets(rule.points()),
        }
    }

    fn on_cell<K: Formulas>(&self, g: &G::Local, sigma: &H::Local, acc: &mut [T]) {
        for block in 0..self.weights.len() {
            let connection = Connection::new(&self.g.jet1(g, &self.tables.0, block));
            let sigma = self.sigma.value(sigma, &self.tables.1, block);
            let s_sigma = K::reverse_trace(&connection.g, &connection.inverse, &sigma);
            let raised = crate::linalg::sandwich(&connection.inverse, &s_sigma);
            let weight = connection.det.sqrt() * self.weights[block];
            for (a, v) in acc.iter_mut().zip(&self.basis[block]) {
                *a += crate::linalg::double_contract(&raised, &connection.hessian(v)) * weight;
            }
        }
    }
}

/// −∫_F 𝕊σ(n,n) ∇_n v ω_F, from one cell.
struct NormalTerm<'a, T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>> {
    g: &'a G,
    sigma: &'a H,
    tables: Vec<(G::Table, H::Table)>,
    weights: Vec<T>,
    basis: Vec<Vec<Vec<Jet2<T, N>>>>,
}

impl<'a, T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>>
    NormalTerm<'a, T, N, G, H>
{
    fn new(g: &'a G, sigma: &'a H, space: &Lagrange<N>, rule: &Rule) -> Self {
        let sites = Sites::<T>::new(N - 1, rule, space);
        let (on_g, on_sigma) = (sites.tables(g), sites.tables(sigma));
        let basis = space.basis(N);
        Self {
            g,
            sigma,
            tables: on_g.into_iter().zip(on_sigma).collect(),
            basis: sites
                .points
                .iter()
                .map(|p| basis.tabulate_jets(p))
                .collect(),
            weights: sites.weights,
        }
    }

    /// The face at this place is opposite to vertex N − place.
    fn on_face<K: Formulas>(&self, g: &G::Local, sigma: &H::Local, place: usize, acc: &mut [T]) {
        let nu: Vector<T, N> = outward(N - place);
        for block in 0..self.weights.len() {
            let g = self.g.value(g, &self.tables[place].0, block);
            let sigma = self.sigma.value(sigma, &self.tables[place].1, block);
            let (inverse, det) = inverse_and_det(&g);
            let normal = Normal::new(&inverse, &nu);
            let s_nn = normal.normal_normal(&K::reverse_trace(&g, &inverse, &sigma));
            let weight = -s_nn * normal.length * det.sqrt() * self.weights[block];
            for (a, v) in acc.iter_mut().zip(&self.basis[place][block]) {
                let dv = differential(v).map(|d: Jet1<T, N>| d.value);
                *a += contract(&dv, &normal.n) * weight;
            }
        }
    }
}

/// a_h(g; σ, v) = Σ_T ∫ ⟨G, σ⟩ v ω + Σ̊_F ∫ ⟨⟦II‾⟧, σ|_F⟩ v ω_F − Σ̊_S ∫ ⟨Θ_S g|_S, σ|_S⟩ v ω_S for every v.
///
/// Paper: thm:distcurvdot.
pub fn a_h<T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    a_h_with::<Paper, T, N, G, H>(g, sigma, space, rules)
}

/// [`a_h`] by the formulas K.
pub fn a_h_with<
    K: Formulas,
    T: Real,
    const N: usize,
    G: TensorField<T, N>,
    H: TensorField<T, N>,
>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    let mut sums = Sums::zero(space.len());
    if !g.is_constant() {
        sums.cells = einstein_sum(g, sigma, space, &rules.cells);
        sums.faces = second_form_sum::<K, T, N, G, H>(g, sigma, space, &rules.faces);
    }
    sums.hinges = defect_sum::<K, T, N, G, H>(g, sigma, space, &rules.hinges);
    sums
}

/// ⟨(Gω)_dist(g), σ⟩ as its three sums: a_h with v = 1. Paper: def:distein.
pub fn einstein<T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>>(
    g: &G,
    sigma: &H,
    mesh: &crate::mesh::Mesh<N>,
    rules: &Rules,
) -> [T::Sum; 3] {
    // The hat functions add up to one.
    let hats = Lagrange::new(mesh, 1);
    a_h(g, sigma, &hats, rules).pair(&vec![1.0; hats.len()])
}

/// Σ_T ∫ ⟨G, σ⟩ v ω.
fn einstein_sum<T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let sites = Sites::<T>::new(N, rule, space);
    let tables = (g.tabulate(rule.points()), sigma.tabulate(rule.points()));
    sum_over(space, &sites, 0..space.mesh().cell_count(), |cell, acc| {
        let locals = (g.on_cell(cell), sigma.on_cell(cell));
        for block in 0..sites.weights.len() {
            let g = g.jet2(&locals.0, &tables.0, block);
            let connection = Connection::new(&lower(&g));
            let sigma = sigma.value(&locals.1, &tables.1, block);
            let einstein = Curvature::new(&g, &connection).einstein();
            let density = connection.inner(&einstein, &sigma);
            sites.accumulate(block, density * connection.det.sqrt(), acc);
        }
    })
}

/// Σ̊_F ∫ ⟨⟦II‾⟧, σ|_F⟩ v ω_F: from both cells.
fn second_form_sum<
    K: Formulas,
    T: Real,
    const N: usize,
    G: TensorField<T, N>,
    H: TensorField<T, N>,
>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let mesh = space.mesh();
    let sites = Sites::<T>::new(N - 1, rule, space);
    let tables = (sites.tables(g), sites.tables(sigma));
    sum_over(space, &sites, mesh.interior_faces(), |face, acc| {
        for side in mesh.star(N - 1, face) {
            let locals = (g.on_cell(side.cell), sigma.on_cell(side.cell));
            let nu = sites.outward::<N>(side.place)[0];
            for block in 0..sites.weights.len() {
                let connection = Connection::new(&g.jet1(&locals.0, &tables.0[side.place], block));
                let sigma = sigma.value(&locals.1, &tables.1[side.place], block);
                let normal = Normal::new(&connection.inverse, &nu);
                let second_form = K::second_form(&connection, &nu.map(Jet1::constant), &normal);
                let h = hypersurface::mean_curvature(&normal, &second_form);
                let reversed = K::trace_reversed(&connection.g, &second_form, h);
                let omega_f = normal.length * connection.det.sqrt();
                sites.accumulate(block, normal.inner(&reversed, &sigma) * omega_f, acc);
            }
        }
    })
}

/// −Σ̊_S ∫ Θ_S Tr(σ|_S) v ω_S, with σ|_S from the first cell.
fn defect_sum<K: Formulas, T: Real, const N: usize, G: TensorField<T, N>, H: TensorField<T, N>>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let mesh = space.mesh();
    let sites = Sites::<T>::new(N - 2, rule, space);
    let defects = Defects::new::<K, N, G>(g, mesh, &sites);
    let tables = (sites.tables(g), sites.tables(sigma));
    sum_over(space, &sites, mesh.interior_hinges(), |hinge, acc| {
        let side = mesh.first_side(N - 2, hinge);
        let locals = (g.on_cell(side.cell), sigma.on_cell(side.cell));
        let nu = sites.outward::<N>(side.place);
        for block in 0..sites.weights.len() {
            let (defect, omega_s) = defects.at(hinge, block);
            let g = g.value(&locals.0, &tables.0[side.place], block);
            let sigma = sigma.value(&locals.1, &tables.1[side.place], block);
            let (inverse, _) = inverse_and_det(&g);
            let trace = Hinge::new(&inverse, [&nu[0], &nu[1]]).trace(&inverse, &sigma);
            sites.accumulate(block, -defect * trace * omega_s, acc);
        }
    })
}

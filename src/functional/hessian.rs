//! The form b_h, in which derivatives of the test functions meet 𝕊σ. Paper: thm:distcurvdot.

use super::seen::{Sites, weights};
use super::{Rules, Sums};
use crate::density::{Normal, omega, outward};
use crate::field::{Evaluate, TensorField};
use crate::formulas::{Formulas, times};
use crate::jet::{Jet1, Jet2};
use crate::linalg::{Vector, contract, double_contract, inverse_and_det, sandwich};
use crate::parallel::rows_in_order;
use crate::riemann::{Connection, differential, reverse_trace};
use crate::scalar::{Field, Real};
use crate::spaces::Lagrange;

/// b_h(g; σ, v) = Σ_T ∫ ⟨𝕊σ, ∇∇v⟩ ω − Σ_F ∫ 𝕊σ(n,n) ⟦∇_n v⟧ ω_F for every basis function v.
///
/// The face sum is over all faces; on the boundary the jump is the one-sided value. The hinge sum is empty.
/// Paper: thm:distcurvdot.
pub fn b_h<const N: usize, G: TensorField<N>, H: Evaluate<G::Wide, N>>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<G::Scalar> {
    sums::<G::Wide, N, G, H>(g, sigma, space, rules)
}

fn sums<T: Real, const N: usize, G: Evaluate<T, N>, H: Evaluate<T, N>>(
    g: &G,
    sigma: &H,
    space: &Lagrange<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    let (mesh, len) = (space.mesh(), space.cell_len());
    let cells = Term::new(
        g,
        sigma,
        space,
        &Sites::new(N, &rules.cells),
        &rules.formulas,
    );
    let faces = Term::new(
        g,
        sigma,
        space,
        &Sites::new(N, &rules.faces),
        &rules.formulas,
    );
    let weights = [&rules.cells, &rules.faces].map(weights::<T>);
    let on_cell = |cell: usize, row: &mut [T::Sum], acc: &mut Vec<T>| {
        acc.clear();
        acc.resize(2 * len, T::zero());
        let at = (g.on_cell(cell), sigma.on_cell(cell));
        let (hessian, normal) = acc.split_at_mut(len);
        for (block, weight) in weights[0].iter().enumerate() {
            cells.hessian(&at, block, *weight, hessian);
        }
        for (place, &face) in mesh.simplices_of(cell, N - 1).iter().enumerate() {
            if rules.formulas.b_on_boundary || mesh.is_interior(N - 1, face as usize) {
                for (block, weight) in weights[1].iter().enumerate() {
                    faces.normal(&at, place, block, *weight, normal);
                }
            }
        }
        for (entry, sum) in row.iter_mut().zip(acc) {
            *entry = sum.reduce();
        }
    };
    let (mut sums, zero) = (Sums::zero(space.len()), T::Sum::zero());
    let add = |cell: usize, row: &[T::Sum]| {
        for (i, dof) in space.cell_dofs(cell).enumerate() {
            sums.cells[dof] += row[i];
            sums.faces[dof] += row[len + i];
        }
    };
    rows_in_order(mesh.cell_count(), 2 * len, zero, Vec::new, on_cell, add);
    sums
}

/// g, σ and the test functions at the points of a rule.
struct Term<'a, T: Real, const N: usize, G: Evaluate<T, N>, H: Evaluate<T, N>> {
    g: &'a G,
    sigma: &'a H,
    formulas: &'a Formulas,
    /// By place.
    tables: Vec<(G::Table, H::Table)>,
    /// By place, block and function.
    basis: Vec<Vec<Vec<Jet2<T, N>>>>,
}

impl<'a, T, const N: usize, G, H> Term<'a, T, N, G, H>
where
    T: Real,
    G: Evaluate<T, N>,
    H: Evaluate<T, N>,
{
    fn new(
        g: &'a G,
        sigma: &'a H,
        space: &Lagrange<N>,
        sites: &Sites,
        formulas: &'a Formulas,
    ) -> Self {
        let basis = space.basis(N);
        Self {
            g,
            sigma,
            formulas,
            tables: sites
                .tables(g)
                .into_iter()
                .zip(sites.tables(sigma))
                .collect(),
            basis: (sites.points.iter())
                .map(|points| basis.tabulate_jets(points))
                .collect(),
        }
    }

    /// Adds ⟨𝕊σ, ∇∇v⟩ ω at a block of points of the cell.
    fn hessian(&self, at: &(G::Local, H::Local), block: usize, weight: T, acc: &mut [T]) {
        let (table_g, table_sigma) = &self.tables[0];
        let connection = Connection::new(&self.g.jet1(&at.0, table_g, block));
        let sigma = self.sigma.value(&at.1, table_sigma, block);
        let s_sigma = connection.reverse_trace(self.formulas, &sigma);
        let raised = sandwich(&connection.inverse, &s_sigma);
        let factor = times(self.formulas.b_cells, weight);
        let density = omega(self.formulas, connection.det) * factor;
        for (a, v) in acc.iter_mut().zip(&self.basis[0][block]) {
            *a += double_contract(&raised, &connection.hessian(v)) * density;
        }
    }

    /// Adds −𝕊σ(n,n) ∇_n v ω_F at a block of points of a face, which is opposite to vertex N − place.
    fn normal(
        &self,
        at: &(G::Local, H::Local),
        place: usize,
        block: usize,
        weight: T,
        acc: &mut [T],
    ) {
        let nu: Vector<T, N> = outward(N - place);
        let (table_g, table_sigma) = &self.tables[place];
        let g = self.g.value(&at.0, table_g, block);
        let sigma = self.sigma.value(&at.1, table_sigma, block);
        let (inverse, det) = inverse_and_det(&g);
        let normal = Normal::new(self.formulas, &inverse, det, &nu);
        let s_sigma = reverse_trace(self.formulas, &g, &inverse, &sigma);
        let factor = times(self.formulas.b_faces, weight);
        let density = normal.normal_normal(&s_sigma) * normal.omega * factor;
        for (a, v) in acc.iter_mut().zip(&self.basis[place][block]) {
            let dv = differential(v).map(|d: Jet1<T, N>| d.value);
            *a += contract(&dv, &normal.n) * density;
        }
    }
}

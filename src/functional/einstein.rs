//! The distributional Einstein tensor against every Regge basis function at once.
//!
//! ⟨(Gω)_dist(g), σ⟩ is linear in the edge components q_ab of σ. At a quadrature point it is contracted with the
//! tensors that have one edge component 1 and the others 0; Bernstein's polynomials do the rest.

use super::local::Wedges;
use super::site::weights;
use super::{Rules, Sums};
use crate::field::TensorField;
use crate::formulas::{Formulas, Paper};
use crate::hinge::Hinge;
use crate::hypersurface::{Normal, mean_curvature, outward};
use crate::jet::{Jet1, lower};
use crate::linalg::{Mat, Vector, inverse_and_det};
use crate::mesh::Slot;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::riemann::{Connection, Curvature};
use crate::scalar::{Field, Real};
use crate::simplex::{Bernstein, Points, subsets};
use crate::spaces::ReggeSpace;

/// ⟨(Gω)_dist(g), ψ_i⟩ for every basis function ψ_i of a Regge space. Paper: def:distein.
///
/// Functions that do not vanish on the boundary are tested as they are: no boundary term is added. The same numbers as
/// [`einstein`](super::einstein) gives one by one.
pub fn einstein_against<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &ReggeSpace<N>,
    rules: &Rules,
) -> Sums<T::Sum> {
    let mut sums = Sums::zero(space.len());
    if !g.is_constant() {
        sums.cells = element_sum::<T, N, G>(g, space, &rules.cells);
        sums.faces = face_sum::<T, N, G>(g, space, &rules.faces);
    }
    sums.hinges = hinge_sum::<T, N, G>(g, space, &rules.hinges);
    sums
}

/// The k-simplices of a cell, by place, with the traces of Regge functions on them.
struct Traces<T: Real, const N: usize> {
    k: usize,
    /// The rule's points as the cell sees them.
    points: Vec<Points>,
    weights: Vec<T>,
    /// B_α at the points, `[block][α]`.
    basis: Vec<Vec<T>>,
    /// The tensors with one edge component, of each edge of the simplex.
    units: Vec<Vec<Mat<T, N>>>,
    /// Where the coefficients are numbered, by edge, then by α.
    slots: Vec<Vec<Slot>>,
}

impl<T: Real, const N: usize> Traces<T, N> {
    fn new(k: usize, rule: &Rule, space: &ReggeSpace<N>) -> Self {
        let places = subsets(N + 1, k + 1);
        let edges = |on: &Vec<usize>| {
            let pairs = subsets(k + 1, 2).into_iter();
            pairs.map(|e| unit_tensor(on[e[0]], on[e[1]])).collect()
        };
        Self {
            k,
            points: (places.iter().map(|on| rule.points().embed(on, N + 1))).collect(),
            weights: weights(rule),
            basis: Bernstein::new(k + 1, space.degree()).tabulate(rule.points()),
            units: places.iter().map(edges).collect(),
            slots: places.iter().map(|on| space.trace_slots(on)).collect(),
        }
    }

    fn tables<G: TensorField<T, N>>(&self, g: &G) -> Vec<G::Table> {
        self.points
            .iter()
            .map(|points| g.tabulate(points))
            .collect()
    }

    /// acc[edge, α] += contract(unit tensor) · w · B_α at a block of points.
    fn accumulate(
        &self,
        place: usize,
        block: usize,
        acc: &mut [T],
        contract: impl Fn(&Mat<T, N>) -> T,
    ) {
        let basis = &self.basis[block];
        for (unit, acc) in (self.units[place].iter()).zip(acc.chunks_exact_mut(basis.len())) {
            let density = contract(unit) * self.weights[block];
            for (a, b) in acc.iter_mut().zip(basis) {
                *a += density * *b;
            }
        }
    }

    /// Σ over k-simplices of what `local` adds up, in their order whatever the threads do.
    fn sum(
        &self,
        space: &ReggeSpace<N>,
        simplices: Vec<usize>,
        local: impl Fn(usize, &mut [T]) + Sync,
    ) -> Vec<T::Sum> {
        let mesh = space.mesh();
        let mut sum = vec![T::Sum::zero(); space.len()];
        let on_simplex = |i: usize| {
            let mut acc = vec![T::zero(); self.slots[0].len()];
            local(simplices[i], &mut acc);
            acc.into_iter().map(T::reduce).collect::<Vec<T::Sum>>()
        };
        in_order(simplices.len(), on_simplex, |i, values| {
            let side = mesh.first_side(self.k, simplices[i]);
            for (&slot, value) in self.slots[side.place].iter().zip(values) {
                sum[space.numbering().of_cell(mesh, side.cell, slot)] += value;
            }
        });
        sum
    }
}

/// The tensor whose edge component q_ab is 1 and all others 0: g_ij = ½(q_0i + q_0j − q_ij).
fn unit_tensor<T: Real, const N: usize>(a: usize, b: usize) -> Mat<T, N> {
    Mat::from_fn(|i, j| {
        let (i, j) = (i + 1, j + 1);
        let q = |v: usize, w: usize| T::from_int(i64::from((v.min(w), v.max(w)) == (a, b)));
        (q(0, i) + q(0, j) - q(i, j)) * T::half()
    })
}

/// Σ_T ∫ ⟨G, ψ⟩ ω.
fn element_sum<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &ReggeSpace<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let traces = Traces::<T, N>::new(N, rule, space);
    let table = g.tabulate(rule.points());
    traces.sum(
        space,
        (0..space.mesh().cell_count()).collect(),
        |cell, acc| {
            let local = g.on_cell(cell);
            for block in 0..traces.weights.len() {
                let g = g.jet2(&local, &table, block);
                let connection = Connection::new(&lower(&g));
                let einstein = Curvature::new(&g, &connection).einstein();
                let omega = connection.det.sqrt();
                traces.accumulate(0, block, acc, |psi| {
                    connection.inner(&einstein, psi) * omega
                });
            }
        },
    )
}

/// Σ̊_F ∫ ⟨⟦II‾⟧, ψ|_F⟩ ω_F, from both cells.
fn face_sum<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &ReggeSpace<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    let mesh = space.mesh();
    let traces = Traces::<T, N>::new(N - 1, rule, space);
    let tables = traces.tables(g);
    traces.sum(space, mesh.interior_faces().collect(), |face, acc| {
        for side in mesh.star(N - 1, face) {
            let local = g.on_cell(side.cell);
            let nu: Vector<T, N> = outward(N - side.place);
            for block in 0..traces.weights.len() {
                let connection = Connection::new(&g.jet1(&local, &tables[side.place], block));
                let normal = Normal::new(&connection.inverse, &nu);
                let form = Paper::second_form(&connection, &nu.map(Jet1::constant), &normal);
                let h = mean_curvature(&normal, &form);
                let reversed = Paper::trace_reversed(&connection.g, &form, h);
                let omega_f = normal.length * connection.det.sqrt();
                traces.accumulate(side.place, block, acc, |psi| {
                    normal.inner(&reversed, psi) * omega_f
                });
            }
        }
    })
}

/// −Σ̊_S ∫ Θ_S Tr(ψ|_S) ω_S.
fn hinge_sum<T: Real, const N: usize, G: TensorField<T, N>>(
    g: &G,
    space: &ReggeSpace<N>,
    rule: &Rule,
) -> Vec<T::Sum> {
    if N == 2 {
        // A vertex has no tangent, and Regge functions no value there.
        return vec![T::Sum::zero(); space.len()];
    }
    let mesh = space.mesh();
    let traces = Traces::<T, N>::new(N - 2, rule, space);
    let (tables, wedges) = (traces.tables(g), Wedges::<T, N, G>::new(g, rule));
    let two_pi = T::from_f64(std::f64::consts::TAU);
    let places = subsets(N + 1, N - 1);
    traces.sum(space, mesh.interior_hinges().collect(), |hinge, acc| {
        let side = mesh.first_side(N - 2, hinge);
        let local = g.on_cell(side.cell);
        let mut nu = (0..=N)
            .filter(|v| !places[side.place].contains(v))
            .map(outward::<T, N>);
        let (Some(a), Some(b)) = (nu.next(), nu.next()) else {
            return;
        };
        for (block, (angle, omega_s)) in wedges.around(mesh, hinge).into_iter().enumerate() {
            let (inverse, _) = inverse_and_det(&g.value(&local, &tables[side.place], block));
            let corner = Hinge::new(&inverse, [&a, &b]);
            let density = (angle - two_pi) * omega_s;
            traces.accumulate(side.place, block, acc, |psi| {
                corner.trace(&inverse, psi) * density
            });
        }
    })
}

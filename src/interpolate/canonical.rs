//! The canonical degrees of freedom and the basis dual to them. Paper: appendix; Li 2018, eq. (2.4b).
//!
//! On a k-simplex D, k ≥ 1, they are the integrals of g|_D against the symmetric tensors of degree r−k+1:
//! ℓ_{D,ab,β}(g) = ∫_D q_ab λ^β dμ, ab an edge of D, |β| = r−k+1, dμ the reference measure of D (1/k! in all). The
//! integrals of different edges have nothing to do with each other, so that the dual basis is found edge by edge.
//! A simplex of dimension k > r+1 has no degrees of freedom.

use crate::field::{Evaluate, TensorField};
use crate::mesh::Slot;
use crate::parallel::rows_in_order;
use crate::quadrature::Rule;
use crate::scalar::{Field, Lift, Real};
use crate::simplex::{Bernstein, edges_of, multi_indices, subsets};
use crate::spaces::{ReggeSpace, add_edge_components};
use nalgebra::DMatrix;

/// The canonical degrees of freedom of a Regge space. They are numbered as its coefficients are: on each simplex by
/// edge, then by β.
#[derive(Clone, Debug)]
pub struct Canonical<const N: usize> {
    space: ReggeSpace<N>,
    on: Vec<OnSimplex>,
}

/// What happens on a k-simplex D, the same for all of them.
#[derive(Clone, Debug)]
struct OnSimplex {
    /// Where D is in the cell, by place.
    places: Vec<Place>,
    /// λ^β, |β| = r−k+1, as Bernstein polynomials (a multiple each, which changes nothing in duality).
    test: Bernstein,
    /// By edge of D: α that charge all of D with the edge, and those that do not.
    own: Vec<Vec<usize>>,
    lower: Vec<Vec<usize>>,
    /// By edge: ∫ B_α λ^β, rows β, all columns α.
    moments: DMatrix<f64>,
    /// By edge: the inverse of its columns `own`.
    inverse: Vec<DMatrix<f64>>,
}

/// D as one of the k-simplices of a cell.
#[derive(Clone, Debug)]
struct Place {
    /// Its local vertices.
    vertices: Vec<usize>,
    /// By edge of D: its two vertices in the cell, ascending, and the cell's number for it.
    ends: Vec<[usize; 2]>,
    edges: Vec<usize>,
    /// The cell's number for each α of D.
    alphas: Vec<usize>,
    /// Where the coefficients of q_ab on D are numbered, by edge of D.
    slots: Vec<Vec<Slot>>,
}

impl Place {
    fn new(n: usize, degree: usize, vertices: Vec<usize>) -> Self {
        let position = |all: &[Vec<usize>], one: &[usize]| {
            all.iter()
                .position(|a| a == one)
                .expect("edges and exponents of D are among those of the cell")
        };
        let cell_edges = subsets(n + 1, 2);
        let ends = edges_of(&vertices);
        let edges = ends.iter().map(|e| position(&cell_edges, e)).collect();
        let cell_alphas = multi_indices(n + 1, degree);
        let in_cell = |alpha: &Vec<usize>| {
            let mut extended = vec![0; n + 1];
            for (i, &v) in vertices.iter().enumerate() {
                extended[v] = alpha[i];
            }
            position(&cell_alphas, &extended)
        };
        let alphas = multi_indices(vertices.len(), degree)
            .iter()
            .map(in_cell)
            .collect();
        Self {
            ends,
            edges,
            alphas,
            slots: crate::spaces::regge_slots(&vertices, n, degree),
            vertices,
        }
    }
}

impl OnSimplex {
    /// None where r−k+1 < 0: no degrees of freedom.
    fn new(n: usize, k: usize, degree: usize) -> Option<Self> {
        let test = Bernstein::new(k + 1, (degree + 1).checked_sub(k)?);
        let basis = Bernstein::new(k + 1, degree);
        let moments = moments(&test, &basis, Rule::new(k, 2 * degree + 1));
        let places = subsets(n + 1, k + 1)
            .into_iter()
            .map(|v| Place::new(n, degree, v))
            .collect();
        let (mut own, mut lower, mut inverse) = (Vec::new(), Vec::new(), Vec::new());
        for edge in subsets(k + 1, 2) {
            let full =
                |a: &usize| (0..=k).all(|v| edge.contains(&v) || basis.exponents()[*a][v] > 0);
            let (mine, others): (Vec<usize>, Vec<usize>) = (0..basis.len()).partition(full);
            let square = moments.select_columns(&mine);
            inverse.push(square.try_inverse().expect(
                "square and regular: the columns are the products of the λ^β with the bubble of D∖ab",
            ));
            own.push(mine);
            lower.push(others);
        }
        Some(Self {
            places,
            test,
            own,
            lower,
            moments,
            inverse,
        })
    }

    /// How many edges D has.
    fn edges(&self) -> usize {
        self.own.len()
    }

    /// λ^β times the weights of a rule, `[block][β]`.
    fn weighted<T: Real>(&self, rule: &Rule) -> Vec<Vec<T>> {
        let mut test = self.test.tabulate::<T>(rule.points());
        for (row, weight) in test.iter_mut().zip(rule.weight_blocks::<T>()) {
            row.iter_mut().for_each(|b| *b *= weight);
        }
        test
    }

    /// The own coefficients of an edge's q_ab on D from its integrals, less what the faces of D contribute to these;
    /// `known(α)` are the faces' coefficients.
    fn own_coefficients<C: Real>(
        &self,
        edge: usize,
        integrals: &[C],
        known: impl Fn(usize) -> C,
    ) -> Vec<C> {
        let mut rest = integrals.to_vec();
        for &a in &self.lower[edge] {
            let c = known(a);
            for (beta, r) in rest.iter_mut().enumerate() {
                *r -= C::from_f64(self.moments[(beta, a)]) * c;
            }
        }
        let solved = |i: usize| {
            let mut c = C::zero();
            for (beta, r) in rest.iter().enumerate() {
                c += C::from_f64(self.inverse[edge][(i, beta)]) * *r;
            }
            c
        };
        (0..self.own[edge].len()).map(solved).collect()
    }
}

/// ∫ test_β basis_α by a rule that is exact for the product.
fn moments(test: &Bernstein, basis: &Bernstein, rule: Rule) -> DMatrix<f64> {
    let (t, b) = (
        test.tabulate::<f64>(rule.points()),
        basis.tabulate::<f64>(rule.points()),
    );
    DMatrix::from_fn(test.len(), basis.len(), |beta, alpha| {
        (0..rule.len())
            .map(|q| rule.weights()[q] * t[q][beta] * b[q][alpha])
            .sum()
    })
}

impl<const N: usize> Canonical<N> {
    /// The degrees of freedom of a space.
    pub fn new(space: &ReggeSpace<N>) -> Self {
        Self {
            space: space.clone(),
            on: (1..=N)
                .map_while(|k| OnSimplex::new(N, k, space.degree()))
                .collect(),
        }
    }

    /// ℓ(g) for every degree of freedom, g seen from the first cell around each simplex, by rules of this order.
    ///
    /// On what is tangential-tangential continuous every cell around a simplex sees the same.
    pub fn evaluate<G: TensorField<N>>(&self, g: &G, order: usize) -> Vec<G::Scalar> {
        let mut values = vec![G::Scalar::zero(); self.space.len()];
        for (k, on) in (1..).zip(&self.on) {
            let rule = Rule::new(k, order);
            self.evaluate_on::<G::Wide, G>(k, on, g, &rule, &mut values);
        }
        values
    }

    /// ∫_D q_ab λ^β dμ on all k-simplices D, by blocks of the rule's points.
    fn evaluate_on<T: Real, G: Evaluate<T, N>>(
        &self,
        k: usize,
        on: &OnSimplex,
        g: &G,
        rule: &Rule,
        values: &mut [T::Sum],
    ) {
        let mesh = self.space.mesh();
        let test = on.weighted::<T>(rule);
        let seen = |p: &Place| g.tabulate(&rule.points().embed(&p.vertices, N + 1));
        let tables: Vec<G::Table> = on.places.iter().map(seen).collect();
        let on_simplex = |simplex: usize, row: &mut [T::Sum], moments: &mut Vec<T>| {
            let side = mesh.first_side(k, simplex);
            let local = g.on_cell(side.cell);
            moments.clear();
            moments.resize(row.len(), T::zero());
            for (block, test) in test.iter().enumerate() {
                let value = g.value(&local, &tables[side.place], block);
                add_edge_components(&value, &on.places[side.place].ends, test, moments);
            }
            for (entry, moment) in row.iter_mut().zip(moments) {
                *entry = moment.reduce();
            }
        };
        let (width, zero) = (on.edges() * on.test.len(), T::Sum::zero());
        let numbering = self.space.numbering();
        let store = |simplex: usize, row: &[T::Sum]| {
            for (i, moment) in row.iter().enumerate() {
                values[numbering.global(k, simplex, i)] = *moment;
            }
        };
        rows_in_order(mesh.count(k), width, zero, Vec::new, on_simplex, store);
    }

    /// ℓ of a polynomial tensor on one cell, given by its coefficients `[edge][α]` there: visits (global index, ℓ).
    pub(super) fn of_cell(&self, cell: usize, local: &[f64], mut visit: impl FnMut(usize, f64)) {
        let mesh = self.space.mesh();
        let size = Bernstein::new(N + 1, self.space.degree()).len();
        for (k, on) in (1..).zip(&self.on) {
            for (p, place) in on.places.iter().enumerate() {
                let simplex = if k == N {
                    cell
                } else {
                    mesh.simplices_of(cell, k)[p] as usize
                };
                for (e, edge) in place.edges.iter().enumerate() {
                    let q = &local[edge * size..(edge + 1) * size];
                    for beta in 0..on.test.len() {
                        let mut value = 0.0;
                        for (a, &alpha) in place.alphas.iter().enumerate() {
                            value += on.moments[(beta, a)] * q[alpha];
                        }
                        visit(
                            self.space
                                .numbering()
                                .global(k, simplex, e * on.test.len() + beta),
                            value,
                        );
                    }
                }
            }
        }
    }

    /// The coefficients of the function whose degrees of freedom are given: Σ_i ℓ_i ψ_i.
    ///
    /// From edges to cells: on D, what the coefficients of D's faces contribute to the integrals is known.
    pub fn solve<C: Real + Lift<C>>(&self, values: &[C]) -> Vec<C> {
        let (mesh, numbering) = (self.space.mesh(), self.space.numbering());
        let mut coefficients = vec![C::zero(); self.space.len()];
        for (k, on) in (1..).zip(&self.on) {
            for simplex in 0..mesh.count(k) {
                let side = mesh.first_side(k, simplex);
                for e in 0..on.edges() {
                    let slots = &on.places[side.place].slots[e];
                    let dof = |a: usize| numbering.of_cell(mesh, side.cell, slots[a]);
                    let first = numbering.global(k, simplex, e * on.test.len());
                    let integrals = &values[first..first + on.test.len()];
                    let own = on.own_coefficients(e, integrals, |a| coefficients[dof(a)]);
                    for (&a, c) in on.own[e].iter().zip(own) {
                        coefficients[dof(a)] = c;
                    }
                }
            }
        }
        coefficients
    }
}

/// The coefficients of the canonical interpolant, its integrals by rules of this order.
pub(super) fn coefficients<const N: usize, G: TensorField<N, Scalar = f64>>(
    space: &ReggeSpace<N>,
    g: &G,
    order: usize,
) -> Vec<f64> {
    let canonical = Canonical::new(space);
    canonical.solve(&canonical.evaluate(g, order))
}

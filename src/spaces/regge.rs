//! Regge finite elements of any degree in any dimension.
//!
//! A symmetric tensor on a cell is known by its edge components q_ab(x) = g_x(t_ab, t_ab), t_ab the edge from vertex
//! a to vertex b: g_ij = ½(q_0i + q_0j − q_ij) in reference coordinates. The tensor has degree r if all q_ab do, and
//! it is tangential-tangential continuous if and only if, for every simplex D and every edge ab of D, q_ab is
//! single-valued on D. So the coefficients of the q_ab in Bernstein's basis belong to simplices: B_α in q_ab to the
//! simplex with vertices {a, b} ∪ supp α, and a global vector of such coefficients is a Regge function. For r = 0
//! they are the squared edge lengths.

use super::lagrange::numbers;
use super::test::{Symmetric, TestSpace, Trace};
use crate::mesh::{Mesh, Numbering, Slot};
use crate::simplex::{Bernstein, Derivatives, binomial, subsets};
use std::sync::Arc;

/// The Regge space of degree r on a mesh: a handle, whose clones share its tables.
#[derive(Clone, Debug)]
pub struct ReggeSpace<const N: usize> {
    tables: Arc<Tables<N>>,
}

#[derive(Debug)]
struct Tables<const N: usize> {
    mesh: Mesh<N>,
    degree: usize,
    numbering: Numbering,
    slots: Vec<Vec<Slot>>,
    derivatives: Derivatives<N>,
}

/// Spaces are the same if they have one degree on one mesh.
impl<const N: usize> PartialEq for ReggeSpace<N> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.tables, &other.tables)
            || (self.degree() == other.degree() && self.mesh() == other.mesh())
    }
}

/// How many degrees of freedom of degree r belong to a k-simplex: C(r+1, k) k(k+1)/2. Paper: appendix.
pub fn dofs_per_simplex(degree: usize, k: usize) -> usize {
    binomial(degree + 1, k) * k * (k + 1) / 2
}

impl<const N: usize> ReggeSpace<N> {
    /// The space of degree r ≥ 0.
    pub fn new(mesh: &Mesh<N>, degree: usize) -> Self {
        let numbering =
            Numbering::new(mesh, (0..=N).map(|k| dofs_per_simplex(degree, k)).collect());
        let all: Vec<usize> = (0..=N).collect();
        Self {
            tables: Arc::new(Tables {
                mesh: mesh.clone(),
                degree,
                numbering,
                slots: slots_on(&all, N, degree),
                derivatives: Derivatives::new(degree),
            }),
        }
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh<N> {
        &self.tables.mesh
    }

    /// r.
    pub fn degree(&self) -> usize {
        self.tables.degree
    }

    /// The dimension.
    pub fn len(&self) -> usize {
        self.tables.numbering.len()
    }

    /// Never.
    pub fn is_empty(&self) -> bool {
        self.tables.numbering.is_empty()
    }

    /// How the degrees of freedom are numbered.
    pub fn numbering(&self) -> &Numbering {
        &self.tables.numbering
    }

    /// The global index of the coefficient of B_α in q_ab on a cell: edges in the order of [`subsets`], α in that of
    /// [`crate::simplex::multi_indices`].
    pub fn cell_dof(&self, cell: usize, edge: usize, alpha: usize) -> usize {
        let tables = &self.tables;
        tables
            .numbering
            .of_cell(&tables.mesh, cell, tables.slots[edge][alpha])
    }

    /// Where the coefficients of the q_ab on a cell are numbered, by edge, then by α.
    pub(super) fn slots(&self) -> &[Vec<Slot>] {
        &self.tables.slots
    }

    /// The derivatives of polynomials of degree r on a cell.
    pub(super) fn derivatives(&self) -> &Derivatives<N> {
        &self.tables.derivatives
    }

    /// Where the coefficients of the q_ab on the subsimplex with these local vertices of a cell are numbered, by edge of
    /// the subsimplex, then by α.
    pub fn trace_slots(&self, vertices: &[usize]) -> Vec<Slot> {
        slots_on(vertices, N, self.tables.degree).concat()
    }
}

impl<const N: usize> TestSpace<N> for ReggeSpace<N> {
    type Value = Symmetric;

    fn mesh(&self) -> &Mesh<N> {
        &self.tables.mesh
    }

    fn len(&self) -> usize {
        self.tables.numbering.len()
    }

    fn cell_len(&self) -> usize {
        self.tables.slots.len() * self.tables.slots[0].len()
    }

    fn push_dofs(&self, cell: usize, dofs: &mut Vec<usize>) {
        let Tables {
            mesh, numbering, ..
        } = &*self.tables;
        let slots = self.tables.slots.iter().flatten();
        dofs.extend(slots.map(|&slot| numbering.of_cell(mesh, cell, slot)));
    }

    fn trace(&self, vertices: &[usize]) -> Trace {
        Trace {
            basis: Bernstein::new(vertices.len(), self.tables.degree),
            numbers: numbers(&self.trace_slots(vertices), &self.tables.slots.concat()),
        }
    }
}

/// Where B_α in q_ab is numbered, by edge and α, on the simplex with the given local vertices of an n-simplex.
pub(crate) fn slots_on(vertices: &[usize], n: usize, degree: usize) -> Vec<Vec<Slot>> {
    let places: Vec<Vec<Vec<usize>>> = (0..=n).map(|k| subsets(n + 1, k + 1)).collect();
    let mut seen: Vec<Vec<usize>> = places.iter().map(|p| vec![0; p.len()]).collect();
    let exponents = crate::simplex::multi_indices(vertices.len(), degree);
    subsets(vertices.len(), 2)
        .into_iter()
        .map(|edge| {
            exponents
                .iter()
                .map(|alpha| {
                    let charged = |i: &usize| alpha[*i] > 0 || edge.contains(i);
                    let support: Vec<usize> = (0..vertices.len())
                        .filter(charged)
                        .map(|i| vertices[i])
                        .collect();
                    let k = support.len() - 1;
                    let place = places[k].iter().position(|p| *p == support).expect(
                        "the simplex that two vertices and a support span belongs to the cell",
                    );
                    let index = seen[k][place];
                    seen[k][place] += 1;
                    Slot { k, place, index }
                })
                .collect()
        })
        .collect()
}

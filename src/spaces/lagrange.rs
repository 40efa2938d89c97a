//! Lagrange spaces: continuous functions, piecewise polynomial of degree q.
//!
//! The basis is Bernstein's, each function attached to the simplex whose vertices it charges; a trace on a simplex
//! is made of the functions of the simplex and of its faces. For q = 1 it consists of the hat functions.

use super::test::{Scalar, TestSpace, Trace};
use crate::mesh::{Mesh, Numbering, Slot};
use crate::simplex::{Bernstein, binomial, subsets};

/// Continuous piecewise P_q on a mesh.
#[derive(Clone, Debug)]
pub struct Lagrange<const N: usize> {
    mesh: Mesh<N>,
    degree: usize,
    numbering: Numbering,
    slots: Vec<Slot>,
}

impl<const N: usize> Lagrange<N> {
    /// The space of degree q ≥ 1 (0 is taken as 1: constants alone are not continuous piecewise).
    pub fn new(mesh: &Mesh<N>, degree: usize) -> Self {
        let degree = degree.max(1);
        // Exponents that charge all k+1 vertices of a k-simplex: C(q−1, k).
        let numbering = Numbering::new(mesh, (0..=N).map(|k| binomial(degree - 1, k)).collect());
        let all: Vec<usize> = (0..=N).collect();
        let slots = slots_on(&all, N, degree);
        Self {
            mesh: mesh.clone(),
            degree,
            numbering,
            slots,
        }
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh<N> {
        &self.mesh
    }

    /// q.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The dimension, boundary functions included.
    pub fn len(&self) -> usize {
        self.numbering.len()
    }

    /// Never.
    pub fn is_empty(&self) -> bool {
        self.numbering.is_empty()
    }

    /// The polynomials on a k-simplex, in the order of its degrees of freedom.
    pub fn basis(&self, k: usize) -> Bernstein {
        Bernstein::new(k + 1, self.degree)
    }

    /// How many basis functions live on a cell.
    pub fn cell_len(&self) -> usize {
        self.slots.len()
    }

    /// The global indices of the basis functions on a cell.
    pub fn cell_dofs(&self, cell: usize) -> impl Iterator<Item = usize> + '_ {
        self.slots
            .iter()
            .map(move |&slot| self.numbering.of_cell(&self.mesh, cell, slot))
    }

    /// Where the basis functions on the subsimplex with these local vertices of a cell are numbered.
    pub fn trace_slots(&self, vertices: &[usize]) -> Vec<Slot> {
        slots_on(vertices, N, self.degree)
    }

    /// The global indices of slots in a cell.
    pub fn dofs<'a>(&'a self, cell: usize, slots: &'a [Slot]) -> impl Iterator<Item = usize> + 'a {
        slots
            .iter()
            .map(move |&slot| self.numbering.of_cell(&self.mesh, cell, slot))
    }

    /// The simplex (its dimension and number) that carries a basis function.
    pub fn owner(&self, dof: usize) -> (usize, usize) {
        self.numbering.owner(dof)
    }

    /// Does a basis function vanish on the boundary of the mesh?
    pub fn vanishes_on_boundary(&self, dof: usize) -> bool {
        let (k, simplex) = self.owner(dof);
        self.mesh.is_interior(k, simplex)
    }
}

impl<const N: usize> TestSpace<N> for Lagrange<N> {
    type Value = Scalar;

    fn mesh(&self) -> &Mesh<N> {
        &self.mesh
    }

    fn len(&self) -> usize {
        self.numbering.len()
    }

    fn cell_len(&self) -> usize {
        self.slots.len()
    }

    fn push_dofs(&self, cell: usize, dofs: &mut Vec<usize>) {
        dofs.extend(self.cell_dofs(cell));
    }

    fn trace(&self, vertices: &[usize]) -> Trace {
        Trace {
            basis: self.basis(vertices.len() - 1),
            numbers: numbers(&self.trace_slots(vertices), &self.slots),
        }
    }
}

/// Where in the list of a cell's slots each of these is.
pub(super) fn numbers(slots: &[Slot], cell: &[Slot]) -> Vec<usize> {
    let number = |slot: &Slot| cell.iter().position(|s| s == slot);
    let found: Option<Vec<usize>> = slots.iter().map(number).collect();
    found.expect("a trace consists of functions of the cell")
}

/// The slots of the Bernstein polynomials on the simplex with the given local vertices of an n-simplex.
fn slots_on(vertices: &[usize], n: usize, degree: usize) -> Vec<Slot> {
    let places: Vec<Vec<Vec<usize>>> = (0..=n).map(|k| subsets(n + 1, k + 1)).collect();
    let mut seen: Vec<Vec<usize>> = places.iter().map(|p| vec![0; p.len()]).collect();
    Bernstein::new(vertices.len(), degree)
        .exponents()
        .iter()
        .map(|alpha| {
            let support: Vec<usize> = (0..vertices.len())
                .filter(|&i| alpha[i] > 0)
                .map(|i| vertices[i])
                .collect();
            let k = support.len() - 1;
            let place = places[k]
                .iter()
                .position(|p| *p == support)
                .expect("the support of a polynomial is a simplex of the cell");
            // Exponents with one support come in one order, whatever the simplex around it.
            let index = seen[k][place];
            seen[k][place] += 1;
            Slot { k, place, index }
        })
        .collect()
}

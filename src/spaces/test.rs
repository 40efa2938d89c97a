//! Test spaces: what a measure on cells, faces and hinges is paired with.
//!
//! A test function is polynomial on every simplex of a cell; its trace there is a sum of Bernstein polynomials times
//! *directions*: the number 1 for scalar functions, a tensor for each edge for symmetric tensors (a vector space would have one
//! for each axis, 4-tensors one for each pair of edges). A measure says what its density is in each direction; then pairing
//! knows nothing of geometry.

use crate::mesh::Mesh;
use crate::simplex::{Bernstein, subsets};

/// What values test functions have: what a density is contracted with.
pub trait Value: Send + Sync + 'static {
    /// How many directions the values have on a k-simplex.
    fn directions(k: usize) -> usize;
}

/// Numbers.
#[derive(Clone, Copy, Debug)]
pub struct Scalar;

impl Value for Scalar {
    fn directions(_k: usize) -> usize {
        1
    }
}

/// Symmetric (0,2)-tensors on tangent vectors of the simplex: a direction for each edge ab, in the order of [`subsets`], is the
/// tensor whose edge component q_ab is 1 and all others 0.
#[derive(Clone, Copy, Debug)]
pub struct Symmetric;

impl Value for Symmetric {
    fn directions(k: usize) -> usize {
        k * (k + 1) / 2
    }
}

/// The traces of the test functions of a cell on one of its simplices.
#[derive(Clone, Debug)]
pub struct Trace {
    /// The polynomials on the simplex.
    pub basis: Bernstein,
    /// By direction, then by polynomial: which of the cell's functions has this trace.
    pub numbers: Vec<usize>,
}

/// A space of test functions on a mesh in dimension N. Its functions are numbered globally, and on each cell locally.
pub trait TestSpace<const N: usize>: Sync {
    /// The kind of its values.
    type Value: Value;

    /// The mesh.
    fn mesh(&self) -> &Mesh<N>;
    /// How many functions.
    fn len(&self) -> usize;
    /// None at all?
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// How many functions live on a cell.
    fn cell_len(&self) -> usize;
    /// Appends the global numbers of the functions of a cell, in their local order.
    fn push_dofs(&self, cell: usize, dofs: &mut Vec<usize>);
    /// The traces on the simplex with these local vertices of a cell. The polynomials are the same on all simplices of a dimension.
    fn trace(&self, vertices: &[usize]) -> Trace;
}

/// One function for each cell, face and hinge, which is 1 there and tests nothing else: what is paired with it is summed simplex by
/// simplex.
///
/// The functions of cells come first, then those of faces, then those of hinges.
#[derive(Clone, Debug)]
pub struct Indicators<const N: usize> {
    mesh: Mesh<N>,
}

impl<const N: usize> Indicators<N> {
    /// On a mesh.
    pub fn new(mesh: &Mesh<N>) -> Self {
        Self { mesh: mesh.clone() }
    }

    /// The numbers of the functions of the simplices of codimension 0, 1 or 2.
    pub fn range(&self, codimension: usize) -> std::ops::Range<usize> {
        let before: usize = (0..codimension).map(|c| self.mesh.count(N - c)).sum();
        before..before + self.mesh.count(N - codimension)
    }
}

impl<const N: usize> TestSpace<N> for Indicators<N> {
    type Value = Scalar;

    fn mesh(&self) -> &Mesh<N> {
        &self.mesh
    }

    fn len(&self) -> usize {
        self.range(2).end
    }

    fn cell_len(&self) -> usize {
        1 + (N + 1) + N * (N + 1) / 2
    }

    fn push_dofs(&self, cell: usize, dofs: &mut Vec<usize>) {
        dofs.push(cell);
        for codimension in 1..=2 {
            let start = self.range(codimension).start;
            let simplices = self.mesh.simplices_of(cell, N - codimension);
            dofs.extend(simplices.iter().map(|&s| start + s as usize));
        }
    }

    fn trace(&self, vertices: &[usize]) -> Trace {
        let place = subsets(N + 1, vertices.len())
            .iter()
            .position(|p| p == vertices)
            .expect("the vertices are those of a simplex of the cell, ascending");
        let start = match N + 1 - vertices.len() {
            0 => 0,
            1 => 1,
            _ => 1 + (N + 1),
        };
        Trace {
            basis: Bernstein::new(vertices.len(), 0),
            numbers: vec![start + place],
        }
    }
}

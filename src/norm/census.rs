//! What is known of a mesh without having it: enough to choose a solver, and to say how much memory it will take.

use super::iterative::Lattice;
use crate::mesh::Mesh;
use crate::simplex::binomial;

/// How many simplices of each dimension a mesh has, and whether it is a cube's.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Census {
    /// The number of k-simplices, k = 0…N.
    pub simplices: Vec<usize>,
    /// How many faces are in the boundary.
    pub boundary: usize,
    /// Is it one that [`Mesh::cube`] makes, inner vertices moved or not?
    pub cube: bool,
}

impl Census {
    /// Of a mesh.
    pub fn of<const N: usize>(mesh: &Mesh<N>) -> Self {
        Self {
            simplices: (0..=N).map(|k| mesh.count(k)).collect(),
            boundary: mesh.count(N - 1) - mesh.interior(N - 1).count(),
            cube: Lattice::of(mesh).is_some(),
        }
    }

    /// Of what `Mesh::<n>::cube(side)` would be: a box is cut into n! simplices.
    ///
    /// A k-simplex is a chain of k steps through the axes. The steps take j ≥ k axes together, in as many ways as there are
    /// maps of j things onto k; the first vertex has `side` places along these axes, and one more along the others.
    pub fn cube(n: usize, side: usize) -> Self {
        let places = |j: usize| side.pow(j as u32) * (side + 1).pow((n - j) as u32);
        let chains = |k: usize, j: usize| binomial(n, j) * onto(j, k) * places(j);
        Self {
            simplices: (0..=n)
                .map(|k| (k..=n).map(|j| chains(k, j)).sum())
                .collect(),
            // Each of the 2n sides is cut like a cube of one dimension less.
            boundary: 2 * n * side.pow(n as u32 - 1) * (1..n).product::<usize>(),
            cube: true,
        }
    }
}

/// How many maps of j things are onto k things.
fn onto(j: usize, k: usize) -> usize {
    match (j, k) {
        (0, 0) => 1,
        (0, _) | (_, 0) => 0,
        // The last thing has one of k images, of which the others either are still all taken or all but this one.
        _ => k * (onto(j - 1, k) + onto(j - 1, k - 1)),
    }
}

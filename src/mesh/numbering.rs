//! Degrees of freedom that belong to the simplices of a mesh, so many to each k-simplex.

use super::Mesh;

/// A degree of freedom as a cell sees it: it belongs to one of the cell's simplices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    /// The dimension of the simplex.
    pub k: usize,
    /// Which of the cell's k-simplices, in the order of [`crate::simplex::subsets`].
    pub place: usize,
    /// Which of the simplex' degrees of freedom.
    pub index: usize,
}

/// Global indices: first those of all vertices, then of all edges, and so on up to the cells.
#[derive(Clone, Debug)]
pub struct Numbering {
    per_simplex: Vec<usize>,
    offsets: Vec<usize>,
}

impl Numbering {
    /// `per_simplex[k]` degrees of freedom for each k-simplex, k = 0…N.
    pub fn new<const N: usize>(mesh: &Mesh<N>, per_simplex: Vec<usize>) -> Self {
        let mut offsets = vec![0];
        for (k, per) in per_simplex.iter().enumerate() {
            offsets.push(offsets[k] + per * mesh.count(k));
        }
        Self {
            per_simplex,
            offsets,
        }
    }

    /// How many in all.
    pub fn len(&self) -> usize {
        *self.offsets.last().unwrap_or(&0)
    }

    /// None at all?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many belong to each k-simplex.
    pub fn per_simplex(&self, k: usize) -> usize {
        self.per_simplex[k]
    }

    /// The global index of a simplex' degree of freedom.
    #[inline]
    pub fn global(&self, k: usize, simplex: usize, index: usize) -> usize {
        self.offsets[k] + simplex * self.per_simplex[k] + index
    }

    /// The global index of a cell's degree of freedom.
    #[inline]
    pub fn of_cell<const N: usize>(&self, mesh: &Mesh<N>, cell: usize, slot: Slot) -> usize {
        let simplex = if slot.k == N {
            cell
        } else {
            mesh.simplex_of(cell, slot.k, slot.place)
        };
        self.global(slot.k, simplex, slot.index)
    }

    /// The simplex (its dimension and number) that a degree of freedom belongs to.
    pub fn owner(&self, dof: usize) -> (usize, usize) {
        let k = self.offsets.partition_point(|&o| o <= dof) - 1;
        (k, (dof - self.offsets[k]) / self.per_simplex[k])
    }
}

//! Gmsh's order of the nodes of a triangle or tetrahedron of order k.

use regge_curvature::simplex::multi_indices;
use std::collections::HashMap;

/// The edges of a tetrahedron, from where to where; the first three are those of a triangle.
const EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [3, 0], [3, 2], [3, 1]];
/// The faces of a tetrahedron; the nodes inside one are those of a triangle with these corners.
const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [3, 1, 2]];

/// The exponents α, |α| = k, of the nodes x(α/k), in Gmsh's order: corners, edges, faces, inside; what is inside is again a
/// simplex, of order k − 3 or k − 4.
pub fn nodes(dimension: usize, order: usize) -> Vec<Vec<usize>> {
    let corners = dimension + 1;
    if order == 0 {
        return vec![vec![0; corners]];
    }
    let on = |parts: &[(usize, usize)]| {
        let mut alpha = vec![0; corners];
        parts.iter().for_each(|&(v, a)| alpha[v] = a);
        alpha
    };
    let mut all: Vec<Vec<usize>> = (0..corners).map(|v| on(&[(v, order)])).collect();
    let edges = if dimension == 2 { 3 } else { 6 };
    for [a, b] in &EDGES[..edges] {
        all.extend((1..order).map(|i| on(&[(*a, order - i), (*b, i)])));
    }
    if order > 2 {
        let inside = nodes(2, order - 3);
        let faces: &[[usize; 3]] = if dimension == 2 { &[[0, 1, 2]] } else { &FACES };
        for face in faces {
            let raised = |i: &Vec<usize>| on(&[0, 1, 2].map(|j| (face[j], i[j] + 1)));
            all.extend(inside.iter().map(raised));
        }
    }
    if dimension == 3 && order > 3 {
        let inside = nodes(3, order - 4).into_iter();
        all.extend(inside.map(|alpha| alpha.iter().map(|a| a + 1).collect()));
    }
    all
}

/// From the order of a file to that of the library: where the node α of a cell whose corners ascend stands among Gmsh's.
pub struct Sorted {
    dimension: usize,
    order: usize,
    /// By the order of the corners.
    known: HashMap<Vec<usize>, Vec<usize>>,
}

impl Sorted {
    /// For cells of one kind.
    pub fn new(dimension: usize, order: usize) -> Self {
        Self {
            dimension,
            order,
            known: HashMap::new(),
        }
    }

    /// The places of the nodes of a cell, in the order of [`multi_indices`].
    pub fn places(&mut self, cell: &[usize]) -> &[usize] {
        let mut corners: Vec<usize> = (0..cell.len()).collect();
        corners.sort_by_key(|&i| cell[i]);
        let (dimension, order) = (self.dimension, self.order);
        self.known.entry(corners).or_insert_with_key(|corners| {
            let given = nodes(dimension, order);
            let place = |alpha: Vec<usize>| {
                let mut mine = vec![0; corners.len()];
                for (&corner, a) in corners.iter().zip(alpha) {
                    mine[corner] = a;
                }
                let place = given.iter().position(|node| *node == mine);
                place.expect("every exponent of the order is a node")
            };
            multi_indices(dimension + 1, order)
                .into_iter()
                .map(place)
                .collect()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What Gmsh 4.15 itself says (`gmsh.model.mesh.getElementProperties`) of the nodes behind corners and edges, which are
    /// those that are easily got wrong, and of the last edges.
    #[test]
    fn nodes_stand_as_gmsh_has_them() {
        let triangle = nodes(2, 4);
        assert_eq!(triangle.len(), 15);
        assert_eq!(
            triangle[9..],
            [
                [1, 0, 3],
                [2, 0, 2],
                [3, 0, 1],
                [2, 1, 1],
                [1, 2, 1],
                [1, 1, 2]
            ]
        );
        let tetrahedron = nodes(3, 4);
        assert_eq!(tetrahedron.len(), 35);
        assert_eq!(
            tetrahedron[13..16],
            [[1, 0, 0, 3], [2, 0, 0, 2], [3, 0, 0, 1]]
        );
        assert_eq!(
            tetrahedron[19..22],
            [[0, 1, 0, 3], [0, 2, 0, 2], [0, 3, 0, 1]]
        );
        assert_eq!(
            tetrahedron[22..],
            [
                [2, 1, 1, 0],
                [1, 1, 2, 0],
                [1, 2, 1, 0],
                [2, 1, 0, 1],
                [1, 2, 0, 1],
                [1, 1, 0, 2],
                [2, 0, 1, 1],
                [1, 0, 1, 2],
                [1, 0, 2, 1],
                [0, 1, 1, 2],
                [0, 2, 1, 1],
                [0, 1, 2, 1],
                [1, 1, 1, 1]
            ]
        );
        assert_eq!(
            nodes(3, 2)[4..],
            [
                [1, 1, 0, 0],
                [0, 1, 1, 0],
                [1, 0, 1, 0],
                [1, 0, 0, 1],
                [0, 0, 1, 1],
                [0, 1, 0, 1]
            ]
        );
        for (dimension, order) in [(2, 1), (2, 5), (3, 1), (3, 3), (3, 5)] {
            let (mut all, mut expected) =
                (nodes(dimension, order), multi_indices(dimension + 1, order));
            all.sort_unstable();
            expected.sort_unstable();
            assert_eq!(all, expected, "every exponent once");
        }
    }
}

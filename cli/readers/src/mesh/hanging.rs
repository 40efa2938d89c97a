//! Hanging nodes: a vertex on the boundary that lies in a boundary face without being a vertex of it.
//!
//! A node that hangs inside the domain makes faces of one cell on both sides of it, so that this finds it as well,
//! and says more than that the cells around it are no manifold.

use nalgebra::{DMatrix, DVector};

/// How near counts as on a face, relative to the face and to the distance from its corners: a neighbour of a corner in a thin cell
/// is near the face without hanging.
const NEAR: f64 = 1e-9;

/// Where the vertices are: a row of coordinates each, of which the first ones count.
pub struct Places<'a> {
    /// All rows.
    pub coordinates: &'a [f64],
    /// The length of a row.
    pub width: usize,
    /// The dimension of the domain.
    pub dimension: usize,
}

impl Places<'_> {
    fn at(&self, vertex: usize) -> &[f64] {
        &self.coordinates[vertex * self.width..][..self.dimension]
    }

    /// The first vertex of the boundary that hangs, and the vertices of the face that it lies in; `faces` has the vertices of one
    /// face of the boundary after the other.
    pub fn hanging(&self, faces: &[usize]) -> Option<(usize, Vec<usize>)> {
        let first = |v: usize| self.at(v)[0];
        let mut boundary = faces.to_vec();
        boundary.sort_by(|a, b| first(*a).total_cmp(&first(*b)).then(a.cmp(b)));
        boundary.dedup();
        for face in faces.chunks_exact(self.dimension) {
            let (low, high) = self.frame(face);
            let start = boundary.partition_point(|v| first(*v) < low[0]);
            for &v in &boundary[start..] {
                if first(v) > high[0] {
                    break;
                }
                let mut around = self.at(v).iter().zip(low.iter().zip(&high));
                let inside = around.all(|(x, (low, high))| low <= x && x <= high);
                if inside && !face.contains(&v) && self.lies_in(face, v) {
                    return Some((v, face.to_vec()));
                }
            }
        }
        None
    }

    /// The box around a face, a little widened.
    fn frame(&self, face: &[usize]) -> (DVector<f64>, DVector<f64>) {
        let corner = |v: usize| DVector::from_column_slice(self.at(v));
        let (mut low, mut high) = (corner(face[0]), corner(face[0]));
        for &v in face {
            low = low.inf(&corner(v));
            high = high.sup(&corner(v));
        }
        let margin = NEAR * (&high - &low).norm();
        (low.add_scalar(-margin), high.add_scalar(margin))
    }

    /// Is the vertex in the face? By the least squares solution of x = x_0 + Σ λ_i (x_i − x_0).
    fn lies_in(&self, face: &[usize], vertex: usize) -> bool {
        let from = |v: usize, w: usize, i: usize| self.at(w)[i] - self.at(v)[i];
        let edges = DMatrix::from_fn(self.dimension, face.len() - 1, |i, j| {
            from(face[0], face[j + 1], i)
        });
        let off = DVector::from_fn(self.dimension, |i, _| from(face[0], vertex, i));
        let Some(lambda) = edges.tr_mul(&edges).lu().solve(&edges.tr_mul(&off)) else {
            return false;
        };
        let distance =
            |v: usize| DVector::from_fn(self.dimension, |i, _| from(v, vertex, i)).norm();
        let apart = face.iter().map(|v| distance(*v));
        let within = lambda.iter().all(|l| *l >= -NEAR) && lambda.sum() <= 1.0 + NEAR;
        within && (off - edges * lambda).norm() <= NEAR * apart.fold(f64::INFINITY, f64::min)
    }
}

/// The faces of one cell only, each with ascending vertices, one after the other.
pub fn boundary_faces(cells: &[Vec<usize>]) -> Vec<usize> {
    let mut faces: Vec<Vec<usize>> = Vec::new();
    for cell in cells {
        for out in 0..cell.len() {
            let mut face = cell.clone();
            face.remove(out);
            face.sort_unstable();
            faces.push(face);
        }
    }
    faces.sort_unstable();
    let runs = faces.chunk_by(|a, b| a == b);
    let once: Vec<&[usize]> = runs
        .filter(|run| run.len() == 1)
        .map(|run| run[0].as_slice())
        .collect();
    once.concat()
}

//! How large cells are in ℝ^N, and how far from flat.

use super::Mesh;
use crate::linalg::ldlt;

impl<const N: usize> Mesh<N> {
    /// The largest edge length in ℝ^N: h = max_T h_T. Zero without coordinates.
    pub fn mesh_size(&self) -> f64 {
        let mut size: f64 = 0.0;
        for cell in 0..self.cell_count() {
            for i in 0..=N {
                for j in 0..i {
                    if let (Some(a), Some(b)) = (self.corner(cell, i), self.corner(cell, j)) {
                        size = size.max((a - b).norm());
                    }
                }
            }
        }
        size
    }

    /// A cell's shape, if there are coordinates: N |det A|^(2/N) / |A|² with Frobenius' norm, where A takes a regular simplex to the cell.
    /// 1 for a regular cell, 0 for a flat one, whatever the size and orientation; N = 3: 12 (3 volume)^(2/3) by the sum of the
    /// squared edge lengths.
    ///
    /// Source: A. Liu and B. Joe, Relationship between tetrahedron shape measures, BIT 34 (1994): the mean ratio.
    pub fn mean_ratio(&self, cell: usize) -> Option<f64> {
        let jacobian = self.jacobian(cell)?;
        let gram = jacobian.transpose() * jacobian;
        // A regular simplex with edges 1 has (δ_ij + 1)/2 here, whose determinant is (N+1)/2^N.
        let n = N as f64;
        let determinant = ldlt(&gram).factors.diagonal().product() / (n + 1.0);
        let trace = gram.trace() - gram.sum() / (n + 1.0);
        Some(n * determinant.max(0.0).powf(1.0 / n) / trace)
    }
}

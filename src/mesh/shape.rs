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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linalg::Vector;

    fn one<const N: usize>(points: &[[f64; N]]) -> Mesh<N> {
        let points = points.iter().map(|&x| Vector::from(x)).collect();
        Mesh::new(points, &[(0..=N).collect()]).unwrap()
    }

    /// 1 for regular cells, by the edges and the volume for others, and the same for a cell of any size, up to rounding: that of the
    /// regular ones is a few units, that of the others is multiplied by the condition of their Gram matrix, some 10².
    #[test]
    fn mean_ratios() {
        let equilateral = one([[0.0, 0.0], [2.0, 0.0], [1.0, 3_f64.sqrt()]].as_slice());
        let regular = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0]];
        let regular = one(&[&regular[..], &[[-1.0, -1.0, 1.0]]].concat());
        assert!((equilateral.mean_ratio(0).unwrap() - 1.0).abs() < 1e-14);
        assert!((regular.mean_ratio(0).unwrap() - 1.0).abs() < 1e-14);
        for scale in [1.0, 1e-3] {
            let points = [[0.0; 3], [1.0, 0.0, 0.0], [0.3, 0.8, 0.1], [0.2, 0.4, 0.15]];
            let points = points.map(|x| x.map(|x| scale * x));
            let mesh = one(&points);
            let squares = (0..4).flat_map(|i| (0..i).map(move |j| (i, j)));
            let squares = squares
                .map(|(i, j)| (Vector::from(points[i]) - Vector::from(points[j])).norm_squared());
            let volume = mesh.jacobian(0).unwrap().determinant().abs() / 6.0;
            let expected = 12.0 * (3.0 * volume).powf(2.0 / 3.0) / squares.sum::<f64>();
            assert!((mesh.mean_ratio(0).unwrap() / expected - 1.0).abs() < 1e-12);
        }
    }
}

//! A case: what its file says, its mesh and its metric.

use nalgebra::DMatrix;
use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::mesh::Mesh;
use regge_curvature::simplex::{Bernstein, subsets};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};
use serde::Deserialize;

/// One case.
#[derive(Clone, Debug, Deserialize)]
pub struct Oracle {
    /// The name of its file.
    pub name: String,
    /// N.
    pub dimension: usize,
    /// r.
    pub degree: usize,
    /// The name of the smooth metric.
    pub metric: String,
    /// How g_h was made of it.
    pub interpolant: String,
    /// Points of ℝ^N.
    pub vertices: Vec<Vec<f64>>,
    /// Cells.
    pub simplices: Vec<Vec<usize>>,
    /// g_h on each cell, at as many points as determine it.
    pub samples: Vec<Sample>,
    /// The three sums.
    pub curvature: Curvature,
    /// The error's norm, where it was computed.
    pub hm2: Option<HMinus2>,
}

/// ‖(Rω)_dist(g_h) − (Rω)(g)‖ in H⁻².
#[derive(Clone, Debug, Deserialize)]
pub struct HMinus2 {
    /// The degree of the auxiliary plate's deflection.
    pub hhj_degree: usize,
    /// The norm.
    pub error: f64,
}

/// g_h at points of a cell.
#[derive(Clone, Debug, Deserialize)]
pub struct Sample {
    /// Points of ℝ^N.
    pub points: Vec<Vec<f64>>,
    /// g_h there, row by row.
    pub g: Vec<Vec<f64>>,
}

/// ⟨(Rω)_dist(g_h), φ_i⟩ for the hat functions of the inner vertices.
#[derive(Clone, Debug, Deserialize)]
pub struct Curvature {
    /// The vertices i.
    pub vertex: Vec<usize>,
    /// Σ_T.
    pub element: Vec<f64>,
    /// Σ_F, factor 2 included.
    pub face: Vec<f64>,
    /// Σ_S, factor 2 included.
    pub angle: Vec<f64>,
    /// ∫Rωφ_i of the smooth metric, where there was a closed form.
    pub smooth: Option<Vec<f64>>,
}

impl Curvature {
    /// The largest of its numbers.
    pub fn largest(&self) -> f64 {
        let all = self.element.iter().chain(&self.face).chain(&self.angle);
        all.fold(0.0, |m: f64, x| m.max(x.abs()))
    }

    /// Of a vector over all vertices the entries of the tested ones.
    pub fn tested(&self, all: &[f64]) -> Vec<f64> {
        self.vertex.iter().map(|&v| all[v]).collect()
    }
}

impl Oracle {
    /// Its mesh.
    pub fn mesh<const N: usize>(&self) -> Mesh<N> {
        let points = self
            .vertices
            .iter()
            .map(|v| Vector::from_column_slice(v))
            .collect();
        Mesh::new(points, &self.simplices).unwrap_or_else(|e| panic!("an oracle's mesh: {e}"))
    }

    /// The space that its metric is in.
    pub fn space<const N: usize>(&self, mesh: &Mesh<N>) -> ReggeSpace<N> {
        ReggeSpace::new(mesh, self.degree)
    }

    /// g_h: the Regge function through the samples.
    pub fn metric<const N: usize>(&self, space: &ReggeSpace<N>) -> ReggeFunction<f64, N> {
        let mesh = space.mesh();
        let basis = Bernstein::new(N + 1, self.degree);
        let mut coefficients = vec![f64::NAN; space.len()];
        for (cell, sample) in self.samples.iter().enumerate() {
            let lambda: Vec<Vec<f64>> = sample
                .points
                .iter()
                .map(|x| barycentric(mesh, cell, x))
                .collect();
            let lu =
                DMatrix::from_fn(basis.len(), basis.len(), |q, a| basis.value(a, &lambda[q])).lu();
            for (e, edge) in subsets(N + 1, 2).iter().enumerate() {
                let (Some(a), Some(b)) = (mesh.corner(cell, edge[0]), mesh.corner(cell, edge[1]))
                else {
                    continue;
                };
                let along = |q: usize| {
                    (b - a).dot(&(Mat::<f64, N>::from_row_slice(&sample.g[q]) * (b - a)))
                };
                let values = DMatrix::from_fn(basis.len(), 1, |q, _| along(q));
                if let Some(c) = lu.solve(&values) {
                    for alpha in 0..basis.len() {
                        coefficients[space.cell_dof(cell, e, alpha)] = c[alpha];
                    }
                }
            }
        }
        space
            .function(coefficients)
            .unwrap_or_else(|e| panic!("all coefficients: {e}"))
    }
}

/// The barycentric coordinates of a point in a cell.
fn barycentric<const N: usize>(mesh: &Mesh<N>, cell: usize, x: &[f64]) -> Vec<f64> {
    let corner = |i: usize| mesh.corner(cell, i).unwrap_or_else(Vector::zeros);
    // Σ λ_i = 1, Σ λ_i x_i = x.
    let matrix = DMatrix::from_fn(N + 1, N + 1, |row, i| {
        if row == 0 { 1.0 } else { corner(i)[row - 1] }
    });
    let right = DMatrix::from_fn(N + 1, 1, |row, _| if row == 0 { 1.0 } else { x[row - 1] });
    let solved = matrix.lu().solve(&right);
    solved.map_or(vec![f64::NAN; N + 1], |l| l.iter().copied().collect())
}

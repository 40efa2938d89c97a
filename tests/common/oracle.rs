//! The reference cases of tests/oracle.

use nalgebra::{DMatrix, DVector, SVector};
use regge::linalg::Mat;
use regge::mesh::Mesh;
use regge::regge::{ReggeFunction, ReggeSpace};
use regge::simplex::{Bernstein, subsets};
use serde::Deserialize;

#[derive(Deserialize)]
pub struct Oracle {
    pub name: String,
    pub dimension: usize,
    pub degree: usize,
    pub metric: String,
    pub interpolant: String,
    pub vertices: Vec<Vec<f64>>,
    pub simplices: Vec<Vec<usize>>,
    pub samples: Vec<Sample>,
    pub curvature: Curvature,
    pub hm2: Option<HMinus2>,
}

#[derive(Deserialize)]
pub struct Sample {
    pub points: Vec<Vec<f64>>,
    pub g: Vec<Vec<f64>>,
}

#[derive(Deserialize)]
pub struct Curvature {
    pub vertex: Vec<usize>,
    pub element: Vec<f64>,
    pub face: Vec<f64>,
    pub angle: Vec<f64>,
    pub smooth: Option<Vec<f64>>,
}

#[derive(Deserialize)]
pub struct HMinus2 {
    pub hhj_degree: usize,
    pub error: f64,
}

impl Curvature {
    /// The largest entry of the three sums.
    pub fn largest(&self) -> f64 {
        let all = self.element.iter().chain(&self.face).chain(&self.angle);
        all.fold(0.0, |m: f64, x| m.max(x.abs()))
    }
}

/// All cases, by name.
pub fn load_all() -> Vec<Oracle> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/oracle");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .expect("the folder of oracles")
        .map(|e| e.expect("an entry").path())
        .filter(|p| p.extension().is_some_and(|e| e == "json"))
        .collect();
    files.sort();
    assert_eq!(files.len(), 10, "ten cases were copied");
    let read = |p| std::fs::read_to_string(p).expect("a readable case");
    files
        .iter()
        .map(|p| serde_json::from_str(&read(p)).expect("a case"))
        .collect()
}

impl Oracle {
    pub fn mesh<const N: usize>(&self) -> Mesh<N> {
        let points = self
            .vertices
            .iter()
            .map(|v| SVector::from_column_slice(v))
            .collect();
        Mesh::new(points, &self.simplices).expect("a mesh")
    }

    pub fn space<'m, const N: usize>(&self, mesh: &'m Mesh<N>) -> ReggeSpace<'m, N> {
        ReggeSpace::new(mesh, self.degree)
    }

    /// The Regge function through the samples.
    pub fn metric<'s, const N: usize>(
        &self,
        space: &'s ReggeSpace<'s, N>,
    ) -> ReggeFunction<'s, f64, N> {
        let mesh = space.mesh();
        let basis = Bernstein::new(N + 1, self.degree);
        let mut coefficients = vec![f64::NAN; space.len()];
        for (cell, sample) in self.samples.iter().enumerate() {
            let map = mesh.jacobian(cell).expect("coordinates");
            let inverse = DMatrix::from_fn(N, N, |i, j| map[(i, j)])
                .try_inverse()
                .expect("regular");
            let origin = mesh.corner(cell, 0).expect("coordinates");
            let lambda = |q: usize| {
                let x = DVector::from_fn(N, |i, _| sample.points[q][i] - origin[i]);
                let xi = &inverse * x;
                let mut lambda = vec![1.0 - xi.sum()];
                lambda.extend(xi.iter());
                lambda
            };
            let values =
                DMatrix::from_fn(basis.len(), basis.len(), |q, a| basis.value(a, &lambda(q)));
            let lu = values.lu();
            for (e, edge) in subsets(N + 1, 2).iter().enumerate() {
                let t = mesh.corner(cell, edge[1]).expect("coordinates")
                    - mesh.corner(cell, edge[0]).expect("coordinates");
                let q = DVector::from_fn(basis.len(), |q, _| {
                    let g = Mat::<f64, N>::from_row_slice(&sample.g[q]);
                    t.dot(&(g * t))
                });
                let c = lu.solve(&q).expect("unisolvent");
                for alpha in 0..basis.len() {
                    coefficients[space.cell_dof(cell, e, alpha)] = c[alpha];
                }
            }
        }
        space.function(coefficients).expect("all coefficients")
    }
}

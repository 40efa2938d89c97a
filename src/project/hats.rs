//! The mass matrix of hat functions, and conjugate gradients for it.
//!
//! On a simplex it is a multiple of I + 11ᵀ where the volume form is constant, so that D⁻¹M, D its diagonal, has all eigenvalues
//! between ½ and (N + 2)/2, whatever the mesh (Wathen, IMA Journal of Numerical Analysis 7 (1987)): 26 steps for N = 2 reach
//! rounding, where a factorisation of a million unknowns would take gigabytes. Only the ends of an edge meet, so that the matrix
//! is a number for each vertex and one for each edge.

use super::Tested;
use crate::Error;
use crate::density::Volume;
use crate::field::Evaluate;
use crate::linalg::inverse_and_det;
use crate::mesh::Mesh;
use crate::parallel::rows_in_order;
use crate::quadrature::Rule;
use crate::simplex::{Bernstein, subsets};

/// The residual that counts as none, relative to the load's: what is left is rounding.
const TOLERANCE: f64 = 1e-15;
/// Volume forms that differ much within a cell take more steps; this many are never needed by one that can be integrated.
const STEPS: usize = 1000;

/// ∫ φ_i φ_j ω(g).
#[derive(Debug)]
pub(super) struct HatMass {
    /// By vertex; 1 where the vertex is no unknown.
    diagonal: Vec<f64>,
    /// Both ends, and the entry: the edges between unknowns.
    pairs: Vec<([u32; 2], f64)>,
    /// Is it an unknown?
    kept: Vec<bool>,
}

impl HatMass {
    /// In the metric g, integrals by a rule on cells.
    pub fn new<const N: usize, G: Evaluate<f64, N>>(
        g: &G,
        mesh: &Mesh<N>,
        tested: Tested,
        rule: &Rule,
    ) -> Result<Self, Error> {
        let table = g.tabulate(rule.points());
        let hats = Bernstein::new(N + 1, 1).tabulate::<f64>(rule.points());
        let edges = subsets(N + 1, 2);
        let on_cell = |cell: usize, row: &mut [f64], (): &mut ()| {
            let local = g.on_cell(cell);
            for (q, weight) in rule.weights().iter().enumerate() {
                let (_, det) = inverse_and_det(&g.value(&local, &table, q));
                let scale = Volume::from_det(det) * weight;
                let (ends, between) = row.split_at_mut(N + 1);
                for (entry, hat) in ends.iter_mut().zip(&hats[q]) {
                    *entry += scale * hat * hat;
                }
                for (entry, edge) in between.iter_mut().zip(&edges) {
                    *entry += scale * hats[q][edge[0]] * hats[q][edge[1]];
                }
            }
        };
        let mut diagonal = vec![0.0; mesh.count(0)];
        let mut off = vec![0.0; mesh.count(1)];
        let add = |cell: usize, row: &[f64]| {
            let (ends, between) = row.split_at(N + 1);
            for (&vertex, entry) in mesh.simplices_of(cell, 0).iter().zip(ends) {
                diagonal[vertex as usize] += entry;
            }
            for (&edge, entry) in mesh.simplices_of(cell, 1).iter().zip(between) {
                off[edge as usize] += entry;
            }
        };
        let width = N + 1 + edges.len();
        rows_in_order(mesh.cell_count(), width, 0.0, || (), on_cell, add);
        let keep = |vertex: usize| tested == Tested::All || mesh.is_interior(0, vertex);
        let kept: Vec<bool> = (0..mesh.count(0)).map(keep).collect();
        if let Some(vertex) = diagonal.iter().position(|d| d.is_nan() || *d <= 0.0) {
            let reason = "the cells around it have no volume".into();
            return Err(Error::Vertex { vertex, reason });
        }
        let ends = |edge: usize| [mesh.vertices(1, edge)[0], mesh.vertices(1, edge)[1]];
        let all = off
            .into_iter()
            .enumerate()
            .map(|(e, entry)| (ends(e), entry));
        let pairs = all.filter(|([a, b], _)| kept[*a as usize] && kept[*b as usize]);
        Ok(Self {
            pairs: pairs.collect(),
            diagonal,
            kept,
        })
    }

    /// M x.
    fn apply(&self, x: &[f64], out: &mut [f64]) {
        for ((out, d), x) in out.iter_mut().zip(&self.diagonal).zip(x) {
            *out = d * x;
        }
        for &([a, b], entry) in &self.pairs {
            let (a, b) = (a as usize, b as usize);
            out[a] += entry * x[b];
            out[b] += entry * x[a];
        }
    }

    /// M⁻¹ of a load, 0 where there is no unknown.
    pub fn solve(&self, load: &[f64]) -> Result<Vec<f64>, Error> {
        let mut r: Vec<f64> = load.to_vec();
        for (r, kept) in r.iter_mut().zip(&self.kept) {
            *r = if *kept { *r } else { 0.0 };
        }
        let scaled =
            |r: &[f64]| -> Vec<f64> { r.iter().zip(&self.diagonal).map(|(r, d)| r / d).collect() };
        let (mut x, mut p) = (vec![0.0; r.len()], scaled(&r));
        let mut product = vec![0.0; r.len()];
        let mut rho = dot(&r, &p);
        let enough = TOLERANCE * TOLERANCE * rho;
        for _ in 0..STEPS {
            if rho <= enough {
                return Ok(x);
            }
            self.apply(&p, &mut product);
            let step = rho / dot(&p, &product);
            for i in 0..x.len() {
                x[i] += step * p[i];
                r[i] -= step * product[i];
            }
            let z = scaled(&r);
            let next = dot(&r, &z);
            let turn = next / rho;
            for (p, z) in p.iter_mut().zip(&z) {
                *p = z + turn * *p;
            }
            rho = next;
        }
        Err(Error::Solver(format!(
            "the mass matrix is not solved in {STEPS} steps: the volume form is all but degenerate in a cell"
        )))
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

//! Floor 2. How far g_h is from g, cell by cell, in the norms of section 4, all of them Euclidean.

use crate::local::tensor_components;
use crate::pieces::{diameter, euclidean_frame, stretch};
use regge_curvature::field::Evaluate;
use regge_curvature::mesh::Mesh;
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::Points;

/// A symmetric tensor field on one cell T.
#[derive(Clone, Copy, Debug)]
pub struct OnCell {
    /// h_T.
    pub h: f64,
    /// |·|_{W^{j,∞}(T)}, j = 0, 1, 2, over the points of a rule and the vertices.
    pub sup: [f64; 3],
    /// |·|²_{H^j(T)}, j = 0, 1, 2.
    pub squares: [f64; 3],
}

/// A symmetric tensor field, such as g_h − g, by cells.
#[derive(Clone, Debug)]
pub struct Distance {
    /// The cells.
    pub cells: Vec<OnCell>,
}

impl Distance {
    /// Of a field on a mesh with coordinates, by rules of this order.
    pub fn new<const N: usize, S: Evaluate<f64, N>>(
        mesh: &Mesh<N>,
        field: &S,
        order: usize,
    ) -> Self {
        let rule = Rule::new(N, order);
        let mut lambda: Vec<f64> = (0..rule.len())
            .flat_map(|q| rule.points().lambda(q).to_vec())
            .collect();
        lambda.extend((0..=N).flat_map(|i| (0..=N).map(move |j| f64::from(u8::from(i == j)))));
        let points = Points::new(N + 1, lambda);
        let table = field.tabulate(&points);
        let cells = (0..mesh.cell_count()).map(|cell| {
            let (local, frame) = (field.on_cell(cell), euclidean_frame(mesh, cell));
            let volume = stretch(mesh, cell);
            let mut here = OnCell {
                h: diameter(mesh, cell, &(0..=N).collect::<Vec<_>>()),
                sup: [0.0; 3],
                squares: [0.0; 3],
            };
            for point in 0..points.len() {
                let jets = field.jet2(&local, &table, point);
                let weight = rule.weights().get(point).copied().unwrap_or(0.0) * volume;
                for order in 0..3 {
                    let components = tensor_components(&jets, &frame, order);
                    let square: f64 = components.iter().map(|x| x * x).sum();
                    here.sup[order] = here.sup[order].max(square.sqrt());
                    here.squares[order] += weight * square;
                }
            }
            here
        });
        Self {
            cells: cells.collect(),
        }
    }

    /// (weight, h_T^order |∂^order ·|) at the points of a rule in all cells, the weights with the volume.
    pub fn at_points<const N: usize, S: Evaluate<f64, N>>(
        mesh: &Mesh<N>,
        field: &S,
        rule: &Rule,
        order: usize,
    ) -> Vec<(f64, f64)> {
        let table = field.tabulate(rule.points());
        let mut all = Vec::new();
        for cell in 0..mesh.cell_count() {
            let (local, frame) = (field.on_cell(cell), euclidean_frame(mesh, cell));
            let volume = stretch(mesh, cell);
            let h = diameter(mesh, cell, &(0..=N).collect::<Vec<_>>());
            for (point, weight) in rule.weights().iter().enumerate() {
                let jets = field.jet2(&local, &table, point);
                let components = tensor_components(&jets, &frame, order);
                let square: f64 = components.iter().map(|x| x * x).sum();
                all.push((weight * volume, h.powi(order as i32) * square.sqrt()));
            }
        }
        all
    }

    /// max_T h_T^power |·|_{W^{order,∞}(T)}.
    pub fn sup(&self, order: usize, power: i32) -> f64 {
        let all = self
            .cells
            .iter()
            .map(|cell| cell.h.powi(power) * cell.sup[order]);
        all.fold(0.0, f64::max)
    }

    /// (Σ_T Σ_{j ≤ top} h_T^{2j} |·|²_{H^j(T)})^{1/2}.
    pub fn weighted(&self, top: usize) -> f64 {
        let of = |cell: &OnCell| -> f64 {
            (0..=top)
                .map(|j| cell.h.powi(2 * j as i32) * cell.squares[j])
                .sum()
        };
        self.cells.iter().map(of).sum::<f64>().sqrt()
    }

    /// |·|_{H^order} over all cells.
    pub fn broken(&self, order: usize) -> f64 {
        self.cells
            .iter()
            .map(|cell| cell.squares[order])
            .sum::<f64>()
            .sqrt()
    }
}

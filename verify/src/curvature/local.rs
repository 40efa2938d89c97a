//! The curvature simplex by simplex: ∫R on cells, ∫⟦H⟧ on faces.

use rayon::prelude::*;
use regge::field::TensorField;
use regge::hypersurface::{Normal, mean_curvature, outward, second_form};
use regge::jet::Jet1;
use regge::mesh::{Mesh, Side};
use regge::quadrature::Rule;
use regge::riemann::Connection;
use regge::simplex::subsets;

/// ∫_T R ω for every cell.
pub fn cell_integrals<const N: usize, G>(g: &G, mesh: &Mesh<N>, rule: &Rule) -> Vec<f64>
where
    G: TensorField<f64, N>,
{
    if g.is_constant() {
        return vec![0.0; mesh.cells()];
    }
    let table = g.tabulate(rule.points());
    let of_cell = |cell| {
        let local = g.on_cell(cell);
        let mut sum = 0.0;
        for (q, weight) in rule.weights().iter().enumerate() {
            let connection = Connection::new(&g.jet2(&local, &table, q));
            sum += weight * connection.scalar() * connection.det.value.sqrt();
        }
        sum
    };
    (0..mesh.cells()).into_par_iter().map(of_cell).collect()
}

/// ∫_F ⟦H⟧ ω_F for every interior face, in the mesh's order.
pub fn face_integrals<const N: usize, G>(g: &G, mesh: &Mesh<N>, rule: &Rule) -> Vec<(usize, f64)>
where
    G: TensorField<f64, N>,
{
    let tables: Vec<G::Table> = subsets(N + 1, N)
        .iter()
        .map(|on| g.tabulate(&rule.points().embed(on, N + 1)))
        .collect();
    let one_side = |side: Side| {
        let local = g.on_cell(side.cell);
        // Place p is the face opposite to vertex N − p.
        let nu = outward::<f64, N>(N - side.place);
        let mut sum = 0.0;
        for (q, weight) in rule.weights().iter().enumerate() {
            let connection = Connection::new(&g.jet1(&local, &tables[side.place], q));
            let normal = Normal::new(&connection.inverse, &nu);
            let form = second_form(&connection, &nu.map(Jet1::constant), &normal);
            let omega = normal.length * connection.det.sqrt();
            sum += weight * mean_curvature(&normal, &form) * omega;
        }
        sum
    };
    let faces: Vec<usize> = mesh.interior_faces().collect();
    let of_face = |&face: &usize| match g.is_constant() {
        true => (face, 0.0),
        false => (face, mesh.star(N - 1, face).map(one_side).sum()),
    };
    faces.par_iter().map(of_face).collect()
}

//! Floor 1. Functions by their coefficients in Lagrange spaces.

use nalgebra::{DMatrix, DVector};
use regge_curvature::Error;
use regge_curvature::linalg::Vector;
use regge_curvature::simplex::Points;
use regge_curvature::spaces::Lagrange;

/// The coefficients of the function of a Lagrange space that is v at the points of the principal lattices: v itself, if v is
/// continuous and on every cell a polynomial of the space's degree. `v` is given the cell and the place.
///
/// # Errors
/// If the mesh has no coordinates.
pub fn coefficients<const N: usize>(
    space: &Lagrange<N>,
    v: &dyn Fn(usize, &[f64; N]) -> f64,
) -> Result<Vec<f64>, Error> {
    let (mesh, basis) = (space.mesh(), space.basis(N));
    let lattice = |alpha: &Vec<usize>| -> Vec<f64> {
        let share = |a: &usize| *a as f64 / space.degree() as f64;
        alpha.iter().map(share).collect()
    };
    let lambda: Vec<Vec<f64>> = basis.exponents().iter().map(lattice).collect();
    let points = Points::new(N + 1, lambda.concat());
    let rows = basis.tabulate::<f64>(&points);
    let values = DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j]);
    let inverse = (values.try_inverse()).expect("polynomials are determined on their lattice");
    let mut all = vec![0.0; space.len()];
    for cell in 0..mesh.cell_count() {
        let corners: Option<Vec<Vector<f64, N>>> = (0..=N).map(|i| mesh.corner(cell, i)).collect();
        let corners = corners.ok_or(Error::NoCoordinates("a function"))?;
        let at = |lambda: &Vec<f64>| -> f64 {
            let x: Vector<f64, N> = corners.iter().zip(lambda).map(|(c, l)| c * *l).sum();
            v(cell, &x.into())
        };
        let found = &inverse * DVector::from_iterator(lambda.len(), lambda.iter().map(at));
        for (dof, c) in space.cell_dofs(cell).zip(found.iter()) {
            all[dof] = *c;
        }
    }
    Ok(all)
}

//! ∫ R(g) v ω of the smooth metric, where R(g) is stated by a formula.

use crate::input::expression::Expression;
use regge::field::TensorField;
use regge::lagrange::Lagrange;
use regge::linalg::indefinite_pivot;
use regge::quadrature::Rule;
use regge::smooth::{Smooth, SmoothTensor};
use regge::{Error, linalg::inverse_and_det};

/// Σ_T ∫_T R v ω for every basis function v, with R by its own formula.
pub fn stated_curvature<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<'_, M, N>,
    exact: &Expression,
    space: &Lagrange<'_, N>,
    rule: &Rule,
) -> Vec<f64> {
    let mesh = space.mesh();
    let basis = space.basis(N).tabulate::<f64>(rule.points());
    let table = TensorField::<f64, N>::tabulate(g, rule.points());
    let mut load = vec![0.0; space.len()];
    for cell in 0..mesh.cells() {
        let local = TensorField::<f64, N>::on_cell(g, cell);
        for (q, weight) in rule.weights().iter().enumerate() {
            let x = place(g, cell, rule.points().lambda(q));
            let (_, det) = inverse_and_det(&g.value(&local, &table, q));
            let density = exact.at(&x) * det.sqrt() * weight;
            for (dof, value) in space.cell_dofs(cell).zip(&basis[q]) {
                load[dof] += density * value;
            }
        }
    }
    load
}

/// The point with these barycentric coordinates in ℝ^N.
fn place<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<'_, M, N>,
    cell: usize,
    lambda: &[f64],
) -> [f64; N] {
    let mut x = [0.0; N];
    for (i, l) in lambda.iter().enumerate() {
        // A formula lives on meshes with coordinates only.
        if let Some(corner) = g.mesh().corner(cell, i) {
            for a in 0..N {
                x[a] += l * corner[a];
            }
        }
    }
    x
}

/// Is the formula finite and positive definite at the points of a rule in every cell?
///
/// # Errors
/// Names the first cell and point where it is not.
pub fn check_formula<M: SmoothTensor<N>, const N: usize>(
    g: &Smooth<'_, M, N>,
    rule: &Rule,
) -> Result<(), Error> {
    let table = TensorField::<f64, N>::tabulate(g, rule.points());
    for cell in 0..g.mesh().cells() {
        let local = TensorField::<f64, N>::on_cell(g, cell);
        for q in 0..rule.len() {
            let jets = g.jet2(&local, &table, q);
            let x = place(g, cell, rule.points().lambda(q));
            let parts = |jet: &regge::jet::Jet2<f64, N>| {
                let all = jet.dd.iter().flatten().chain(&jet.d).chain([&jet.value]);
                all.fold(0.0, |sum: f64, part| sum + part.abs())
            };
            if jets.iter().any(|jet| !parts(jet).is_finite()) {
                let reason = format!(
                    "the metric or a derivative of it is not finite at x = {x:?}: it divides by zero there, say"
                );
                return Err(Error::Cell { cell, reason });
            }
            if let Some(pivot) = indefinite_pivot(&jets.map(|jet| jet.value)) {
                let reason = format!(
                    "the metric is not positive definite at x = {x:?} (pivot {pivot:e}): check the formula"
                );
                return Err(Error::Cell { cell, reason });
            }
        }
    }
    Ok(())
}

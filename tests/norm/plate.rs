//! The clamped plate u = Π(1−x_i²)² on (−1, 1)^N, with load vectors and errors.

use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::mesh::Mesh;
use regge_curvature::norm::{HMinus2, Representative};
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::Bernstein;
use regge_curvature::spaces::Lagrange;

/// (1−x²)² and its derivatives.
fn factor(x: f64) -> [f64; 5] {
    let s = 1.0 - x * x;
    [s * s, -4.0 * x * s, 12.0 * x * x - 4.0, 24.0 * x, 24.0]
}

/// Π_i ∂_i^{orders_i} (1−x_i²)².
fn derivative<const N: usize>(x: &Vector<f64, N>, orders: [usize; N]) -> f64 {
    (0..N).map(|i| factor(x[i])[orders[i]]).product()
}

/// u.
pub fn plate<const N: usize>(x: &Vector<f64, N>) -> f64 {
    derivative(x, [0; N])
}

/// ∇²u.
fn hessian<const N: usize>(x: &Vector<f64, N>) -> Mat<f64, N> {
    Mat::from_fn(|i, j| {
        let mut orders = [0; N];
        orders[i] += 1;
        orders[j] += 1;
        derivative(x, orders)
    })
}

/// Δ²u = Σ_ij ∂_i²∂_j² u.
pub fn plate_bilaplacian<const N: usize>(x: &Vector<f64, N>) -> f64 {
    let mut sum = 0.0;
    for i in 0..N {
        for j in 0..N {
            let mut orders = [0; N];
            orders[i] += 2;
            orders[j] += 2;
            sum += derivative(x, orders);
        }
    }
    sum
}

/// The place in ℝ^N of a barycentric point.
pub fn place<const N: usize>(mesh: &Mesh<N>, cell: usize, lambda: &[f64]) -> Vector<f64, N> {
    (0..=N)
        .map(|v| mesh.corner(cell, v).unwrap() * lambda[v])
        .sum()
}

/// ∫ f v for all v of a space.
pub fn load_of<const N: usize>(space: &Lagrange<N>, f: fn(&Vector<f64, N>) -> f64) -> Vec<f64> {
    // Exact for the plate: Δ²u has degree 4N−4.
    let rule = Rule::new(N, 4 * N - 4 + space.degree());
    let basis = Bernstein::new(N + 1, space.degree()).tabulate::<f64>(rule.points());
    let mut load = vec![0.0; space.len()];
    for cell in 0..space.mesh().cell_count() {
        let volume = space.mesh().jacobian(cell).unwrap().volume();
        for (alpha, dof) in space.cell_dofs(cell).enumerate() {
            for q in 0..rule.len() {
                let x = place(space.mesh(), cell, rule.points().lambda(q));
                load[dof] += volume * rule.weights()[q] * f(&x) * basis[q][alpha];
            }
        }
    }
    load
}

/// ‖u_h − u‖/‖u‖ and ‖σ_h − ∇²u‖/‖∇²u‖ in L².
pub fn errors<const N: usize>(norm: &HMinus2<N>, solution: &Representative) -> [f64; 2] {
    let space = norm.space();
    let mesh = space.mesh();
    let rule = Rule::new(N, 2 * space.degree() + 6);
    let basis = Bernstein::new(N + 1, space.degree()).tabulate::<f64>(rule.points());
    let (mut errors, mut sizes) = ([0.0; 2], [0.0; 2]);
    for cell in 0..mesh.cell_count() {
        let volume = mesh.jacobian(cell).unwrap().volume();
        let u: Vec<f64> = space
            .cell_dofs(cell)
            .map(|dof| solution.coefficients[dof])
            .collect();
        let sigma = norm.hhj().moment(solution, cell, rule.points());
        for q in 0..rule.len() {
            let x = place(mesh, cell, rule.points().lambda(q));
            let weight = volume * rule.weights()[q];
            let value: f64 = u.iter().zip(&basis[q]).map(|(c, b)| c * b).sum();
            errors[0] += weight * (value - plate(&x)).powi(2);
            errors[1] += weight * (sigma[q] - hessian(&x)).norm_squared();
            sizes[0] += weight * plate(&x).powi(2);
            sizes[1] += weight * hessian(&x).norm_squared();
        }
    }
    [(errors[0] / sizes[0]).sqrt(), (errors[1] / sizes[1]).sqrt()]
}

/// |det| of a square matrix.
pub trait Volume {
    /// |det|.
    fn volume(&self) -> f64;
}

impl<const N: usize> Volume for Mat<f64, N> {
    fn volume(&self) -> f64 {
        nalgebra::DMatrix::from_fn(N, N, |i, j| self[(i, j)])
            .determinant()
            .abs()
    }
}

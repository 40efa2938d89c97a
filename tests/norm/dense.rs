//! A second route to the discrete solution: the mixed method as it is printed, with Cartesian components of broken
//! moments, multipliers for the continuity of σ(n,n), and one dense indefinite system.

use super::plate::Volume;
use nalgebra::{DMatrix, DVector};
use regge_curvature::linalg::{Mat, Vector};
use regge_curvature::mesh::Mesh;
use regge_curvature::norm::HMinus2Norm;
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::{Bernstein, factorial, multi_indices, subsets};
use regge_curvature::spaces::Lagrange;

/// B_α of one degree with Cartesian gradients and Hessians, by B_α' = p Σ_v ∇λ_v B_{α−e_v}.
struct Polynomials<const N: usize> {
    gradients: Vec<Vector<f64, N>>,
    degree: usize,
}

impl<const N: usize> Polynomials<N> {
    fn new(mesh: &Mesh<N>, cell: usize, degree: usize) -> Self {
        // Rows (1, x_v): the inverse's columns are the coefficients of λ_v.
        let corners = DMatrix::from_fn(N + 1, N + 1, |v, i| match i {
            0 => 1.0,
            _ => mesh.corner(cell, v).unwrap()[i - 1],
        });
        let inverse = corners.try_inverse().unwrap();
        let gradient = |v: usize| Vector::from_fn(|i, _| inverse[(i + 1, v)]);
        Self {
            gradients: (0..=N).map(gradient).collect(),
            degree,
        }
    }

    fn value(alpha: &[usize], lambda: &[f64]) -> f64 {
        let degree: usize = alpha.iter().sum();
        let powers = alpha
            .iter()
            .zip(lambda)
            .map(|(&a, l)| l.powi(a as i32) / factorial(a));
        factorial(degree) * powers.product::<f64>()
    }

    /// ∇B_α.
    fn gradient(&self, alpha: &[usize], lambda: &[f64]) -> Vector<f64, N> {
        let mut sum = Vector::zeros();
        for v in (0..=N).filter(|&v| alpha[v] > 0) {
            let mut lower = alpha.to_vec();
            lower[v] -= 1;
            sum += self.gradients[v] * (self.degree as f64 * Self::value(&lower, lambda));
        }
        sum
    }

    /// ∇²B_α.
    fn hessian(&self, alpha: &[usize], lambda: &[f64]) -> Mat<f64, N> {
        let mut sum = Mat::<f64, N>::zeros();
        for v in (0..=N).filter(|&v| alpha[v] > 0) {
            let mut lower = alpha.to_vec();
            lower[v] -= 1;
            let inner = Self {
                gradients: self.gradients.clone(),
                degree: self.degree - 1,
            };
            sum +=
                self.gradients[v] * inner.gradient(&lower, lambda).transpose() * self.degree as f64;
        }
        sum
    }
}

/// The blocks of the system: (σ, τ), b(τ, v), and ∫_F σ(n,n) μ with the sides' signs.
struct System<const N: usize> {
    mass: DMatrix<f64>,
    pairing: DMatrix<f64>,
    jumps: DMatrix<f64>,
}

fn pairs<const N: usize>() -> Vec<(usize, usize)> {
    (0..N).flat_map(|i| (i..N).map(move |j| (i, j))).collect()
}

/// E_ij, the Cartesian unit tensors.
fn unit<const N: usize>((i, j): (usize, usize)) -> Mat<f64, N> {
    Mat::from_fn(|a, b| f64::from(u8::from((a, b) == (i, j) || (b, a) == (i, j))))
}

fn assemble<const N: usize>(mesh: &Mesh<N>, space: &Lagrange<N>) -> System<N> {
    let p = space.degree();
    let moments = multi_indices(N + 1, p - 1);
    let slopes = Bernstein::new(N, p - 1).len();
    let per_cell = moments.len() * pairs::<N>().len();
    let faces: Vec<usize> = mesh.interior_faces().collect();
    let mut system = System {
        mass: DMatrix::zeros(per_cell * mesh.cell_count(), per_cell * mesh.cell_count()),
        pairing: DMatrix::zeros(per_cell * mesh.cell_count(), space.len()),
        jumps: DMatrix::zeros(per_cell * mesh.cell_count(), slopes * faces.len()),
    };
    for cell in 0..mesh.cell_count() {
        let polynomials = Polynomials::new(mesh, cell, p);
        inside(mesh, space, cell, &polynomials, &moments, &mut system);
        for place in 0..=N {
            around(
                mesh,
                space,
                cell,
                place,
                &polynomials,
                &moments,
                &faces,
                &mut system,
            );
        }
    }
    system
}

/// ∫_T σ:τ and ∫_T τ:∇²v.
fn inside<const N: usize>(
    mesh: &Mesh<N>,
    space: &Lagrange<N>,
    cell: usize,
    polynomials: &Polynomials<N>,
    moments: &[Vec<usize>],
    system: &mut System<N>,
) {
    let (rule, pairs) = (Rule::new(N, 2 * space.degree()), pairs::<N>());
    let first = cell * pairs.len() * moments.len();
    let volume = mesh.jacobian(cell).unwrap().volume();
    let dofs: Vec<usize> = space.cell_dofs(cell).collect();
    for q in 0..rule.len() {
        let (weight, lambda) = (volume * rule.weights()[q], rule.points().lambda(q));
        let values: Vec<f64> = moments
            .iter()
            .map(|m| Polynomials::<N>::value(m, lambda))
            .collect();
        for (a, &pair) in pairs.iter().enumerate() {
            for k in 0..moments.len() {
                let row = first + a * moments.len() + k;
                for l in 0..moments.len() {
                    let column = first + a * moments.len() + l;
                    system.mass[(row, column)] +=
                        weight * values[k] * values[l] * unit::<N>(pair).norm_squared();
                }
                for (alpha, &dof) in multi_indices(N + 1, space.degree()).iter().zip(&dofs) {
                    let contraction = unit::<N>(pair).dot(&polynomials.hessian(alpha, lambda));
                    system.pairing[(row, dof)] += weight * values[k] * contraction;
                }
            }
        }
    }
}

/// −∫_F τ(n,n) ∂_n v, and ±∫_F τ(n,n) μ on an interior face.
fn around<const N: usize>(
    mesh: &Mesh<N>,
    space: &Lagrange<N>,
    cell: usize,
    place: usize,
    polynomials: &Polynomials<N>,
    moments: &[Vec<usize>],
    faces: &[usize],
    system: &mut System<N>,
) {
    let (rule, pairs) = (Rule::new(N - 1, 2 * space.degree()), pairs::<N>());
    let corners = &subsets(N + 1, N)[place];
    let points = rule.points().embed(corners, N + 1);
    let face = mesh.simplices_of(cell, N - 1)[place] as usize;
    let normal = -polynomials.gradients[N - place].normalize();
    // √(det of the Gram matrix of the edges): the rule's weights add up to 1/(N−1)!.
    let edge = |i: usize| {
        mesh.corner(cell, corners[i + 1]).unwrap() - mesh.corner(cell, corners[0]).unwrap()
    };
    let area = DMatrix::from_fn(N - 1, N - 1, |i, j| edge(i).dot(&edge(j)))
        .determinant()
        .sqrt();
    let sign = if mesh.star(N - 1, face).next().unwrap().cell == cell {
        1.0
    } else {
        -1.0
    };
    let mu = multi_indices(N, space.degree() - 1);
    let first = cell * pairs.len() * moments.len();
    for q in 0..rule.len() {
        let (weight, lambda) = (area * rule.weights()[q], points.lambda(q));
        for (a, &pair) in pairs.iter().enumerate() {
            let nn = normal.dot(&(unit::<N>(pair) * normal));
            for (k, moment) in moments.iter().enumerate() {
                let row = first + a * moments.len() + k;
                let tau = weight * nn * Polynomials::<N>::value(moment, lambda);
                for (alpha, dof) in multi_indices(N + 1, space.degree())
                    .iter()
                    .zip(space.cell_dofs(cell))
                {
                    system.pairing[(row, dof)] -=
                        tau * normal.dot(&polynomials.gradient(alpha, lambda));
                }
                if let Some(f) = faces.iter().position(|&f| f == face) {
                    for (b, beta) in mu.iter().enumerate() {
                        let value = Polynomials::<N>::value(beta, rule.points().lambda(q));
                        system.jumps[(row, f * mu.len() + b)] += sign * tau * value;
                    }
                }
            }
        }
    }
}

/// The coefficients of u in the Lagrange space, and the norms.
pub fn solve<const N: usize>(
    mesh: &Mesh<N>,
    degree: usize,
    load: &[f64],
) -> (Vec<f64>, HMinus2Norm) {
    let space = Lagrange::new(mesh, degree);
    let System {
        mass,
        pairing,
        jumps,
    } = assemble(mesh, &space);
    let free: Vec<usize> = (0..space.len())
        .filter(|&i| space.vanishes_on_boundary(i))
        .collect();
    let (m, n, j) = (mass.nrows(), free.len(), jumps.ncols());
    // M σ − B u + C μ = 0, −Bᵀ σ = −f, Cᵀ σ = 0.
    let mut matrix = DMatrix::zeros(m + n + j, m + n + j);
    matrix.view_mut((0, 0), (m, m)).copy_from(&mass);
    let b = -pairing.select_columns(&free);
    matrix.view_mut((0, m), (m, n)).copy_from(&b);
    matrix.view_mut((m, 0), (n, m)).copy_from(&b.transpose());
    matrix.view_mut((0, m + n), (m, j)).copy_from(&jumps);
    matrix
        .view_mut((m + n, 0), (j, m))
        .copy_from(&jumps.transpose());
    let mut rhs = DVector::zeros(m + n + j);
    for (i, &dof) in free.iter().enumerate() {
        rhs[m + i] = -load[dof];
    }
    let x = matrix
        .full_piv_lu()
        .solve(&rhs)
        .expect("the mixed method is stable");
    let sigma = x.rows(0, m);
    let mut u = vec![0.0; space.len()];
    for (i, &dof) in free.iter().enumerate() {
        u[dof] = x[m + i];
    }
    let [u_l2, grad_l2] = norms_of(&space, &u);
    (
        u,
        HMinus2Norm {
            u_l2,
            grad_l2,
            sigma_l2: sigma.dot(&(&mass * sigma)).sqrt(),
        },
    )
}

/// ‖u‖ and ‖∇u‖.
fn norms_of<const N: usize>(space: &Lagrange<N>, u: &[f64]) -> [f64; 2] {
    let rule = Rule::new(N, 2 * space.degree());
    let (mut l2, mut h1) = (0.0, 0.0);
    for cell in 0..space.mesh().cell_count() {
        let polynomials = Polynomials::new(space.mesh(), cell, space.degree());
        let volume = space.mesh().jacobian(cell).unwrap().volume();
        for q in 0..rule.len() {
            let lambda = rule.points().lambda(q);
            let (mut value, mut gradient) = (0.0, Vector::<f64, N>::zeros());
            for (alpha, dof) in multi_indices(N + 1, space.degree())
                .iter()
                .zip(space.cell_dofs(cell))
            {
                value += u[dof] * Polynomials::<N>::value(alpha, lambda);
                gradient += polynomials.gradient(alpha, lambda) * u[dof];
            }
            l2 += volume * rule.weights()[q] * value * value;
            h1 += volume * rule.weights()[q] * gradient.norm_squared();
        }
    }
    [l2.sqrt(), h1.sqrt()]
}

//! Floor 0. Basis functions at points, their components in a frame, and the Gram matrices of such components.

use nalgebra::DMatrix;
use regge_curvature::Error;
use regge_curvature::field::Evaluate;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, Vector, matrix, vector};
use regge_curvature::simplex::{Bernstein, Points};
use regge_curvature::spaces::{ReggeFunction, ReggeSpace, TestSpace};

/// The basis of symmetric tensors on a cell, by its jets in reference coordinates, `[point][k]`: the same on all cells.
pub type Tensors<const N: usize> = Vec<Vec<Mat<Jet2<f64, N>, N>>>;

/// The basis of functions on a cell, `[point][j]`.
pub type Functions<const N: usize> = Vec<Vec<Jet2<f64, N>>>;

/// The k-th basis function of every cell at once.
///
/// # Errors
/// Never, for k below the number of a cell's functions.
pub fn local_function<const N: usize>(
    apart: &ReggeSpace<N>,
    k: usize,
) -> Result<ReggeFunction<f64, N>, Error> {
    let mut coefficients = vec![0.0; apart.len()];
    let mut dofs = Vec::new();
    for cell in 0..apart.mesh().cell_count() {
        dofs.clear();
        apart.push_dofs(cell, &mut dofs);
        coefficients[dofs[k]] = 1.0;
    }
    apart.function(coefficients)
}

/// The library's basis of a Regge space on cells apart, at points of a cell.
///
/// # Errors
/// Never: the space has as many functions as it says.
pub fn tensors<const N: usize>(
    apart: &ReggeSpace<N>,
    points: &Points,
) -> Result<Tensors<N>, Error> {
    let mut all = vec![Vec::new(); points.len()];
    for k in 0..TestSpace::cell_len(apart) {
        let psi = local_function(apart, k)?;
        let table = Evaluate::<f64, N>::tabulate(&psi, points);
        let local = Evaluate::<f64, N>::on_cell(&psi, 0);
        for (point, list) in all.iter_mut().enumerate() {
            list.push(psi.jet2(&local, &table, point));
        }
    }
    Ok(all)
}

/// Bernstein's basis of degree p at points of a cell.
pub fn functions<const N: usize>(p: usize, points: &Points) -> Functions<N> {
    Bernstein::new(N + 1, p).tabulate_jets(points)
}

/// What derivatives of order j of a tensor's components are, in a frame whose vectors are columns: ∂_c…∂_d σ(e_a, e_b).
pub fn tensor_components<const N: usize>(
    sigma: &Mat<Jet2<f64, N>, N>,
    frame: &Mat<f64, N>,
    order: usize,
) -> Vec<f64> {
    let along = |c: usize, m: usize| frame[(m, c)];
    let mut all = Vec::new();
    let mut push = |of: &dyn Fn(&Jet2<f64, N>) -> f64| {
        push_components(&matrix(|i, j| of(&sigma[(i, j)])), frame, &mut all);
    };
    match order {
        0 => push(&|x| x.value),
        1 => (0..N).for_each(|c| push(&|x| (0..N).map(|m| along(c, m) * x.d[m]).sum())),
        _ => {
            for c in 0..N {
                for d in 0..N {
                    push(&|x| {
                        let sum = |m: usize| (0..N).map(|n| along(d, n) * x.dd[m][n]).sum::<f64>();
                        (0..N).map(|m| along(c, m) * sum(m)).sum()
                    });
                }
            }
        }
    }
    all
}

/// The components σ(e_a, e_b), a ≤ b, those off the diagonal times √2: their squares add up to |σ|².
pub fn push_components<const N: usize>(
    sigma: &Mat<f64, N>,
    frame: &Mat<f64, N>,
    all: &mut Vec<f64>,
) {
    let seen = frame.transpose() * sigma * frame;
    for a in 0..N {
        for b in a..N {
            all.push(if a == b {
                seen[(a, b)]
            } else {
                seen[(a, b)] * 2.0_f64.sqrt()
            });
        }
    }
}

/// Derivatives of order j of a function, in a frame.
pub fn function_components<const N: usize>(
    v: &Jet2<f64, N>,
    frame: &Mat<f64, N>,
    order: usize,
) -> Vec<f64> {
    match order {
        0 => vec![v.value],
        1 => {
            let d: Vector<f64, N> = vector(|m| v.d[m]);
            (frame.transpose() * d).iter().copied().collect()
        }
        _ => {
            let mut all = Vec::new();
            push_components(&matrix(|m, n| v.dd[m][n]), frame, &mut all);
            all
        }
    }
}

/// A Gram matrix of basis functions, summed up from their components at points.
#[derive(Clone, Debug)]
pub struct Gram {
    len: usize,
    rows: Vec<f64>,
}

impl Gram {
    /// Of so many functions.
    pub fn new(len: usize) -> Self {
        Self {
            len,
            rows: Vec::new(),
        }
    }

    /// Adds weight Σ_c x_ic x_jc, from the components x_i of each function at a point.
    pub fn add(&mut self, weight: f64, components: &[Vec<f64>]) {
        let scale = weight.sqrt();
        for c in 0..components[0].len() {
            self.rows.extend(components.iter().map(|x| scale * x[c]));
        }
    }

    /// The matrix.
    pub fn matrix(&self) -> DMatrix<f64> {
        let columns = DMatrix::from_column_slice(self.len, self.rows.len() / self.len, &self.rows);
        &columns * columns.transpose()
    }
}

/// Columns: an orthonormal basis for a metric, e = L⁻ᵀ with g = L Lᵀ; None if g is not positive definite.
pub fn frame_of<const N: usize>(g: &Mat<f64, N>) -> Option<Mat<f64, N>> {
    g.cholesky()?.l().transpose().try_inverse()
}

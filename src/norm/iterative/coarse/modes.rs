//! Clamped splines on a cube, on which Δ² is all but diagonal in the modes of one axis: eigenvalues Σ λ_i + 2 Σ_{i<j} κ_i κ_j;
//! what the modes' first derivatives couple beyond that is left out.

use super::lattice::Lattice;
use super::spline::Modes;
use super::stencil::{Grid, Short};
use crate::Error;
use crate::linalg::Vector;
use crate::parallel::for_chunks;
use crate::sparse::in_parallel;
use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef};
use nalgebra::DMatrix;

/// How much the correction counts. Measured: with twice as much the iteration takes a fifth longer.
const WEIGHT: f64 = 0.4;

/// The inverse of Δ² in the modes of a cube.
#[derive(Clone, Debug)]
pub(super) struct Diagonal<const N: usize> {
    /// The edges of a spline cell.
    steps: Vector<f64, N>,
    /// The coefficients of the modes, a column each, and the transpose.
    modes: DMatrix<Short>,
    transposed: DMatrix<Short>,
    /// λ and κ of the modes by axis, in the mesh's units.
    lambda: Vec<Vec<f64>>,
    kappa: Vec<Vec<f64>>,
}

impl<const N: usize> Diagonal<N> {
    /// On the lattice of a mesh, for u of degree p.
    ///
    /// # Errors
    /// As [`Modes::new`].
    pub fn new(lattice: &Lattice<N>, p: usize) -> Result<(Self, Grid<N>), Error> {
        // One box of linear functions leaves no spline free.
        let refinement = if p * lattice.side < 2 { 2 } else { p };
        let steps = lattice.steps / refinement as f64;
        let modes = Modes::new(refinement * lattice.side)?;
        let by_axis = |list: &[f64], power: i32| -> Vec<Vec<f64>> {
            let scaled = |axis: usize| list.iter().map(|x| x * steps[axis].powi(-power)).collect();
            (0..N).map(scaled).collect()
        };
        let short = modes.coefficients.map(|x| x as Short);
        let grid = Grid {
            sides: [lattice.side * refinement + 3; N],
            lower: lattice.lower,
            density: lattice.steps.map(|step| refinement as f64 / step),
        };
        let diagonal = Self {
            steps,
            lambda: by_axis(&modes.lambda, 4),
            kappa: by_axis(&modes.kappa, 2),
            transposed: short.transpose(),
            modes: short,
        };
        Ok((diagonal, grid))
    }

    /// s becomes C⁻¹ s.
    pub fn solve(&self, s: &mut Vec<Short>) {
        for _ in 0..N {
            *s = rotate(s, &self.modes);
        }
        let m = self.modes.ncols();
        let plane = m.pow(N as u32 - 1);
        for_chunks(s, plane, |last, plane| {
            for (i, s) in plane.iter_mut().enumerate() {
                let mut index = [last; N];
                let mut rest = i;
                for digit in index.iter_mut().take(N - 1) {
                    *digit = rest % m;
                    rest /= m;
                }
                *s *= self.inverse(&index) as Short;
            }
        });
        for _ in 0..N {
            *s = rotate(s, &self.transposed);
        }
    }

    /// The weighted inverse eigenvalue of a product of modes.
    #[inline]
    fn inverse(&self, index: &[usize; N]) -> f64 {
        let (mut sum, mut squares, mut product) = (0.0, 0.0, 0.0);
        for (axis, &i) in index.iter().enumerate() {
            let kappa = self.kappa[axis][i];
            squares += self.lambda[axis][i];
            product += sum * kappa;
            sum += kappa;
        }
        let cell: f64 = self.steps.iter().product();
        WEIGHT / (cell * (squares + 2.0 * product))
    }
}

/// The products of a tensor with a matrix along its fastest axis, which becomes the slowest.
fn rotate(s: &[Short], matrix: &DMatrix<Short>) -> Vec<Short> {
    let (from, to) = matrix.shape();
    let rest = s.len() / from;
    let mut out = vec![0.0; rest * to];
    matmul(
        MatMut::from_column_major_slice_mut(&mut out, rest, to),
        Accum::Replace,
        MatRef::from_column_major_slice(s, from, rest).transpose(),
        MatRef::from_column_major_slice(matrix.as_slice(), from, to),
        1.0,
        in_parallel(),
    );
    out
}

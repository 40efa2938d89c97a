//! Cubic splines on [0, m] with knots at the integers, and those of them that are clamped at both ends.
//!
//! A spline is Σ c_i b(t − i + 3), i = 0…m+2, b the cardinal B-spline on [0, 4]: on [i, i+1] it is made of
//! c_i…c_{i+3}. It and its derivative vanish at 0 if c_1 = −c_2/2 and c_0 = c_2, and likewise at m, which leaves
//! c_2…c_m free.

use crate::Error;
use crate::quadrature::gauss_legendre;
use nalgebra::{DMatrix, DVector};

/// b(f + 3), b(f + 2), b(f + 1), b(f), f in [0, 1]: the weights of c_i…c_{i+3} at i + f.
#[inline]
pub(super) fn values(f: f64) -> [f64; 4] {
    let g = 1.0 - f;
    [
        g * g * g / 6.0,
        2.0 / 3.0 - f * f + 0.5 * f * f * f,
        2.0 / 3.0 - g * g + 0.5 * g * g * g,
        f * f * f / 6.0,
    ]
}

/// The derivatives of [`values`].
#[inline]
pub(super) fn slopes(f: f64) -> [f64; 4] {
    let g = 1.0 - f;
    [
        -0.5 * g * g,
        -2.0 * f + 1.5 * f * f,
        2.0 * g - 1.5 * g * g,
        0.5 * f * f,
    ]
}

/// The second derivatives of [`values`].
fn bends(f: f64) -> [f64; 4] {
    [1.0 - f, -2.0 + 3.0 * f, 1.0 - 3.0 * f, f]
}

/// The eigenvectors of v⁗ = λ v among the clamped splines.
#[derive(Clone, Debug)]
pub(super) struct Modes {
    /// Column j: the coefficients c_0…c_{m+2} of mode j, orthonormal in L²(0, m); λ ascends.
    pub coefficients: DMatrix<f64>,
    /// λ_j = ∫ |v_j″|².
    pub lambda: Vec<f64>,
    /// κ_j = ∫ |v_j′|².
    pub kappa: Vec<f64>,
}

impl Modes {
    /// On [0, m], m ≥ 2.
    ///
    /// # Errors
    /// If rounding spoils the mass matrix, which it does for no m within reach.
    pub fn new(m: usize) -> Result<Self, Error> {
        let clamped = clamped(m);
        let [mass, stiffness, bending] =
            pieces().map(|piece| clamped.tr_mul(&(gram(m, piece) * &clamped)));
        let failed = || Error::Solver("the splines' mass matrix is indefinite".into());
        let factor = mass.cholesky().ok_or_else(failed)?.unpack();
        // L⁻¹ K L⁻ᵀ has the eigenvectors Lᵀ v.
        let half = factor.solve_lower_triangular(&bending).ok_or_else(failed)?;
        let symmetric = factor
            .solve_lower_triangular(&half.transpose())
            .ok_or_else(failed)?;
        let eigen = symmetric.symmetric_eigen();
        let mut order: Vec<usize> = (0..eigen.eigenvalues.len()).collect();
        order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
        let columns: Vec<DVector<f64>> = order
            .iter()
            .map(|&j| eigen.eigenvectors.column(j).into_owned())
            .collect();
        let modes = factor
            .tr_solve_lower_triangular(&DMatrix::from_columns(&columns))
            .ok_or_else(failed)?;
        let quotient = |form: &DMatrix<f64>| -> Vec<f64> {
            (modes.column_iter()).map(|v| v.dot(&(form * v))).collect()
        };
        Ok(Self {
            lambda: quotient(&bending),
            kappa: quotient(&stiffness),
            coefficients: clamped * modes,
        })
    }
}

/// The coefficients c_0…c_{m+2} from the free ones.
fn clamped(m: usize) -> DMatrix<f64> {
    let mut c = DMatrix::zeros(m + 3, m - 1);
    for j in 0..m - 1 {
        c[(j + 2, j)] += 1.0;
    }
    c[(0, 0)] += 1.0;
    c[(1, 0)] -= 0.5;
    c[(m + 2, m - 2)] += 1.0;
    c[(m + 1, m - 2)] -= 0.5;
    c
}

/// The integrals over [i, i+1] of products of the four basis functions that live there.
pub(super) type Piece = [[f64; 4]; 4];

/// Of values, of derivatives and of second derivatives.
pub(super) fn pieces() -> [Piece; 3] {
    [values, slopes, bends].map(piece)
}

/// Of polynomials of degree ≤ 3.
fn piece(basis: fn(f64) -> [f64; 4]) -> Piece {
    let (points, weights) = gauss_legendre(4);
    let mut piece = [[0.0; 4]; 4];
    for (f, w) in points.into_iter().zip(weights) {
        let b = basis(f);
        for i in 0..4 {
            for j in 0..4 {
                piece[i][j] += w * b[i] * b[j];
            }
        }
    }
    piece
}

/// ∫₀^m of the products of basis functions.
fn gram(m: usize, piece: Piece) -> DMatrix<f64> {
    let mut a = DMatrix::zeros(m + 3, m + 3);
    for cell in 0..m {
        for i in 0..4 {
            for j in 0..4 {
                a[(cell + i, cell + j)] += piece[i][j];
            }
        }
    }
    a
}

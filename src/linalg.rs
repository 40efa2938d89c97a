//! Floor 1. Small symmetric matrices over any field: determinant and inverse.
//!
//! nalgebra's decompositions ask for an ordered field; exact fields and nested duals have none. A symmetric
//! positive definite matrix needs no pivoting, so LDLᵀ does for all scalars.

use crate::scalar::Field;
use nalgebra::{SMatrix, SVector};

/// An N×N array over T; a (0,2)-tensor's `[(i, j)]` component, or its inverse's.
pub type Mat<T, const N: usize> = SMatrix<T, N, N>;
/// N components over T; upper or lower as the context says.
pub type Vector<T, const N: usize> = SVector<T, N>;

/// The zero matrix.
#[inline]
pub fn zeros<T: Field, const N: usize>() -> Mat<T, N> {
    Mat::from_element(T::zero())
}

/// The identity matrix.
#[inline]
pub fn identity<T: Field, const N: usize>() -> Mat<T, N> {
    Mat::from_fn(|i, j| if i == j { T::one() } else { T::zero() })
}

/// A symmetric matrix from its entries with i ≤ j.
#[inline]
pub fn symmetric<T: Field, const N: usize>(entry: impl Fn(usize, usize) -> T) -> Mat<T, N> {
    let mut a = zeros();
    for i in 0..N {
        for j in i..N {
            let value = entry(i, j);
            a[(i, j)] = value;
            a[(j, i)] = value;
        }
    }
    a
}

/// a(x, y) = a_ij xⁱ yʲ.
#[inline]
pub fn form<T: Field, const N: usize>(a: &Mat<T, N>, x: &Vector<T, N>, y: &Vector<T, N>) -> T {
    let mut sum = T::zero();
    for i in 0..N {
        for j in 0..N {
            sum += a[(i, j)] * x[i] * y[j];
        }
    }
    sum
}

/// (A x)_i = a_ij xʲ.
#[inline]
pub fn apply<T: Field, const N: usize>(a: &Mat<T, N>, x: &Vector<T, N>) -> Vector<T, N> {
    let mut y = Vector::from_element(T::zero());
    for i in 0..N {
        for j in 0..N {
            y[i] += a[(i, j)] * x[j];
        }
    }
    y
}

/// α(X) = α_i Xⁱ.
#[inline]
pub fn contract<T: Field, const N: usize>(alpha: &Vector<T, N>, x: &Vector<T, N>) -> T {
    let mut sum = T::zero();
    for i in 0..N {
        sum += alpha[i] * x[i];
    }
    sum
}

/// a_ij b_ij: the full contraction; with one index pair up and the other down it is a g-inner product.
#[inline]
pub fn double_contract<T: Field, const N: usize>(a: &Mat<T, N>, b: &Mat<T, N>) -> T {
    let mut sum = T::zero();
    for i in 0..N {
        for j in 0..N {
            sum += a[(i, j)] * b[(i, j)];
        }
    }
    sum
}

/// B A B for symmetric A and B: with B = g⁻¹, both indices of A raised.
#[inline]
pub fn sandwich<T: Field, const N: usize>(b: &Mat<T, N>, a: &Mat<T, N>) -> Mat<T, N> {
    let mut ab = zeros::<T, N>();
    for i in 0..N {
        for j in 0..N {
            for k in 0..N {
                ab[(i, j)] += a[(i, k)] * b[(k, j)];
            }
        }
    }
    symmetric(|i, j| {
        let mut sum = T::zero();
        for k in 0..N {
            sum += b[(i, k)] * ab[(k, j)];
        }
        sum
    })
}

/// The factors of A = L D Lᵀ: L unit lower triangular below the diagonal, D on it.
///
/// Without pivoting: A is symmetric and its leading minors do not vanish (positive definite matrices).
pub fn ldlt<T: Field, const N: usize>(a: &Mat<T, N>) -> Mat<T, N> {
    let mut f = *a;
    for j in 0..N {
        for k in 0..j {
            let scaled = f[(j, k)] * f[(k, k)];
            for i in j..N {
                let l_ik = f[(i, k)];
                f[(i, j)] -= l_ik * scaled;
            }
        }
        let d = T::one() / f[(j, j)];
        for i in j + 1..N {
            f[(i, j)] *= d;
        }
    }
    f
}

/// A⁻¹ and det A of a symmetric matrix with non-vanishing leading minors.
pub fn inverse_and_det<T: Field, const N: usize>(a: &Mat<T, N>) -> (Mat<T, N>, T) {
    let f = ldlt(a);
    let mut det = T::one();
    for i in 0..N {
        det *= f[(i, i)];
    }
    // M = L⁻¹, unit lower triangular.
    let mut m = identity::<T, N>();
    for j in 0..N {
        for i in j + 1..N {
            let mut sum = f[(i, j)];
            for k in j + 1..i {
                sum += f[(i, k)] * m[(k, j)];
            }
            m[(i, j)] = -sum;
        }
    }
    // A⁻¹ = Mᵀ D⁻¹ M.
    let mut d_inv = Vector::<T, N>::from_element(T::zero());
    for i in 0..N {
        d_inv[i] = T::one() / f[(i, i)];
    }
    let inverse = symmetric(|i, j| {
        let mut sum = m[(j, i)] * d_inv[j];
        for k in j + 1..N {
            sum += m[(k, i)] * m[(k, j)] * d_inv[k];
        }
        sum
    });
    (inverse, det)
}

/// The first pivot of LDLᵀ that is not positive: none if and only if the symmetric matrix is positive definite.
pub fn indefinite_pivot<const N: usize>(a: &Mat<f64, N>) -> Option<f64> {
    let f = ldlt(a);
    (0..N).map(|i| f[(i, i)]).find(|d| d.is_nan() || *d <= 0.0)
}

//! Floor 1. Small symmetric matrices over any field: determinant and inverse.
//!
//! nalgebra's decompositions ask for an ordered field; exact fields and nested duals have none. A symmetric
//! positive definite matrix needs no pivoting, so LDLᵀ does for all scalars.

use crate::scalar::{Field, Real};
use nalgebra::{ArrayStorage, SMatrix, SVector};

/// An N×N array over T; a (0,2)-tensor's `[(i, j)]` component, or its inverse's.
pub type Mat<T, const N: usize> = SMatrix<T, N, N>;
/// N components over T; upper or lower as the context says.
pub type Vector<T, const N: usize> = SVector<T, N>;

/// The zero matrix.
#[inline]
pub fn zeros<T: Field, const N: usize>() -> Mat<T, N> {
    Mat::from_array_storage(ArrayStorage([[T::zero(); N]; N]))
}

/// The matrix with these entries.
///
/// As nalgebra's `from_fn`, but what is made of wide scalars stays where it is: moving it costs as much as computing it.
#[inline]
pub fn matrix<T: Field, const N: usize>(mut entry: impl FnMut(usize, usize) -> T) -> Mat<T, N> {
    let mut a = zeros();
    for j in 0..N {
        for i in 0..N {
            a[(i, j)] = entry(i, j);
        }
    }
    a
}

/// The vector with these components. See [`matrix`].
#[inline]
pub fn vector<T: Field, const N: usize>(mut component: impl FnMut(usize) -> T) -> Vector<T, N> {
    let mut x = Vector::from_array_storage(ArrayStorage([[T::zero(); N]]));
    for i in 0..N {
        x[i] = component(i);
    }
    x
}

/// The identity matrix.
#[inline]
pub fn identity<T: Field, const N: usize>() -> Mat<T, N> {
    matrix(|i, j| if i == j { T::one() } else { T::zero() })
}

/// A symmetric matrix from its entries with i ≤ j, which are asked for row by row.
#[inline]
pub fn symmetric<T: Field, const N: usize>(entry: impl FnMut(usize, usize) -> T) -> Mat<T, N> {
    let mut a = zeros();
    fill_symmetric(&mut a, entry);
    a
}

/// [`symmetric`] in place: arrays of matrices are filled so, for to move them costs as much as to compute them.
#[inline]
pub fn fill_symmetric<T: Field, const N: usize>(
    a: &mut Mat<T, N>,
    mut entry: impl FnMut(usize, usize) -> T,
) {
    // Loops with constant bounds can be unrolled.
    for i in 0..N {
        for j in 0..N {
            if i <= j {
                let value = entry(i, j);
                a[(i, j)] = value;
                a[(j, i)] = value;
            }
        }
    }
}

/// a(x, y) = a_ij xⁱ yʲ.
#[inline]
pub fn form<T: Field, const N: usize>(a: &Mat<T, N>, x: &Vector<T, N>, y: &Vector<T, N>) -> T {
    let mut sum = T::zero();
    for i in 0..N {
        for j in 0..N {
            sum.add_product(a[(i, j)] * x[i], y[j]);
        }
    }
    sum
}

/// (A x)_i = a_ij xʲ.
#[inline]
pub fn apply<T: Field, const N: usize>(a: &Mat<T, N>, x: &Vector<T, N>) -> Vector<T, N> {
    vector(|i| {
        let mut y = T::zero();
        for j in 0..N {
            y.add_product(a[(i, j)], x[j]);
        }
        y
    })
}

/// α(X) = α_i Xⁱ.
#[inline]
pub fn contract<T: Field, const N: usize>(alpha: &Vector<T, N>, x: &Vector<T, N>) -> T {
    let mut sum = T::zero();
    for i in 0..N {
        sum.add_product(alpha[i], x[i]);
    }
    sum
}

/// a_ij b_ij: the full contraction; with one index pair up and the other down it is a g-inner product.
#[inline]
pub fn double_contract<T: Field, const N: usize>(a: &Mat<T, N>, b: &Mat<T, N>) -> T {
    let mut sum = T::zero();
    for i in 0..N {
        for j in 0..N {
            sum.add_product(a[(i, j)], b[(i, j)]);
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
                ab[(i, j)].add_product(a[(i, k)], b[(k, j)]);
            }
        }
    }
    symmetric(|i, j| {
        let mut sum = T::zero();
        for k in 0..N {
            sum.add_product(b[(i, k)], ab[(k, j)]);
        }
        sum
    })
}

/// A = L D Lᵀ with L unit lower triangular.
#[derive(Clone, Copy, Debug)]
pub struct Ldlt<T: Field, const N: usize> {
    /// L below the diagonal, D on it.
    pub factors: Mat<T, N>,
    /// 1/D.
    pub reciprocals: [T; N],
}

/// The factors of A = L D Lᵀ.
///
/// Without pivoting: A is symmetric and its leading minors do not vanish (positive definite matrices).
#[inline]
pub fn ldlt<T: Field, const N: usize>(a: &Mat<T, N>) -> Ldlt<T, N> {
    let mut f = *a;
    let mut reciprocals = [T::zero(); N];
    for j in 0..N {
        for k in 0..N {
            if k < j {
                let scaled = f[(j, k)] * f[(k, k)];
                for i in 0..N {
                    if i >= j {
                        let l_ik = f[(i, k)];
                        f[(i, j)].sub_product(l_ik, scaled);
                    }
                }
            }
        }
        reciprocals[j] = T::one() / f[(j, j)];
        for i in 0..N {
            if i > j {
                f[(i, j)] *= reciprocals[j];
            }
        }
    }
    Ldlt {
        factors: f,
        reciprocals,
    }
}

/// A⁻¹ and det A of a symmetric matrix with non-vanishing leading minors.
#[inline]
pub fn inverse_and_det<T: Field, const N: usize>(a: &Mat<T, N>) -> (Mat<T, N>, T) {
    let Ldlt {
        factors: f,
        reciprocals,
    } = ldlt(a);
    let mut det = f[(0, 0)];
    for i in 1..N {
        det *= f[(i, i)];
    }
    // M = L⁻¹, unit lower triangular: what is below its diagonal.
    let mut m = zeros::<T, N>();
    for i in 0..N {
        for j in 0..i {
            let mut sum = f[(i, j)];
            for k in (j..i).skip(1) {
                sum.add_product(f[(i, k)], m[(k, j)]);
            }
            m[(i, j)] = -sum;
        }
    }
    // A⁻¹ = Mᵀ D⁻¹ M, the unit diagonal of M left out.
    let inverse = symmetric(|i, j| {
        let mut sum = reciprocals[j];
        if i < j {
            sum *= m[(j, i)];
        }
        for k in (j..N).skip(1) {
            sum.add_product(m[(k, i)] * m[(k, j)], reciprocals[k]);
        }
        sum
    });
    (inverse, det)
}

/// Are the symmetric matrices in all lanes positive definite, beyond doubt? No too where a pivot is all but 0 or ∞:
/// [`indefinite_pivot`] decides that.
pub fn surely_positive<T: Real<Sum = f64>, const N: usize>(a: &Mat<T, N>) -> bool {
    // NaN for what is negative, ∞ for 1/0, in one lane or more.
    let finite = |reciprocal: T| reciprocal.sqrt().reduce().is_finite();
    ldlt(a).reciprocals.into_iter().all(finite)
}

/// The first pivot of LDLᵀ that is not positive: none if and only if the symmetric matrix is positive definite.
pub fn indefinite_pivot<const N: usize>(a: &Mat<f64, N>) -> Option<f64> {
    let f = ldlt(a).factors;
    (0..N).map(|i| f[(i, i)]).find(|d| d.is_nan() || *d <= 0.0)
}

//! Small symmetric matrices as their lower triangles, row after row.

use super::number::Number;

/// Where entry (a, b), b ≤ a, is.
#[inline]
pub(super) fn lower(a: usize, b: usize) -> usize {
    a * (a + 1) / 2 + b
}

/// How many entries the lower triangle of n rows has.
pub(super) fn packed(n: usize) -> usize {
    lower(n, 0)
}

/// z = A r.
pub(super) fn multiply<T: Number>(a: &[T], r: &[T], z: &mut [T]) {
    let mut next = 0;
    for i in 0..r.len() {
        // Row i is the first to see z_i.
        let mut sum = T::ZERO;
        for j in 0..i {
            let a = a[next + j];
            sum += a * r[j];
            z[j] += a * r[i];
        }
        z[i] = sum + a[next + i] * r[i];
        next += i + 1;
    }
}

/// A⁻¹ = L⁻ᵀ L⁻¹ of n rows; not finite where A is not positive definite.
pub(super) fn invert<T: Number>(n: usize, a: &[f64], inverse: &mut [T]) {
    let (at, mut l) = (lower, a.to_vec());
    for j in 0..n {
        let square: f64 = (0..j).map(|k| l[at(j, k)] * l[at(j, k)]).sum();
        l[at(j, j)] = (l[at(j, j)] - square).sqrt();
        for i in j + 1..n {
            let sum: f64 = (0..j).map(|k| l[at(i, k)] * l[at(j, k)]).sum();
            l[at(i, j)] = (l[at(i, j)] - sum) / l[at(j, j)];
        }
    }
    // L becomes L⁻¹, column by column.
    for j in 0..n {
        l[at(j, j)] = 1.0 / l[at(j, j)];
        for i in j + 1..n {
            let sum: f64 = (j..i).map(|k| l[at(i, k)] * l[at(k, j)]).sum();
            l[at(i, j)] = -sum / l[at(i, i)];
        }
    }
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (i..n).map(|k| l[at(k, i)] * l[at(k, j)]).sum();
            inverse[at(i, j)] = T::of(sum);
        }
    }
}

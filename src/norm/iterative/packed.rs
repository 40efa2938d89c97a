//! Small symmetric matrices as their lower triangles, row after row.

use super::number::Number;
use super::width::by_width;

/// Where entry (a, b), b ≤ a, is.
#[inline]
pub(super) fn lower(a: usize, b: usize) -> usize {
    a * (a + 1) / 2 + b
}

/// How many entries the lower triangle of n rows has.
pub(super) fn packed(n: usize) -> usize {
    lower(n, 0)
}

/// z = A r, for one matrix after another, each of n rows. The compiler unrolls the loops over the few rows of the usual degrees'
/// blocks, and keeps their sums in registers: a norm on 20 149 tetrahedra, p = 3, takes 3 % less. ([`multiply`] inlined for these lengths
/// takes 4 to 7 % more than what is written out here.)
pub(super) fn multiply_all<T: Number>(n: usize, a: &[T], r: &[T], z: &mut [T]) {
    by_width!(n, W => multiply_each::<T, W>(a, r, z), else {
        let vectors = r.chunks_exact(n).zip(z.chunks_exact_mut(n));
        for (a, (r, z)) in a.chunks_exact(packed(n)).zip(vectors) {
            multiply(a, r, z);
        }
    });
}

fn multiply_each<T: Number, const N: usize>(a: &[T], r: &[T], z: &mut [T]) {
    let vectors = r.as_chunks::<N>().0.iter().zip(z.as_chunks_mut::<N>().0);
    for (a, (r, z)) in a.chunks_exact(packed(N)).zip(vectors) {
        let mut sums = [T::ZERO; N];
        for i in 0..N {
            let row = &a[lower(i, 0)..lower(i + 1, 0)];
            for j in 0..i {
                sums[i] = sums[i].plus_product(row[j], r[j]);
                sums[j] = sums[j].plus_product(row[j], r[i]);
            }
            sums[i] = sums[i].plus_product(row[i], r[i]);
        }
        *z = sums;
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::SplitMix64;

    /// A r entry by entry, for as many rows as blocks have and others, and for a matrix after another.
    #[test]
    fn products() {
        let mut random = SplitMix64::new(7);
        for n in 1..=9 {
            let mut list =
                |len: usize| -> Vec<f64> { (0..len).map(|_| random.symmetric()).collect() };
            let (a, r) = (list(3 * packed(n)), list(3 * n));
            let mut z = vec![f64::NAN; 3 * n];
            multiply_all(n, &a, &r, &mut z);
            for (which, z) in z.chunks(n).enumerate() {
                let entry = |i: usize, j: usize| a[which * packed(n) + lower(i.max(j), i.min(j))];
                for (i, z) in z.iter().enumerate() {
                    let expected: f64 = (0..n).map(|j| entry(i, j) * r[which * n + j]).sum();
                    assert!((z - expected).abs() < 1e-14, "{n} rows: {z}, {expected}");
                }
            }
        }
    }
}

//! Polynomials on a simplex by Bernstein coefficients that are intervals: what bounds a polynomial on all of it.
//!
//! Bernstein polynomials are not negative and add up to 1. So the values on the simplex lie between the least and the largest
//! coefficient; and where the simplex is cut into halves, the coefficients on either half are means of these.

use crate::linalg::{Mat, matrix};
use crate::scalar::{Field, Interval};
use crate::simplex::multi_indices;
use std::collections::HashMap;

/// The exponents of one degree, and where each is.
#[derive(Clone, Debug)]
pub(super) struct Exponents {
    pub degree: usize,
    pub all: Vec<Vec<usize>>,
    place: HashMap<Vec<usize>, usize>,
}

impl Exponents {
    pub fn new(vertices: usize, degree: usize) -> Self {
        let all = multi_indices(vertices, degree);
        let place = all
            .iter()
            .cloned()
            .enumerate()
            .map(|(k, a)| (a, k))
            .collect();
        Self { degree, all, place }
    }

    /// Where α is.
    pub fn place(&self, alpha: &[usize]) -> usize {
        self.place[alpha]
    }

    /// Where α with one more at a vertex and one less at another is.
    fn moved(&self, alpha: &[usize], up: usize, down: Option<usize>) -> usize {
        let mut other = alpha.to_vec();
        other[up] += 1;
        if let Some(down) = down {
            other[down] -= 1;
        }
        self.place[&other]
    }

    /// Σ_α c_α B_α on the half in which the vertex `gone` is replaced by the middle of the edge from `kept`: along each row of
    /// exponents with one sum of the two, de Casteljau's means.
    pub fn half(&self, coefficients: &mut [Interval], kept: usize, gone: usize) {
        for (start, alpha) in self.all.iter().enumerate() {
            // A row begins where nothing is at the vertex that goes.
            if alpha[gone] > 0 {
                continue;
            }
            let mut row = vec![start];
            let mut at = alpha.clone();
            while at[kept] > 0 {
                row.push(self.moved(&at, gone, Some(kept)));
                at[gone] += 1;
                at[kept] -= 1;
            }
            for step in 1..row.len() {
                for k in (step..row.len()).rev() {
                    let sum = coefficients[row[k]] + coefficients[row[k - 1]];
                    coefficients[row[k]] = sum * Interval::half();
                }
            }
        }
    }
}

/// The derivatives of Σ_α c_α B_α in the reference coordinates, of degree one less: `[m][β]`. `of` are the exponents of c, `lower`
/// those of the derivatives.
pub(super) fn derivatives<const N: usize>(
    of: &Exponents,
    lower: &Exponents,
    coefficients: &[Interval],
) -> [Vec<Interval>; N] {
    std::array::from_fn(|m| {
        if of.degree == 0 {
            return vec![Interval::zero(); lower.all.len()];
        }
        // ∂/∂ξ_m is ∂/∂λ_{m+1} − ∂/∂λ_0.
        let degree = Interval::from_int(of.degree as i64);
        let difference = |beta: &Vec<usize>| {
            let at = |v: usize| coefficients[of.moved(beta, v, None)];
            degree * (at(m + 1) - at(0))
        };
        lower.all.iter().map(difference).collect()
    })
}

/// What is between all of these.
pub(super) fn range(coefficients: &[Interval]) -> Interval {
    let (first, rest) = coefficients.split_first().expect("there is a coefficient");
    rest.iter().fold(*first, |all, x| all.hull(*x))
}

/// Aᵀ T A of tensors in each coefficient: `components` are T_11…T_NN, then T_ij with i < j, each by coefficient.
pub(super) fn turned<const N: usize>(
    components: &[Vec<Interval>],
    a: &Mat<Interval, N>,
) -> Vec<Vec<Interval>> {
    let mut all = vec![Vec::with_capacity(components[0].len()); components.len()];
    for k in 0..components[0].len() {
        let t = tensor::<N>(|c| components[c][k]);
        let right: Mat<Interval, N> = matrix(|i, n| dot(|j| t[(i, j)] * a[(j, n)], N));
        let turned: Mat<Interval, N> = matrix(|m, n| dot(|i| a[(i, m)] * right[(i, n)], N));
        for (c, (i, j)) in places::<N>().into_iter().enumerate() {
            all[c].push(turned[(i, j)]);
        }
    }
    all
}

/// Σ_{k<n} term(k).
pub(super) fn dot(term: impl Fn(usize) -> Interval, n: usize) -> Interval {
    (1..n).fold(term(0), |sum, k| sum + term(k))
}

/// Where each component is: the diagonal, then i < j row by row.
pub(super) fn places<const N: usize>() -> Vec<(usize, usize)> {
    let above = (0..N).flat_map(|i| (i + 1..N).map(move |j| (i, j)));
    (0..N).map(|i| (i, i)).chain(above).collect()
}

/// The symmetric matrix with these components.
pub(super) fn tensor<const N: usize>(component: impl Fn(usize) -> Interval) -> Mat<Interval, N> {
    let mut t = Mat::<Interval, N>::from_element(Interval::zero());
    for (c, (i, j)) in places::<N>().into_iter().enumerate() {
        t[(i, j)] = component(c);
        t[(j, i)] = t[(i, j)];
    }
    t
}

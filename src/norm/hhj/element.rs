//! The Hellan–Herrmann–Johnson element on the reference simplex: everything that does not see the cell's shape.
//!
//! A moment tensor has contravariant components S^{ij} in reference coordinates, S = Σ_a s_a(ξ) E_a with E_a over
//! the pairs i ≤ j (e_i ⊗ e_i, or e_i ⊗ e_j + e_j ⊗ e_i) and s_a in an L²-orthonormal basis φ of P_{p−1}, whose first
//! functions are one of P_{p−2}. With ν_f = −dλ_f the pairing with (u, ŵ), ŵ_f = h_f (û_f − ∂u/∂n) (`cell.rs`), is a constant
//! matrix:
//!
//! B̂(S; u, ŵ) = ∫ S^{ij} ∂_i∂_j u dξ + Σ_f ∫_f S(ν_f, ν_f) ŵ_f dμ,
//!
//! dμ the measure of the face's own reference simplex. ŵ is without the bubbles' part, which does not depend on the cell's shape:
//! it is in their columns. Most of the matrix is zero: u meets the moments of P_{p−2} alone, and ŵ_f, but for one face, one pair.

use super::layout::Layout;
use crate::quadrature::Rule;
use crate::simplex::{Bernstein, Points, multi_indices, subsets};
use crate::spaces::Lagrange;
use nalgebra::{DMatrix, DVector};

/// The reference element.
#[derive(Clone, Debug)]
pub(in crate::norm) struct Element<const N: usize> {
    /// p, the degree of u.
    pub degree: usize,
    /// The numbering of the columns of `pairing`.
    pub layout: Layout,
    /// The pairs (i, j), i ≤ j, in the order of the components s_a.
    pub pairs: Vec<(usize, usize)>,
    /// The basis φ.
    pub moments: Moments,
    /// B̂: row a·dim P_{p−1} + k for s_a = φ_k, columns as in `layout`.
    pub pairing: DMatrix<f64>,
    /// Column (a ≤ b) holds the upper triangle of B̂_aᵀB̂_b + B̂_bᵀB̂_a (once if a = b), column by column.
    gram: DMatrix<f64>,
}

impl<const N: usize> Element<N> {
    pub fn new(space: &Lagrange<N>) -> Self {
        let layout = Layout::new(space);
        let pairs: Vec<(usize, usize)> = (0..N).flat_map(|i| (i..N).map(move |j| (i, j))).collect();
        let moments = Moments::new(N, space.degree() - 1);
        let mut pairing = DMatrix::zeros(pairs.len() * moments.len(), layout.len);
        pair_with_hessians::<N>(space.degree(), &pairs, &moments, &layout, &mut pairing);
        pair_with_slopes::<N>(space.degree(), &pairs, &moments, &layout, &mut pairing);
        let gram = gram(&pairing, pairs.len());
        Self {
            degree: space.degree(),
            layout,
            pairs,
            moments,
            pairing,
            gram,
        }
    }

    /// The rank of a cell's energy, at most, when the bubbles are eliminated: each takes a moment with it, and affine functions have
    /// no energy.
    pub fn rank(&self) -> usize {
        let Layout { bubbles, len, .. } = self.layout;
        (self.pairing.nrows() - bubbles).min(len - bubbles - (N + 1))
    }

    /// Σ_{a,b} weight(a, b) B̂_aᵀ B̂_b for symmetric weights; the upper triangle is filled in, the lower mirrored.
    pub fn condensed(&self, weight: impl Fn(usize, usize) -> f64) -> DMatrix<f64> {
        let count = self.pairs.len();
        let weights: Vec<f64> = (0..count)
            .flat_map(|a| (a..count).map(move |b| (a, b)))
            .map(|(a, b)| weight(a, b))
            .collect();
        let packed = &self.gram * DVector::from_vec(weights);
        let mut full = DMatrix::zeros(self.layout.len, self.layout.len);
        let mut next = 0;
        for j in 0..self.layout.len {
            for i in 0..=j {
                full[(i, j)] = packed[next];
                full[(j, i)] = packed[next];
                next += 1;
            }
        }
        full
    }
}

/// The L²-orthonormal basis of P_q on the reference simplex that Gram–Schmidt makes of Bernstein's of P_{q−1} and, after these, those
/// of P_q that do not charge vertex 0.
#[derive(Clone, Debug)]
pub(in crate::norm) struct Moments {
    bernstein: Bernstein,
    /// dim P_{q−1}: so many come first.
    pub lower: usize,
    /// φ_k = Σ_β `rows[(k, β)]` B_β.
    rows: DMatrix<f64>,
}

impl Moments {
    fn new(n: usize, degree: usize) -> Self {
        let bernstein = Bernstein::new(n + 1, degree);
        let rule = Rule::new(n, 2 * degree);
        let table = bernstein.tabulate::<f64>(rule.points());
        let size = bernstein.len();
        let mass = DMatrix::from_fn(size, size, |i, j| {
            (0..rule.len())
                .map(|q| rule.weights()[q] * table[q][i] * table[q][j])
                .sum::<f64>()
        });
        let (lower, functions) = by_degree(n, degree, &bernstein);
        let mass = &functions * mass * functions.transpose();
        Self {
            rows: inverse_cholesky(mass) * functions,
            lower,
            bernstein,
        }
    }

    /// dim P_q.
    pub fn len(&self) -> usize {
        self.bernstein.len()
    }

    /// φ_k at the points: `[point][k]`.
    pub fn tabulate(&self, points: &Points) -> Vec<Vec<f64>> {
        let table = self.bernstein.tabulate::<f64>(points).into_iter();
        let row = |b: Vec<f64>| (&self.rows * DVector::from_vec(b)).as_slice().to_vec();
        table.map(row).collect()
    }
}

/// dim P_{q−1}, and a basis of P_q that begins with one of P_{q−1}: row by row in Bernstein's. A polynomial of degree q − 1 is one of
/// degree q by its product with Σ λ_v = 1, which a combination of those without λ_0 is not: it would have no factor Σ λ_v.
fn by_degree(n: usize, q: usize, bernstein: &Bernstein) -> (usize, DMatrix<f64>) {
    let exponents = bernstein.exponents();
    // B_γ = Σ_v (γ_v + 1)/q B_{γ+e_v}.
    let lower = match q {
        0 => Vec::new(),
        q => multi_indices(n + 1, q - 1),
    };
    let upper = exponents
        .iter()
        .enumerate()
        .filter(|(_, alpha)| alpha[0] == 0);
    let mut functions = DMatrix::zeros(exponents.len(), exponents.len());
    for (row, gamma) in lower.iter().enumerate() {
        for v in 0..=n {
            let mut alpha = gamma.clone();
            alpha[v] += 1;
            let column = exponents.iter().position(|a| *a == alpha);
            let column = column.expect("γ + e_v is of degree q");
            functions[(row, column)] = alpha[v] as f64 / q as f64;
        }
    }
    for (i, (column, _)) in upper.enumerate() {
        functions[(lower.len() + i, column)] = 1.0;
    }
    (lower.len(), functions)
}

/// L⁻¹ where A = L Lᵀ; A is a mass matrix, positive definite.
fn inverse_cholesky(a: DMatrix<f64>) -> DMatrix<f64> {
    let n = a.nrows();
    let mut l = a;
    for j in 0..n {
        let pivot = (l[(j, j)] - (0..j).map(|k| l[(j, k)] * l[(j, k)]).sum::<f64>()).sqrt();
        for i in j..n {
            let sum: f64 = (0..j).map(|k| l[(i, k)] * l[(j, k)]).sum();
            l[(i, j)] = (l[(i, j)] - sum) / pivot;
        }
    }
    let mut inverse = DMatrix::zeros(n, n);
    for j in 0..n {
        inverse[(j, j)] = 1.0 / l[(j, j)];
        for i in j + 1..n {
            let sum: f64 = (j..i).map(|k| l[(i, k)] * inverse[(k, j)]).sum();
            inverse[(i, j)] = -sum / l[(i, i)];
        }
    }
    inverse
}

/// ∫ S^{ij} ∂_i∂_j u dξ, which is zero for moments that are orthogonal to P_{p−2}.
fn pair_with_hessians<const N: usize>(
    p: usize,
    pairs: &[(usize, usize)],
    moments: &Moments,
    layout: &Layout,
    pairing: &mut DMatrix<f64>,
) {
    let rule = Rule::new(N, 2 * p);
    let u = Bernstein::new(N + 1, p).tabulate_jets::<f64, N>(rule.points());
    let phi = moments.tabulate(rule.points());
    for q in 0..rule.len() {
        for (a, &(i, j)) in pairs.iter().enumerate() {
            // E_a : ∂∂u, where i < j counts twice.
            let factor = rule.weights()[q] * if i == j { 1.0 } else { 2.0 };
            for (alpha, &column) in layout.bernstein.iter().enumerate() {
                for k in 0..moments.lower {
                    pairing[(a * moments.len() + k, column)] +=
                        factor * phi[q][k] * u[q][alpha].dd[i][j];
                }
            }
        }
    }
}

/// Σ_f ∫_f S(ν_f, ν_f) ŵ_f dμ, and the same for the bubbles' part of ŵ: −∂u/∂N_f has the coefficients p u_{β+e_f} where u = 0 on the
/// face, for every N_f with ν_f(N_f) = 1.
fn pair_with_slopes<const N: usize>(
    p: usize,
    pairs: &[(usize, usize)],
    moments: &Moments,
    layout: &Layout,
    pairing: &mut DMatrix<f64>,
) {
    let rule = Rule::new(N - 1, 2 * p);
    let slopes = Bernstein::new(N, p - 1).tabulate::<f64>(rule.points());
    for (place, face) in subsets(N + 1, N).iter().enumerate() {
        let phi = moments.tabulate(&rule.points().embed(face, N + 1));
        let nu = conormal::<N>(N - place);
        for q in 0..rule.len() {
            for (a, &(i, j)) in pairs.iter().enumerate() {
                let factor = rule.weights()[q] * nu[i] * nu[j] * if i == j { 1.0 } else { 2.0 };
                for k in 0..moments.len() {
                    let row = a * moments.len() + k;
                    for (beta, moment) in layout.faces[place].iter().enumerate() {
                        let entry = factor * phi[q][k] * slopes[q][beta];
                        pairing[(row, moment.slope)] += entry;
                        if moment.opposite < layout.bubbles {
                            pairing[(row, moment.opposite)] += p as f64 * entry;
                        }
                    }
                }
            }
        }
    }
}

/// ν = −dλ_f: the outward covector of the face opposite to vertex f.
pub(in crate::norm) fn conormal<const N: usize>(f: usize) -> [f64; N] {
    std::array::from_fn(|i| match f {
        0 => 1.0,
        _ if i == f - 1 => -1.0,
        _ => 0.0,
    })
}

/// The upper triangles of the products of B̂'s blocks of rows.
fn gram(pairing: &DMatrix<f64>, count: usize) -> DMatrix<f64> {
    let (n, rows) = (pairing.ncols(), pairing.nrows() / count);
    let block = |a: usize| pairing.rows(a * rows, rows);
    let mut columns = Vec::with_capacity(count * (count + 1) / 2 * n * (n + 1) / 2);
    for a in 0..count {
        for b in a..count {
            let product = block(a).transpose() * block(b);
            for j in 0..n {
                for i in 0..=j {
                    let mirrored = if a == b { 0.0 } else { product[(j, i)] };
                    columns.push(product[(i, j)] + mirrored);
                }
            }
        }
    }
    DMatrix::from_vec(n * (n + 1) / 2, count * (count + 1) / 2, columns)
}

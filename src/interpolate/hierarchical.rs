//! Averaging in the hierarchical basis that the printed tables used.
//!
//! Vertices ascend by global index. Edge ab: P_l(λ_a−λ_b, λ_a+λ_b), l = 0…r, times ∇λ_a⊙∇λ_b, with scaled Legendre
//! polynomials. Face a<b<c: λ_aⁱλ_bʲ, i+j ≤ r−1, times λ_c ∇λ_a⊙∇λ_b, λ_a ∇λ_b⊙∇λ_c and λ_b ∇λ_a⊙∇λ_c. On simplices
//! of dimension ≥ 3, Bernstein's functions (on a cell they are its own, and any basis gives the same). Since
//! −∇λ_a⊙∇λ_b has edge component 1 on ab and 0 on all other edges, each edge has a basis of its own again.

use super::projection::projection_matrix;
use crate::Error;
use crate::quadrature::Rule;
use crate::simplex::{Bernstein, multi_indices, subsets};
use crate::spaces::ReggeSpace;
use nalgebra::{DMatrix, DVector};

/// The hierarchical functions in q_ab for one edge ab of the cell.
struct EdgeBasis {
    /// Columns: the functions, by their Bernstein coefficients.
    functions: DMatrix<f64>,
    inverse: DMatrix<f64>,
    /// The slot among the edge's α whose global index stands for the function (their numbers agree simplex by
    /// simplex).
    stands_for: Vec<usize>,
}

/// Scaled Legendre polynomials: l P_l(s, t) = (2l−1) s P_{l−1} − (l−1) t² P_{l−2}.
fn scaled_legendre(l: usize, s: f64, t: f64) -> f64 {
    let (mut before, mut now) = (0.0, 1.0);
    for m in 1..=l {
        let m = m as f64;
        let next = ((2.0 * m - 1.0) * s * now - (m - 1.0) * t * t * before) / m;
        (before, now) = (now, next);
    }
    now
}

/// The functions of the simplex with these vertices (it contains the edge), as values at λ.
fn functions_of(on: &[usize], edge: &[usize], degree: usize, lambda: &[f64]) -> Vec<f64> {
    match on.len() {
        2 => edge_functions(lambda[on[0]], lambda[on[1]], degree),
        3 => face_functions(on, edge, degree, lambda),
        _ => bubbles(on, edge, degree, lambda),
    }
}

/// P_l(λ_a−λ_b, λ_a+λ_b), l = 0…r.
fn edge_functions(a: f64, b: f64, degree: usize) -> Vec<f64> {
    (0..=degree)
        .map(|l| scaled_legendre(l, a - b, a + b))
        .collect()
}

/// λ_aⁱλ_bʲ, i+j ≤ r−1, times the third coordinate, r ≥ 1: there are none on faces for r = 0.
fn face_functions(on: &[usize], edge: &[usize], degree: usize, lambda: &[f64]) -> Vec<f64> {
    let third = on.iter().filter(|v| !edge.contains(v));
    let third: f64 = third.map(|&v| lambda[v]).product();
    let monomial =
        |e: &Vec<usize>| third * lambda[on[0]].powi(e[0] as i32) * lambda[on[1]].powi(e[1] as i32);
    multi_indices(3, degree - 1).iter().map(monomial).collect()
}

/// The Bernstein functions that charge all of the simplex with the edge, and nothing else.
fn bubbles(on: &[usize], edge: &[usize], degree: usize, lambda: &[f64]) -> Vec<f64> {
    let basis = Bernstein::new(lambda.len(), degree);
    let charges = |a: &usize| {
        let alpha = &basis.exponents()[*a];
        (0..lambda.len()).all(|v| match (on.contains(&v), edge.contains(&v)) {
            (true, true) => true,
            (true, false) => alpha[v] > 0,
            (false, _) => alpha[v] == 0,
        })
    };
    (0..basis.len())
        .filter(charges)
        .map(|a| basis.value(a, lambda))
        .collect()
}

impl EdgeBasis {
    fn new(n: usize, edge: &[usize], degree: usize) -> Result<Self, Error> {
        let basis = Bernstein::new(n + 1, degree);
        let rule = Rule::new(n, 2 * degree);
        let to_bernstein = projection_matrix(&basis, &rule)?;
        let (mut values, mut stands_for) = (Vec::new(), Vec::new());
        for on in simplices_around(n, edge, degree) {
            let at = |q: usize| functions_of(&on, edge, degree, rule.points().lambda(q));
            let table: Vec<Vec<f64>> = (0..rule.len()).map(at).collect();
            for f in 0..table[0].len() {
                values.push(DVector::from_fn(rule.len(), |q, _| table[q][f]));
            }
            let own = |a: &usize| {
                (0..=n).all(|v| {
                    let charged = basis.exponents()[*a][v] > 0 || edge.contains(&v);
                    charged == on.contains(&v)
                })
            };
            stands_for.extend((0..basis.len()).filter(own));
        }
        let functions = to_bernstein * DMatrix::from_columns(&values);
        let inverse = functions
            .clone()
            .try_inverse()
            .ok_or_else(|| Error::Solver("the hierarchical basis is singular".into()))?;
        Ok(Self {
            functions,
            inverse,
            stands_for,
        })
    }
}

/// The simplices of an n-simplex that contain the edge and have functions of degree r: those of dimension ≤ r+1.
fn simplices_around(n: usize, edge: &[usize], degree: usize) -> Vec<Vec<usize>> {
    (1..=n.min(degree + 1))
        .flat_map(|k| subsets(n + 1, k + 1))
        .filter(|on| edge.iter().all(|v| on.contains(v)))
        .collect()
}

/// The Regge coefficients of the function whose hierarchical coefficients are the averages over cells of those of
/// the given local polynomials, `[cell][edge][α]`.
pub(super) fn coefficients<const N: usize>(
    space: &ReggeSpace<N>,
    cells: &[Vec<f64>],
) -> Result<Vec<f64>, Error> {
    let bases = subsets(N + 1, 2)
        .iter()
        .map(|e| EdgeBasis::new(N, e, space.degree()))
        .collect::<Result<Vec<EdgeBasis>, Error>>()?;
    let means = means(space, &bases, cells);
    let mut result = vec![0.0; space.len()];
    for cell in 0..cells.len() {
        for (e, basis) in bases.iter().enumerate() {
            let averaged = basis.stands_for.iter();
            let averaged = averaged.map(|&a| means[space.cell_dof(cell, e, a)]);
            let q = &basis.functions * DVector::from_iterator(basis.stands_for.len(), averaged);
            for (alpha, &c) in q.iter().enumerate() {
                // Cells that share the simplex agree on this up to rounding: its functions there are the same.
                result[space.cell_dof(cell, e, alpha)] = c;
            }
        }
    }
    Ok(result)
}

/// The hierarchical coefficients, averaged over the cells that share them.
fn means<const N: usize>(
    space: &ReggeSpace<N>,
    bases: &[EdgeBasis],
    cells: &[Vec<f64>],
) -> Vec<f64> {
    let size = bases[0].stands_for.len();
    let (mut sums, mut shares) = (vec![0.0; space.len()], vec![0.0; space.len()]);
    for (cell, local) in cells.iter().enumerate() {
        for (e, basis) in bases.iter().enumerate() {
            let q = DVector::from_column_slice(&local[e * size..(e + 1) * size]);
            let coefficients = &basis.inverse * q;
            for (f, &alpha) in basis.stands_for.iter().enumerate() {
                let dof = space.cell_dof(cell, e, alpha);
                sums[dof] += coefficients[f];
                shares[dof] += 1.0;
            }
        }
    }
    for (sum, share) in sums.iter_mut().zip(shares) {
        *sum /= share;
    }
    sums
}

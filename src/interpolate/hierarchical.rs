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
        2 => (0..=degree)
            .map(|l| {
                scaled_legendre(
                    l,
                    lambda[on[0]] - lambda[on[1]],
                    lambda[on[0]] + lambda[on[1]],
                )
            })
            .collect(),
        3 => {
            let third: f64 = on
                .iter()
                .filter(|v| !edge.contains(v))
                .map(|&v| lambda[v])
                .product();
            let powers = multi_indices(3, degree.saturating_sub(1));
            let monomial = |e: &Vec<usize>| {
                third * lambda[on[0]].powi(e[0] as i32) * lambda[on[1]].powi(e[1] as i32)
            };
            powers.iter().map(monomial).collect()
        }
        _ => {
            let basis = Bernstein::new(lambda.len(), degree);
            let charges = |a: &usize| {
                let alpha = &basis.exponents()[*a];
                (0..lambda.len()).all(|v| {
                    let needed = on.contains(&v) && !edge.contains(&v);
                    if on.contains(&v) {
                        !needed || alpha[v] > 0
                    } else {
                        alpha[v] == 0
                    }
                })
            };
            (0..basis.len())
                .filter(charges)
                .map(|a| basis.value(a, lambda))
                .collect()
        }
    }
}

impl EdgeBasis {
    fn new(n: usize, edge: &[usize], degree: usize) -> Result<Self, Error> {
        let basis = Bernstein::new(n + 1, degree);
        let rule = Rule::new(n, 2 * degree);
        let to_bernstein = projection_matrix(&basis, &rule)?;
        let (mut values, mut stands_for) = (Vec::new(), Vec::new());
        for k in 1..=n.min(degree + 1) {
            for on in subsets(n + 1, k + 1)
                .iter()
                .filter(|on| edge.iter().all(|v| on.contains(v)))
            {
                let at = |q: usize| functions_of(on, edge, degree, rule.points().lambda(q));
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

/// The Regge coefficients of the function whose hierarchical coefficients are the averages over cells of those of
/// the given local polynomials, `[cell][edge][α]`.
pub(super) fn average<const N: usize>(
    space: &ReggeSpace<N>,
    cells: Vec<Vec<f64>>,
) -> Result<Vec<f64>, Error> {
    let edges = subsets(N + 1, 2);
    let bases = edges
        .iter()
        .map(|e| EdgeBasis::new(N, e, space.degree()))
        .collect::<Result<Vec<EdgeBasis>, Error>>()?;
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
    let mut result = vec![0.0; space.len()];
    for cell in 0..cells.len() {
        for (e, basis) in bases.iter().enumerate() {
            let averaged = DVector::from_iterator(
                size,
                basis.stands_for.iter().map(|&a| {
                    let dof = space.cell_dof(cell, e, a);
                    sums[dof] / shares[dof]
                }),
            );
            let q = &basis.functions * averaged;
            for alpha in 0..size {
                // Cells that share the simplex agree on this up to rounding: its functions there are the same.
                result[space.cell_dof(cell, e, alpha)] = q[alpha];
            }
        }
    }
    Ok(result)
}

//! g = F*δ as a Regge function, exactly.

use super::Immersion;
use crate::simplex::{binomial, multi_indices, raised, subsets};
use crate::spaces::{ReggeFunction, ReggeSpace};

/// B_β B_γ = w B_{β+γ}.
struct Product {
    beta: usize,
    gamma: usize,
    alpha: usize,
    /// Π_i C(β_i + γ_i, β_i) / C(2(k−1), k−1), times 2 where β ≠ γ stand for γ, β too, times k².
    weight: f64,
}

impl<const N: usize> Immersion<N> {
    /// The metric g = F*δ: a Regge function of degree 2(k − 1).
    ///
    /// Its edge components are q_ab = |∂F/∂t_ab|², t_ab from vertex a to vertex b, and
    /// ∂F/∂t_ab = k Σ_β (f_{β+e_b} − f_{β+e_a}) B_β with |β| = k − 1, so that its coefficients come from those of F by the
    /// products of Bernstein polynomials. For k = 1 they are the squared edge lengths.
    pub fn metric(&self) -> ReggeFunction<f64, N> {
        let (degree, mesh) = (self.degree(), self.mesh());
        let space = ReggeSpace::new(mesh, 2 * (degree - 1));
        let (raised, products, edges) = (raised(N, degree), products(N, degree), subsets(N + 1, 2));
        let mut coefficients = vec![0.0; space.len()];
        let (mut local, mut along) = (Vec::new(), vec![0.0; raised.len() * self.width]);
        let mut q = vec![0.0; multi_indices(N + 1, 2 * (degree - 1)).len()];
        for cell in 0..mesh.cell_count() {
            self.fill_local(cell, &mut local);
            for (e, edge) in edges.iter().enumerate() {
                difference(&local, &raised, [edge[0], edge[1]], self.width, &mut along);
                q.fill(0.0);
                let d = |i: usize| &along[i * self.width..(i + 1) * self.width];
                for product in &products {
                    let pairs = d(product.beta).iter().zip(d(product.gamma));
                    let dot: f64 = pairs.map(|(a, b)| a * b).sum();
                    q[product.alpha] += product.weight * dot;
                }
                // Cells around a simplex have the same control points on it, and say the same.
                for (alpha, q) in q.iter().enumerate() {
                    coefficients[space.cell_dof(cell, e, alpha)] = *q;
                }
            }
        }
        let function = space.function(coefficients);
        function.expect("as many coefficients as the space has")
    }
}

/// f_{β+e_b} − f_{β+e_a} for every β.
fn difference(
    local: &[f64],
    raised: &[Vec<usize>],
    [a, b]: [usize; 2],
    width: usize,
    along: &mut [f64],
) {
    for (up, out) in raised.iter().zip(along.chunks_exact_mut(width)) {
        for (c, out) in out.iter_mut().enumerate() {
            *out = local[up[b] * width + c] - local[up[a] * width + c];
        }
    }
}

fn products(n: usize, degree: usize) -> Vec<Product> {
    let lower = multi_indices(n + 1, degree - 1);
    let all = multi_indices(n + 1, 2 * (degree - 1));
    let scale = (degree * degree) as f64 / binomial(2 * (degree - 1), degree - 1) as f64;
    let mut products = Vec::new();
    for (beta, b) in lower.iter().enumerate() {
        for (gamma, c) in lower.iter().enumerate().skip(beta) {
            let sum: Vec<usize> = b.iter().zip(c).map(|(b, c)| b + c).collect();
            let ways: usize = b.iter().zip(&sum).map(|(&b, &s)| binomial(s, b)).product();
            let twice = if beta == gamma { 1.0 } else { 2.0 };
            let alpha = all.iter().position(|a| *a == sum);
            products.push(Product {
                beta,
                gamma,
                alpha: alpha
                    .expect("two exponents of degree k − 1 add up to one of degree 2(k − 1)"),
                weight: twice * scale * ways as f64,
            });
        }
    }
    products
}

//! A geodesic between two points of ℝ^N as a polynomial in its parameter.

use crate::field::Ambient;
use crate::jet::{Jet2, lower};
use crate::linalg::{Mat, Vector, apply, contract, form, indefinite_pivot, matrix, vector};
use crate::quadrature::gauss_legendre;
use nalgebra::{DMatrix, DVector};

/// x(s) = a + (b−a) s + Σ_k c_k φ_k(s), φ_k = ∫₀ˢ P_k(2t−1) dt, k = 1…m, which vanish at both ends.
pub(super) struct Curve<const N: usize> {
    ends: [Vector<f64, N>; 2],
    /// c_k^i at k N + i.
    coefficients: DVector<f64>,
    /// s and weights of Gauss' rule.
    nodes: Vec<f64>,
    weights: Vec<f64>,
    /// φ_k and φ_k′ at the nodes.
    phi: Vec<Vec<f64>>,
    dphi: Vec<Vec<f64>>,
}

impl<const N: usize> Curve<N> {
    /// The straight line.
    pub(super) fn new(a: Vector<f64, N>, b: Vector<f64, N>, degree: usize) -> Self {
        let (nodes, weights) = gauss_legendre(2 * degree + 4);
        let legendre = |s: f64| {
            let x = 2.0 * s - 1.0;
            let mut p = vec![1.0, x];
            for k in 1..=degree {
                let m = k as f64;
                p.push(((2.0 * m + 1.0) * x * p[k] - m * p[k - 1]) / (m + 1.0));
            }
            p
        };
        let p: Vec<Vec<f64>> = nodes.iter().map(|s| legendre(*s)).collect();
        // ∫ P_k = (P_{k+1} − P_{k−1})/(2k+1), and half of it per unit of s.
        let integral = |p: &Vec<f64>, k: usize| (p[k + 1] - p[k - 1]) / (2.0 * (2 * k + 1) as f64);
        Self {
            ends: [a, b],
            coefficients: DVector::zeros(degree * N),
            phi: p
                .iter()
                .map(|p| (1..=degree).map(|k| integral(p, k)).collect())
                .collect(),
            dphi: p.iter().map(|p| p[1..=degree].to_vec()).collect(),
            nodes,
            weights,
        }
    }

    /// x and dx/ds at a node.
    fn at(&self, q: usize) -> (Vector<f64, N>, Vector<f64, N>) {
        let chord = self.ends[1] - self.ends[0];
        let (mut x, mut dx) = (self.ends[0] + chord * self.nodes[q], chord);
        for k in 0..self.phi[q].len() {
            for i in 0..N {
                x[i] += self.coefficients[k * N + i] * self.phi[q][k];
                dx[i] += self.coefficients[k * N + i] * self.dphi[q][k];
            }
        }
        (x, dx)
    }

    /// Continues the straight line from δ to g; the length of what is reached.
    pub(super) fn settle(mut self, g: &dyn Ambient<N>) -> Result<f64, String> {
        let (mut tau, mut step) = (0.0, 0.25);
        while tau < 1.0 {
            let next: f64 = f64::min(tau + step, 1.0);
            let start = self.coefficients.clone();
            match self.newton(g, next) {
                Ok(()) => tau = next,
                Err(reason) => {
                    self.coefficients = start;
                    step *= 0.5;
                    if step < 1e-3 {
                        return Err(reason);
                    }
                }
            }
        }
        self.length(g)
    }

    /// The length of a curve whose speed is constant, as that of a geodesic is: the root of ∫ g(ẋ, ẋ) ds, to second
    /// order in the error of the curve.
    fn length(&self, g: &dyn Ambient<N>) -> Result<f64, String> {
        let mut energy = 0.0;
        for q in 0..self.nodes.len() {
            let (x, dx) = self.at(q);
            energy += self.weights[q] * form(&lower(&lower(&jets(g, &x, 1.0)?)), &dx, &dx);
        }
        Ok(energy.sqrt())
    }

    /// Makes the energy of (1−τ)δ + τg stationary.
    fn newton(&mut self, g: &dyn Ambient<N>, tau: f64) -> Result<(), String> {
        let scale = (self.ends[1] - self.ends[0]).norm();
        let mut before = f64::INFINITY;
        for _ in 0..25 {
            let (gradient, hessian) = self.derivatives(g, tau)?;
            let step = hessian
                .lu()
                .solve(&gradient)
                .ok_or("its geodesic is not isolated")?;
            self.coefficients -= &step;
            let size = step.norm() / scale;
            // Quadratic convergence: after a step of 1e-9 the next is at rounding level.
            if size < 1e-9 {
                return Ok(());
            }
            if size > 4.0 * before || !size.is_finite() {
                break;
            }
            before = size;
        }
        Err("its geodesic was not found by Newton's method".into())
    }

    /// The gradient and the Hessian of E = ½ ∫ g(ẋ, ẋ) ds in the coefficients.
    fn derivatives(
        &self,
        g: &dyn Ambient<N>,
        tau: f64,
    ) -> Result<(DVector<f64>, DMatrix<f64>), String> {
        let size = self.coefficients.len();
        let (mut gradient, mut hessian) = (DVector::zeros(size), DMatrix::zeros(size, size));
        for q in 0..self.nodes.len() {
            let (x, dx) = self.at(q);
            let l = Lagrangian::new(&jets(g, &x, tau)?, &dx);
            let (w, phi, dphi) = (self.weights[q], &self.phi[q], &self.dphi[q]);
            for i in 0..size {
                let (k, m) = (i / N, i % N);
                gradient[i] += w * (l.x[m] * phi[k] + l.v[m] * dphi[k]);
                for j in 0..size {
                    let (h, n) = (j / N, j % N);
                    hessian[(i, j)] += w
                        * (l.xx[(m, n)] * phi[k] * phi[h]
                            + l.xv[(m, n)] * phi[k] * dphi[h]
                            + l.xv[(n, m)] * dphi[k] * phi[h]
                            + l.vv[(m, n)] * dphi[k] * dphi[h]);
                }
            }
        }
        Ok((gradient, hessian))
    }
}

/// The first and second derivatives of L = ½ g_x(v, v) in x and v.
struct Lagrangian<const N: usize> {
    x: Vector<f64, N>,
    v: Vector<f64, N>,
    xx: Mat<f64, N>,
    /// `[(m, n)]` = ∂²L/∂x_m ∂v_n.
    xv: Mat<f64, N>,
    vv: Mat<f64, N>,
}

impl<const N: usize> Lagrangian<N> {
    fn new(g: &Mat<Jet2<f64, N>, N>, v: &Vector<f64, N>) -> Self {
        let value = g.map(|j| j.value);
        let dg_v: [Vector<f64, N>; N] =
            std::array::from_fn(|m| apply(&matrix(|i, j| g[(i, j)].d[m]), v));
        Self {
            x: vector(|m| 0.5 * contract(&dg_v[m], v)),
            v: apply(&value, v),
            xx: matrix(|m, n| 0.5 * form(&matrix(|i, j| g[(i, j)].dd[m][n]), v, v)),
            xv: matrix(|m, n| dg_v[m][n]),
            vv: value,
        }
    }
}

/// The jets of (1−τ)δ + τg at x in the coordinates of ℝ^N.
fn jets<const N: usize>(
    g: &dyn Ambient<N>,
    x: &Vector<f64, N>,
    tau: f64,
) -> Result<Mat<Jet2<f64, N>, N>, String> {
    let point: [f64; N] = std::array::from_fn(|i| x[i]);
    let outside = || format!("its geodesic leaves the domain of the metric at {point:?}");
    let g = g.jets_at(&point).ok_or_else(outside)?;
    if indefinite_pivot(&g.map(|j| j.value)).is_some() {
        return Err(outside());
    }
    Ok(Mat::from_fn(|i, j| {
        let flat = Jet2::constant(if i == j { 1.0 - tau } else { 0.0 });
        g[(i, j)].map(|x| tau * x) + flat
    }))
}

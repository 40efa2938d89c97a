//! Floor 2. Quadrature on simplices, in any dimension and of any order, with positive weights.
//!
//! Intervals: Gauss–Legendre. Triangles to order 30 and tetrahedra to order 15: the rules of Xiao and Gimbutas
//! (feature `tabulated`), fully symmetric on triangles, not on tetrahedra. Everything else: conical products of
//! Gauss–Jacobi rules.

mod jacobi;

use crate::scalar::Real;
use crate::simplex::{Points, factorial};

/// A quadrature rule on the reference simplex of a dimension: ∫ f dμ ≈ Σ_q w_q f(λ_q), Σ_q w_q = 1/dim!.
#[derive(Clone, Debug)]
pub struct Rule {
    points: Points,
    weights: Vec<f64>,
}

impl Rule {
    /// A rule that is exact for polynomials of degree ≤ `order` on the simplex of dimension `dim`.
    ///
    /// In dimension 0 the rule is the value at the point.
    pub fn new(dim: usize, order: usize) -> Self {
        match dim {
            0 => Self {
                points: Points::new(1, vec![1.0]),
                weights: vec![1.0],
            },
            _ => tabulated(dim, order).unwrap_or_else(|| conical(dim, order)),
        }
    }

    /// The conical product of Gauss–Jacobi rules, collapsed at vertex 0.
    ///
    /// [`Rule::new`] needs fewer points where a table has a rule.
    pub fn conical(dim: usize, order: usize) -> Self {
        match dim {
            0 => Self::new(0, order),
            _ => conical_over(dim, order, &Self::conical(dim - 1, order)),
        }
    }

    /// A rule from elsewhere; the weights must add up to 1/dim!.
    ///
    /// # Errors
    /// If the lengths do not fit, or a number is not finite, or the weights add up to something else.
    pub fn from_parts(points: Points, weights: Vec<f64>) -> Result<Self, crate::Error> {
        let volume = 1.0 / factorial(points.vertices() - 1);
        let sum: f64 = weights.iter().sum();
        // A table may be rounded in its last printed place: 12 digits are asked for.
        if points.len() != weights.len() || sum.is_nan() || (sum - volume).abs() > 1e-12 * volume {
            return Err(crate::Error::Input(format!(
                "a quadrature rule of {} points has {} weights with sum {sum}, not {volume}",
                points.len(),
                weights.len()
            )));
        }
        Ok(Self { points, weights })
    }

    /// Its points.
    pub fn points(&self) -> &Points {
        &self.points
    }

    /// Its weights.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Its weights by blocks of points; lanes beyond the last point weigh nothing.
    pub fn weight_blocks<T: Real>(&self) -> Vec<T> {
        let at = |q: usize| self.weights.get(q).copied().unwrap_or(0.0);
        (0..self.points.blocks::<T>())
            .map(|b| T::pack(|lane| at(b * T::LANES + lane)))
            .collect()
    }

    /// How many points.
    pub fn len(&self) -> usize {
        self.weights.len()
    }

    /// Never.
    pub fn is_empty(&self) -> bool {
        self.weights.is_empty()
    }
}

/// n points and weights of Gauss' rule on [0, 1]: exact to degree 2n−1.
pub fn gauss_legendre(n: usize) -> (Vec<f64>, Vec<f64>) {
    jacobi::gauss_jacobi(n, 0)
}

/// The conical product: with λ_0 = t the rest is the simplex of one dimension less, shrunk by 1−t.
fn conical(dim: usize, order: usize) -> Rule {
    conical_over(dim, order, &Rule::new(dim - 1, order))
}

/// The conical product over a rule of one dimension less.
fn conical_over(dim: usize, order: usize, base: &Rule) -> Rule {
    let (t, w) = jacobi::gauss_jacobi(order / 2 + 1, dim - 1);
    let (mut lambda, mut weights) = (Vec::new(), Vec::new());
    for (t, w) in t.iter().zip(&w) {
        for q in 0..base.len() {
            lambda.push(*t);
            lambda.extend(base.points.lambda(q).iter().map(|l| (1.0 - t) * l));
            weights.push(w * base.weights[q]);
        }
    }
    Rule {
        points: Points::new(dim + 1, lambda),
        weights,
    }
}

/// Xiao and Gimbutas, as tabulated by the crate quadraturerules: barycentric points, weights with sum 1.
#[cfg(feature = "tabulated")]
fn tabulated(dim: usize, order: usize) -> Option<Rule> {
    use quadraturerules::{Domain, QuadratureRule, single_integral_quadrature};
    let domain = match dim {
        2 if order <= 30 => Domain::Triangle,
        3 if order <= 15 => Domain::Tetrahedron,
        _ => return None,
    };
    let (points, weights) =
        single_integral_quadrature(QuadratureRule::XiaoGimbutas, domain, order.max(1)).ok()?;
    // The table is rounded to 16 digits: make the weights' sum exact.
    let scale = 1.0 / (factorial(dim) * weights.iter().sum::<f64>());
    Some(Rule {
        points: Points::new(dim + 1, points),
        weights: weights.iter().map(|w| w * scale).collect(),
    })
}

#[cfg(not(feature = "tabulated"))]
fn tabulated(_dim: usize, _order: usize) -> Option<Rule> {
    None
}

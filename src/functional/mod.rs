//! Floor 6. The functionals of the paper on a mesh, against every Lagrange test function at once.
//!
//! | function | what | paper |
//! |---|---|---|
//! | [`distributional_curvature`] | ⟨(Rω)_dist(g), v⟩ | def:distcurv |
//! | [`smooth_curvature`] | ∫ R v ω cell by cell | |
//! | [`b_h`], [`a_h`] | the two sides' forms in d/dt⟨(Rω)_dist, v⟩ = b_h − a_h | thm:distcurvdot |
//! | [`einstein`] | ⟨(Gω)_dist(g), σ⟩ | def:distein |
//! | [`einstein_against`] | the same against every Regge basis function | def:distein |
//! | [`boundary_curvature`] | the boundary terms of Gauss and Bonnet | |
//! | [`regge_action`], [`action_gradient`], [`action_hessian`] | Regge's action and equations | |
//! | [`cell_curvatures`], [`face_jumps`], [`angle_defects`] | the sums simplex by simplex | |
//! | [`integrate`] | any density on k-simplices, seen from the cells around | |
//!
//! The three sums over cells T, faces F and hinges S are kept apart. Every function has a twin `…_with` that takes
//! the [`Formulas`](crate::formulas::Formulas) to use.

mod action;
mod boundary;
mod corner;
mod curvature;
mod einstein;
mod integrate;
mod local;
mod site;
mod variation;

pub use action::{ActionGradient, action_gradient, action_hessian, regge_action};
pub use boundary::boundary_curvature;
pub use curvature::{
    angle_defects, distributional_curvature, distributional_curvature_with, smooth_curvature,
};
pub use einstein::einstein_against;
pub use integrate::integrate;
pub use local::{boundary_mean_curvatures, cell_curvatures, cell_volumes, face_jumps};
pub use variation::{a_h, a_h_with, b_h, b_h_with, einstein};

use crate::quadrature::Rule;
use crate::scalar::Real;

/// The quadrature rules of the three sums, in dimensions N, N−1 and N−2.
#[derive(Clone, Debug)]
pub struct Rules {
    /// On cells.
    pub cells: Rule,
    /// On faces.
    pub faces: Rule,
    /// On hinges.
    pub hinges: Rule,
}

impl Rules {
    /// Rules exact for polynomials of degree ≤ `order` on simplices of an N-dimensional mesh.
    ///
    /// The integrands are not polynomials: see [`Rules::default_order`].
    pub fn new<const N: usize>(order: usize) -> Self {
        Self {
            cells: Rule::new(N, order),
            faces: Rule::new(N - 1, order),
            hinges: Rule::new(N - 2, order),
        }
    }

    /// The order at which integration is not what limits the accuracy: 2(r+2)+2 for a metric of degree r, against
    /// test functions of degree r+2.
    ///
    /// On the paper's meshes with k ≥ 1 raising it changes the H⁻² error by less than 3·10⁻⁴ of itself; with two
    /// triangles for the whole square (k = 0) it takes 20 more (`tests/quadrature_order.rs`).
    pub fn default_order(degree: usize) -> usize {
        2 * (degree + 2) + 2
    }
}

/// Three sums over the simplices of a mesh, for every test function, signs and factors included.
#[derive(Clone, Debug, PartialEq)]
pub struct Sums<T> {
    /// Σ_T, by test function.
    pub cells: Vec<T>,
    /// Σ_F, by test function.
    pub faces: Vec<T>,
    /// Σ_S, by test function.
    pub hinges: Vec<T>,
}

impl<T: Real> Sums<T> {
    /// All zero.
    fn zero(len: usize) -> Self {
        Self {
            cells: vec![T::zero(); len],
            faces: vec![T::zero(); len],
            hinges: vec![T::zero(); len],
        }
    }

    /// The whole functional, by test function.
    pub fn total(&self) -> Vec<T> {
        (0..self.cells.len())
            .map(|i| self.cells[i] + self.faces[i] + self.hinges[i])
            .collect()
    }

    /// The three sums for v = Σ c_i v_i. With all c_i = 1, v = 1.
    pub fn pair(&self, coefficients: &[f64]) -> [T; 3] {
        [&self.cells, &self.faces, &self.hinges].map(|sum| {
            let mut value = T::zero();
            for (s, c) in sum.iter().zip(coefficients) {
                value += *s * T::from_f64(*c);
            }
            value
        })
    }
}

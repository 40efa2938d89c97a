//! The curvature of Regge metrics in any dimension, from kernels that are written once and generic over the scalar.
//!
//! A *Regge metric* is smooth on every simplex of a triangulation and has single-valued tangential-tangential
//! components on the faces. Its curvature is a distribution (Gawlik and Neunteufel, *Finite element approximation of
//! scalar curvature in arbitrary dimension*, def:distcurv):
//!
//! ⟨(Rω)_dist(g), v⟩ = Σ_T ∫_T R v ω + 2 Σ̊_F ∫_F ⟦H⟧ v ω_F + 2 Σ̊_S ∫_S Θ_S v ω_S
//!
//! with the scalar curvature R in cells, jumps of the mean curvature H across interior faces and angle defects Θ at
//! interior hinges (simplices of codimension 2). This crate computes it, its first variation b_h − a_h, and the
//! distributional Einstein tensor.
//!
//! ```
//! use num_dual::Dual64;
//! use regge::field::Combination;
//! use regge::functional::{Rules, distributional_curvature};
//! use regge::lagrange::Lagrange;
//! use regge::mesh::Mesh;
//! use regge::metrics::Metric;
//! use regge::regge::{Interpolant, ReggeSpace};
//! use regge::smooth::Smooth;
//!
//! # fn main() -> Result<(), regge::Error> {
//! // A mesh of (−1, 1)³, a metric by formula, its Regge interpolant of degree 1.
//! let mesh = Mesh::<3>::cube(2)?;
//! let graph = Smooth::new(&mesh, Metric::GraphQuartic)?;
//! let space = ReggeSpace::new(&mesh, 1);
//! let g = Interpolant::Canonical { order: 8 }.apply(&space, &graph)?;
//!
//! // Its curvature against every quadratic test function, the three sums kept apart.
//! let test = Lagrange::new(&mesh, 2);
//! let rules = Rules::new::<3>(8);
//! let curvature = distributional_curvature::<f64, _, _>(&g, &test, &rules);
//! let centre = 13; // the vertex in the middle
//! println!("{} {} {}", curvature.element[centre], curvature.face[centre], curvature.hinge[centre]);
//!
//! // The same lines with dual numbers differentiate it along g + t σ, here with σ = g.
//! let moving = Combination::new(Dual64::from(1.0), &g, Dual64::new(0.0, 1.0), &g);
//! let rate = distributional_curvature::<Dual64, _, _>(&moving, &test, &rules).total()[centre];
//! // Rω scales as length^(N−2), that is as (1+t)^½ here.
//! assert!((rate.eps - 0.5 * rate.re).abs() < 1e-12 * rate.re.abs());
//! # Ok(())
//! # }
//! ```
//!
//! # The house
//! Modules import only from floors below their own:
//!
//! | floor | modules |
//! |---|---|
//! | 0 | [`scalar`] |
//! | 1 | [`linalg`], [`simplex`], [`error`] |
//! | 2 | [`jet`], [`quadrature`], [`mesh`], [`field`] |
//! | 3 | [`riemann`] |
//! | 4 | [`hypersurface`], [`hinge`], [`formulas`] |
//! | 5 | [`mod@regge`], [`lagrange`], [`smooth`], [`metrics`] |
//! | 6 | [`functional`] |
//! | 7 | `norm`, `project` (feature `norms`) |
//!
//! # Features
//! Without default features the crate is scalars to functionals on nalgebra and num-dual alone. `norms` adds the H⁻²
//! norm and its sparse solver, `parallel` threads (results do not depend on their number), `lanes` SIMD lanes as a
//! scalar, `tabulated` quadrature rules with fewer points.

pub mod error;
pub mod field;
pub mod formulas;
pub mod functional;
pub mod hinge;
pub mod hypersurface;
pub mod jet;
pub mod lagrange;
pub mod linalg;
pub mod mesh;
pub mod metrics;
#[cfg(feature = "norms")]
pub mod norm;
mod parallel;
#[cfg(feature = "norms")]
pub mod project;
pub mod quadrature;
pub mod regge;
pub mod riemann;
pub mod scalar;
pub mod simplex;
pub mod smooth;

pub use error::Error;

/// The example of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

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
//! # Tutorial
//!
//! **A mesh** is a list of cells; points are optional. Cells may be given in any order and with any orientation; what is
//! no manifold is refused by name.
//!
//! ```
//! use nalgebra::vector;
//! use regge_curvature::Mesh;
//!
//! # fn main() -> Result<(), regge_curvature::Error> {
//! let points = vec![
//!     vector![0.0, 0.0],
//!     vector![1.0, 0.0],
//!     vector![1.0, 1.0],
//!     vector![0.0, 1.0],
//!     vector![0.5, 0.5],
//! ];
//! let cells = [vec![0, 1, 4], vec![1, 2, 4], vec![2, 3, 4], vec![3, 0, 4]];
//! let square = Mesh::<2>::new(points, &cells)?;
//! assert_eq!((square.count(0), square.count(1), square.cell_count()), (5, 8, 4));
//! assert_eq!(square.interior(0).collect::<Vec<_>>(), [4]);
//! // The same without points, and the meshes of the paper: Freudenthal's cube of (−1, 1)^N, shaken.
//! assert_eq!(Mesh::<2>::new_abstract(5, &cells)?.euler_characteristic(), 1);
//! let cube = Mesh::<3>::cube(2)?.perturbed(0.05, 1)?;
//! assert_eq!(cube.cell_count(), 48);
//! # Ok(())
//! # }
//! ```
//!
//! **Edge lengths** are the metrics of degree 0: classical Regge calculus. Four triangles with sides 1, 1, 1 around a
//! vertex leave an angle of 2π − 4π/3; the curvature of its hat function is twice that.
//!
//! ```
//! use regge_curvature::{Lagrange, Mesh, ReggeSpace, Rules, distributional_curvature};
//! use std::f64::consts::PI;
//!
//! # fn main() -> Result<(), regge_curvature::Error> {
//! let cells = [vec![0, 1, 4], vec![1, 2, 4], vec![2, 3, 4], vec![3, 0, 4]];
//! let square = Mesh::<2>::new_abstract(5, &cells)?;
//! let space = ReggeSpace::new(&square, 0);
//! // The coefficients of degree 0 are the squared lengths, edge by edge in the order of the mesh.
//! let pyramid = space.function(vec![1.0; square.count(1)])?;
//! let hats = Lagrange::new(&square, 1);
//! let sums = distributional_curvature(&pyramid, &hats, &Rules::on(&square, 1));
//! assert!((sums.hinges[4] - 2.0 * (2.0 * PI - 4.0 * PI / 3.0)).abs() < 1e-14);
//! # Ok(())
//! # }
//! ```
//!
//! **A metric by a formula** is written once, for every scalar: its derivatives come from jets. Here the unit sphere in
//! the stereographic chart, R = 2; the library knows it as [`metrics::Metric::Sphere`]. Its Regge interpolant of degree
//! r keeps lengths (r = 0), or moments of lengths on edges, faces and cells.
//!
//! ```
//! use regge_curvature::functional::smooth_curvature;
//! use regge_curvature::linalg::{Mat, symmetric};
//! use regge_curvature::metrics::SmoothTensor;
//! use regge_curvature::scalar::Real;
//! use regge_curvature::{
//!     Interpolant, Lagrange, Mesh, ReggeSpace, Rules, Smooth, distributional_curvature,
//! };
//!
//! struct Sphere;
//! impl SmoothTensor<2> for Sphere {
//!     fn at<S: Real>(&self, x: &[S; 2]) -> Mat<S, 2> {
//!         let w = S::one() + x[0] * x[0] + x[1] * x[1];
//!         let factor = S::from_int(4) / (w * w);
//!         symmetric(|i, j| if i == j { factor } else { S::zero() })
//!     }
//! }
//!
//! # fn main() -> Result<(), regge_curvature::Error> {
//! let mesh = Mesh::<2>::cube(8)?;
//! let sphere = Smooth::new(&mesh, Sphere)?;
//! let space = ReggeSpace::new(&mesh, 2);
//! let g = Interpolant::canonical().apply(&space, &sphere)?;
//! // Paired with every hat function: cells, faces and hinges apart.
//! let (hats, rules) = (Lagrange::new(&mesh, 1), Rules::on(&mesh, 10));
//! let ours = distributional_curvature(&g, &hats, &rules);
//! let smooth = smooth_curvature(&sphere, &hats, &rules);
//! let middle = 40; // of 9 × 9 vertices
//! assert!((ours.total()[middle] / smooth[middle] - 1.0).abs() < 1e-3);
//! assert!(ours.faces[middle].abs() > 1e-6, "the jumps are a part of it");
//! # Ok(())
//! # }
//! ```
//!
//! **Derivatives in the metric**: the same lines with dual numbers differentiate the curvature along g + tσ. Rω scales as
//! length^(N−2), which for N = 3 and σ = g means a rate of ½.
//!
//! ```
//! use num_dual::Dual64;
//! use regge_curvature::field::Combination;
//! use regge_curvature::{
//!     Interpolant, Lagrange, Mesh, Metric, ReggeSpace, Rules, Smooth, distributional_curvature,
//! };
//!
//! # fn main() -> Result<(), regge_curvature::Error> {
//! let mesh = Mesh::<3>::cube(2)?;
//! let space = ReggeSpace::new(&mesh, 1);
//! let graph = Smooth::new(&mesh, Metric::GraphQuartic)?;
//! let g = Interpolant::canonical().apply(&space, &graph)?;
//! let (test, rules) = (Lagrange::new(&mesh, 2), Rules::on(&mesh, 8));
//! let moving = Combination::new(Dual64::from(1.0), &g, Dual64::new(0.0, 1.0), &g);
//! let rate = distributional_curvature(&moving, &test, &rules).total();
//! let centre = 13; // the vertex in the middle of 3 × 3 × 3
//! assert!((rate[centre].eps - 0.5 * rate[centre].re).abs() < 1e-12 * rate[centre].re.abs());
//! # Ok(())
//! # }
//! ```
//!
//! More: the folder `examples/` (a sphere from lengths, convergence in H⁻², derivatives, Gauss–Bonnet with R_h, a lattice
//! relaxed to a solution of Regge's equations), and the command line `regge` for meshes and metrics from files.
//!
//! # The house
//! Modules import only from floors below their own:
//!
//! | floor | modules |
//! |---|---|
//! | 0 | [`scalar`] |
//! | 1 | [`error`], `parallel`, [`linalg`], [`jet`], [`formulas`] |
//! | 2 | [`simplex`], [`quadrature`], [`mesh`], [`field`] |
//! | 3 | [`riemann`] |
//! | 4 | [`density`] |
//! | 5 | [`metrics`], [`spaces`], [`interpolate`], `sparse` |
//! | 6 | [`functional`] |
//! | 7 | `norm`, `project` (feature `norms`), `parts` (feature `approx`) |
//!
//! # Features
//! Without default features the crate is scalars to functionals on nalgebra and num-dual alone. `norms` adds the H⁻²
//! norm, the projection R_h and their sparse solver, `parallel` threads (results do not depend on their number), `lanes` SIMD lanes as a
//! scalar, `tabulated` quadrature rules with fewer points. Off by default: `approx` compares values part by part, derivatives
//! too, `serde` writes meshes, Regge functions and results down and reads them again, and `formulas` lets the verification change the
//! signs and factors of the paper's formulas.
//!
//! Lanes are as wide as the compiler's target allows, and the default for x86-64 is half of what nearly every machine has:
//! build your program with `RUSTFLAGS="-C target-cpu=native"`. `scalar::Lanes::unused_width` tells whether that is missing.

pub mod density;
pub mod error;
pub mod field;
pub mod formulas;
pub mod functional;
pub mod interpolate;
pub mod jet;
pub mod linalg;
pub mod mesh;
pub mod metrics;
#[cfg(feature = "norms")]
pub mod norm;
mod parallel;
#[cfg(feature = "approx")]
pub mod parts;
#[cfg(feature = "norms")]
pub mod project;
pub mod quadrature;
pub mod riemann;
pub mod scalar;
pub mod simplex;
pub mod spaces;
#[cfg(feature = "norms")]
mod sparse;

pub use error::Error;
pub use field::TensorField;
pub use functional::{Rules, distributional_curvature};
pub use interpolate::Interpolant;
pub use mesh::Mesh;
pub use metrics::{Metric, Smooth};
#[cfg(feature = "norms")]
pub use norm::HMinus2;
pub use spaces::{Lagrange, ReggeFunction, ReggeSpace};

/// The example of the README, compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

/// The pages for those who add something, whose examples are compiled and run.
#[cfg(doctest)]
mod how_to {
    #[doc = include_str!("../docs/how-to/interpolant.md")]
    struct Interpolant;
    #[doc = include_str!("../docs/how-to/norm.md")]
    struct Norm;
    #[doc = include_str!("../docs/how-to/functional.md")]
    struct Functional;
}

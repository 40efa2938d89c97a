//! Floor 7. Norms of functionals. The first is H⁻² of the paper's section 5, by the Euclidean method of Hellan, Herrmann
//! and Johnson.
//!
//! For a functional f the clamped plate Δ²u = f, u ∈ H²₀(Ω), is solved with u of degree p and moments σ ≈ ∇²u of
//! degree p−1 with continuous normal-normal components:
//!
//! - (σ, τ) − b(τ, u) = 0 for all τ, b(σ, v) = f(v) for all v,
//! - b(τ, v) = Σ_T ∫_T τ:∇²v − ∫_∂T τ(n,n) ∂_n v,
//!
//! and ‖f‖² = ‖u‖² + ‖∇u‖² + ‖σ‖² in L²(Ω). For the curvature of a Regge metric of degree r the paper takes p = r+2.
//!
//! For smooth u the method is of order p+1 in u and p in σ (L²) in the plane; in space of order min(p+1, 2(p−1)) and
//! p−1 only, so that p = 1 does not converge there (`tests/norm.rs`).
//!
//! The continuity of the moments is enforced by the slopes ∂_n u on the interior faces (hybridisation); moments and
//! bubbles are condensed cell by cell. Results are the same bit for bit whatever the number of threads.
//!
//! [`Riesz`] has the norms of earlier results: H⁻¹(Ω, g), and V′_h of the paper's introduction, both by a Cholesky
//! factorisation.
//!
//! # Seams
//! - [`DualNorm`] is what studies and the command line know of a norm, and [`Kind::all`] is the table in which they look
//!   it up. A new norm is a file beside `riesz.rs` with its entry, and the lines in `mod.rs` that name them.
//! - [`BiharmonicSolver`] is what [`HMinus2`] knows of a solver, which owns the discretisation [`Hhj`] that it solves.

mod census;
mod dimension;
mod direct;
mod dual;
mod hhj;
mod hminus2;
mod iterative;
mod kind;
mod riesz;
mod solver;

pub use census::Census;
pub use direct::Direct;
pub use dual::{DualNorm, NormValue, Part, Representative, Step, Target, check_load};
pub use hhj::Hhj;
pub use hminus2::{HMinus2, HMinus2Norm};
pub use iterative::Iterative;
pub use kind::{Kind, MetricValues, Setting, metric_values};
pub use riesz::{Energy, Riesz};
pub use solver::BiharmonicSolver;

impl<const N: usize> Kind<N> {
    const TABLE: &'static [Self] = &[HMinus2::<N>::KIND, Riesz::<N>::HM1, Riesz::<N>::VH];

    /// Every norm that has a name: the same ones for N = 2 and 3, and none for higher N.
    pub fn all() -> &'static [Self] {
        dimension::of_dimension(N, in_the_plane(), in_space()).unwrap_or(&[])
    }

    /// The norm of this name.
    pub fn named(name: &str) -> Option<&'static Self> {
        Self::all().iter().find(|kind| kind.name == name)
    }
}

// A norm is much code. Functions without parameters that are never inlined are compiled here, once, and what they refer to is
// not compiled again with everything that looks a name up. The library's own tests look none up, and what is inlined is
// compiled only where it is used.

#[cfg_attr(not(test), inline(never))]
#[cfg_attr(test, inline)]
fn in_the_plane() -> &'static [Kind<2>] {
    Kind::TABLE
}

#[cfg_attr(not(test), inline(never))]
#[cfg_attr(test, inline)]
fn in_space() -> &'static [Kind<3>] {
    Kind::TABLE
}

//! Floor 7. The H⁻² norm of the paper's section 5, by the Euclidean method of Hellan, Herrmann and Johnson.
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

mod batch;
mod cell;
mod cg;
mod coarse;
mod cycle;
mod direct;
mod dissection;
mod element;
pub(crate) mod factor;
mod hhj;
mod iterative;
mod jacobi;
mod lattice;
mod layout;
mod operator;
mod skeleton;
mod sparse;
mod spline;
mod stencil;
mod transfer;
mod unknowns;

pub use direct::Direct;
pub use hhj::{Deflection, Hhj};
pub use iterative::Iterative;

use crate::Error;
use crate::mesh::Mesh;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::spaces::Lagrange;

/// What solves the discrete problem: the seam at which a solver can be replaced.
pub trait BiharmonicSolver<const N: usize>: std::fmt::Debug + Send + Sync {
    /// The (u, û) of a load for the discretisation that the solver was made for. The load holds f(v) for each v of
    /// [`Hhj::space`]; entries of v on ∂Ω are to be ignored.
    ///
    /// An iterative solver tells `watch` of each of its steps.
    ///
    /// # Errors
    /// If the solver gives up.
    fn solve(
        &self,
        hhj: &Hhj<N>,
        load: &[f64],
        watch: &mut dyn FnMut(Step),
    ) -> Result<Deflection, Error>;

    /// What reports call it.
    fn name(&self) -> &'static str;
}

/// A step of an iterative solver.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Its number, from 1.
    pub number: usize,
    /// The residual after it over that of u = 0, in the norm of the preconditioner: about the error of σ over σ.
    pub residual: f64,
}

/// From this many unknowns on the iterative solver is faster than the direct one in space; in the plane the factor stays
/// small.
const MANY_UNKNOWNS: usize = 15_000;

/// The solver that suits a discretisation: iterative for many unknowns on a cube's mesh in space, direct otherwise.
fn choose<const N: usize>(hhj: &Hhj<N>) -> Result<Box<dyn BiharmonicSolver<N>>, Error> {
    Ok(
        match N == 3 && hhj.len() >= MANY_UNKNOWNS && Iterative::suits(hhj) {
            true => Box::new(Iterative::new(hhj)?),
            false => Box::new(Direct::new(hhj)?),
        },
    )
}

/// The H⁻² norm on a mesh in ℝ^N: set up once, for as many functionals as you like.
#[derive(Debug)]
pub struct HMinus2<const N: usize> {
    hhj: Hhj<N>,
    solver: Box<dyn BiharmonicSolver<N>>,
}

/// The three parts of an H⁻² norm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HMinus2Norm {
    /// ‖u‖ in L²(Ω).
    pub u_l2: f64,
    /// ‖∇u‖ in L²(Ω).
    pub grad_l2: f64,
    /// ‖σ‖ in L²(Ω), the moments' norm (not that of the broken Hessian of u).
    pub sigma_l2: f64,
}

impl HMinus2Norm {
    /// √(‖u‖² + ‖∇u‖² + ‖σ‖²).
    pub fn total(&self) -> f64 {
        (self.u_l2.powi(2) + self.grad_l2.powi(2) + self.sigma_l2.powi(2)).sqrt()
    }
}

impl<const N: usize> HMinus2<N> {
    /// The norm by u of degree p, with the solver that suits the mesh: [`Iterative`] for many unknowns on a cube's mesh in
    /// space, [`Direct`] otherwise.
    ///
    /// # Errors
    /// As [`Hhj::new`], [`Direct::new`] and [`Iterative::new`].
    pub fn new(mesh: &Mesh<N>, degree: usize) -> Result<Self, Error> {
        let hhj = Hhj::new(mesh, degree)?;
        let solver = choose(&hhj)?;
        Ok(Self { hhj, solver })
    }

    /// The norm by a discretisation and a solver made for it.
    pub fn with_solver(hhj: Hhj<N>, solver: Box<dyn BiharmonicSolver<N>>) -> Self {
        Self { hhj, solver }
    }

    /// The solver's name.
    pub fn solver(&self) -> &'static str {
        self.solver.name()
    }

    /// The discretisation.
    pub fn hhj(&self) -> &Hhj<N> {
        &self.hhj
    }

    /// The space of the test functions v of a load f(v).
    pub fn space(&self) -> &Lagrange<N> {
        self.hhj.space()
    }

    /// The discrete solution of Δ²u = f; `load` holds f(v) for each v of [`HMinus2::space`], those on ∂Ω are ignored.
    ///
    /// # Errors
    /// If the load has the wrong length or an entry that is not finite, or the solver gives up.
    pub fn solve(&self, load: &[f64]) -> Result<Deflection, Error> {
        self.solve_watched(load, &mut |_| ())
    }

    /// [`HMinus2::solve`]; `watch` is told of each step of an iterative solver.
    ///
    /// # Errors
    /// As [`HMinus2::solve`].
    pub fn solve_watched(
        &self,
        load: &[f64],
        watch: &mut dyn FnMut(Step),
    ) -> Result<Deflection, Error> {
        if load.len() != self.space().len() {
            let reason = format!(
                "a load of length {} for {} functions",
                load.len(),
                self.space().len()
            );
            return Err(Error::Input(reason));
        }
        if let Some(dof) = load.iter().position(|f| !f.is_finite()) {
            return Err(Error::Input(format!(
                "entry {dof} of the load is {}",
                load[dof]
            )));
        }
        let deflection = self.solver.solve(&self.hhj, load, watch)?;
        match deflection.coefficients.iter().all(|x| x.is_finite()) {
            true => Ok(deflection),
            false => Err(Error::Solver(
                "the solution overflows: a cell may be all but flat".into(),
            )),
        }
    }

    /// ‖f‖ in H⁻². The three L² norms are integrated by `rule`, or exactly (order 2p) if there is none.
    ///
    /// # Errors
    /// As [`HMinus2::solve`], and if the rule is not one for N-simplices.
    pub fn norm(&self, load: &[f64], rule: Option<&Rule>) -> Result<HMinus2Norm, Error> {
        self.norm_of(&self.solve(load)?, rule)
    }

    /// The norm of the functional whose solution is at hand.
    ///
    /// # Errors
    /// If the solution has the wrong length, or the rule is not one for N-simplices.
    pub fn norm_of(
        &self,
        deflection: &Deflection,
        rule: Option<&Rule>,
    ) -> Result<HMinus2Norm, Error> {
        let exact = Rule::new(N, 2 * self.space().degree());
        let rule = rule.unwrap_or(&exact);
        if rule.points().vertices() != N + 1 || deflection.coefficients.len() != self.hhj.len() {
            return Err(Error::Input(
                "a rule or a solution of another mesh or dimension".into(),
            ));
        }
        let table = self.hhj.table(rule);
        let mut sums = [0.0; 3];
        let squares = |cell| self.hhj.squares(deflection, cell, &table);
        in_order(self.hhj.mesh().cell_count(), squares, |_, squares| {
            for (sum, square) in sums.iter_mut().zip(squares) {
                *sum += square;
            }
        });
        let [u_l2, grad_l2, sigma_l2] = sums.map(f64::sqrt);
        Ok(HMinus2Norm {
            u_l2,
            grad_l2,
            sigma_l2,
        })
    }
}

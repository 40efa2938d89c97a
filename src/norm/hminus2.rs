//! The H⁻² norm.

use super::census::Census;
use super::direct::{self, Direct};
use super::dual::{DualNorm, NormValue, Part, Representative, Step, check_load};
use super::hhj::{Hhj, Size};
use super::iterative::{self, Iterative};
use super::kind::{Kind, Setting};
use super::solver::BiharmonicSolver;
use crate::Error;
use crate::mesh::Mesh;
use crate::parallel::in_order;
use crate::quadrature::Rule;
use crate::spaces::Lagrange;
use std::sync::Arc;

/// From this many coefficients on the iterative solver is faster than the direct one on a cube's mesh in space. In the plane the
/// factor of a square's lattice stays small, and its moved triangles take the iteration many steps.
const MANY_ON_A_CUBE: [usize; 2] = [3_000_000, 15_000];
/// The same for other meshes, in the plane and in space. In space the direct solver takes about 2.5e-10 n² seconds for n unknowns on
/// two threads, the iteration 2e-5 n to 3e-5 n. In the plane both take 2 seconds for 314 147 unknowns (p = 2), 27 and 12 seconds for
/// 2.2 million (p = 3), and the iteration's memory is a fifth to a ninth.
const MANY: [usize; 2] = [100_000, 50_000];

/// Does the iterative solver suit?
fn iterates(census: &Census, size: &Size) -> bool {
    let many = if census.cube { MANY_ON_A_CUBE } else { MANY };
    let many = size.dimension().checked_sub(2).and_then(|n| many.get(n));
    many.is_some_and(|&many| size.coefficients() >= many)
}

/// The H⁻² norm on a mesh in ℝ^N, Euclidean whatever the metric: set up once, for as many functionals as you like.
///
/// A functional is represented by (u, û), see [`Hhj`]. The parts of the norm are `u_l2`, `grad_l2` and `sigma_l2`, those of
/// [`HMinus2Norm`].
#[derive(Debug)]
pub struct HMinus2<const N: usize> {
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
        NormValue::from(*self).total
    }
}

impl From<HMinus2Norm> for NormValue {
    fn from(norm: HMinus2Norm) -> Self {
        let part = |name, value| Part { name, value };
        Self::of_parts(vec![
            part("u_l2", norm.u_l2),
            part("grad_l2", norm.grad_l2),
            part("sigma_l2", norm.sigma_l2),
        ])
    }
}

impl<const N: usize> HMinus2<N> {
    /// The entry in the table of norms: `hm2`, with u of degree r + 2 for the curvature of a metric of degree r, as in the
    /// paper's section 5.
    pub(super) const KIND: Kind<N> = Kind {
        name: "hm2",
        symbol: "H^-2",
        about: "H^-2 by Hellan, Herrmann and Johnson",
        degree: |r| r + 2,
        memory: Self::memory,
        new: Self::boxed,
    };

    fn boxed(setting: &Setting<'_, N>) -> Result<Box<dyn DualNorm<N>>, Error> {
        Ok(Box::new(Self::new(setting.mesh, setting.degree)?))
    }

    /// The norm by u of degree p, with the solver that suits the mesh: [`Iterative`] for many unknowns in the plane and in
    /// space, [`Direct`] otherwise.
    ///
    /// # Errors
    /// As [`Hhj::new`], [`Direct::new`] and [`Iterative::new`].
    pub fn new(mesh: &Mesh<N>, degree: usize) -> Result<Self, Error> {
        let hhj = Arc::new(Hhj::new(mesh, degree)?);
        let census = Census::of(mesh);
        let size = Size::new(&census.simplices, degree);
        let solver: Result<Box<dyn BiharmonicSolver<N>>, Error> =
            match iterates(&census, &size) && Iterative::suits(mesh) {
                true => Iterative::new(hhj.clone()).map(|solver| Box::new(solver) as _),
                false => Direct::new(hhj.clone()).map(|solver| Box::new(solver) as _),
            };
        let solver = solver.map_err(|error| hhj.blame(error))?;
        Ok(Self::with_solver(solver))
    }

    /// The norm by a solver with its discretisation.
    pub fn with_solver(solver: Box<dyn BiharmonicSolver<N>>) -> Self {
        Self { solver }
    }

    /// The memory in bytes that the norm by u of degree p ≥ 1 takes at its height on a mesh that is not there yet, the
    /// mesh itself not counted: what [`HMinus2::new`] and one [`HMinus2::solve`] hold.
    ///
    /// With a study's other needs it was 20 to 30 % more than was measured for N = 3, k = 5 (275 and 889 MiB for r = 0 and
    /// 2), 5 % more for N = 2, k = 7, r = 2 (747 MiB).
    pub fn memory(census: &Census, degree: usize) -> f64 {
        let size = Size::new(&census.simplices, degree);
        match iterates(census, &size) {
            true => iterative::memory(&size, Some(census.boundary).filter(|_| !census.cube)),
            false => direct::memory(&size),
        }
    }

    /// The solver's name.
    pub fn solver(&self) -> &'static str {
        self.solver.name()
    }

    /// The discretisation.
    pub fn hhj(&self) -> &Hhj<N> {
        self.solver.hhj()
    }

    /// The space of the test functions v of a load f(v).
    pub fn space(&self) -> &Lagrange<N> {
        self.hhj().space()
    }

    /// The discrete solution of Δ²u = f; `load` holds f(v) for each v of [`HMinus2::space`], those on ∂Ω are ignored.
    ///
    /// # Errors
    /// If the load has the wrong length or an entry that is not finite, or the solver gives up.
    pub fn solve(&self, load: &[f64]) -> Result<Representative, Error> {
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
    ) -> Result<Representative, Error> {
        check_load(self.space(), load)?;
        let solution = self.solver.solve(load, watch);
        let finite =
            |solution: Representative| match solution.coefficients.iter().all(|x| x.is_finite()) {
                true => Ok(solution),
                false => Err(Error::Solver("the solution overflows".into())),
            };
        solution
            .and_then(finite)
            .map_err(|error| self.hhj().blame(error))
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
        solution: &Representative,
        rule: Option<&Rule>,
    ) -> Result<HMinus2Norm, Error> {
        let hhj = self.hhj();
        let exact = Rule::new(N, 2 * hhj.space().degree());
        let rule = rule.unwrap_or(&exact);
        if rule.points().vertices() != N + 1 || solution.coefficients.len() != hhj.len() {
            return Err(Error::Input(
                "a rule or a solution of another mesh or dimension".into(),
            ));
        }
        let table = hhj.table(rule);
        let mut sums = [0.0; 3];
        let squares = |cell| hhj.squares(solution, cell, &table);
        in_order(hhj.mesh().cell_count(), squares, |_, squares| {
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

impl<const N: usize> DualNorm<N> for HMinus2<N> {
    fn space(&self) -> &Lagrange<N> {
        self.space()
    }

    fn solver(&self) -> &'static str {
        self.solver()
    }

    fn unknowns(&self) -> usize {
        self.hhj().len()
    }

    fn represent(
        &self,
        load: &[f64],
        watch: &mut dyn FnMut(Step),
    ) -> Result<Representative, Error> {
        self.solve_watched(load, watch)
    }

    fn measure(
        &self,
        representative: &Representative,
        rule: Option<&Rule>,
    ) -> Result<NormValue, Error> {
        Ok(self.norm_of(representative, rule)?.into())
    }
}

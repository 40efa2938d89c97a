//! The seam for solvers of the biharmonic problem.

use super::dual::{Representative, Step};
use super::hhj::Hhj;
use crate::Error;

/// What solves the discrete biharmonic problem. A solver is made for a discretisation and owns it.
pub trait BiharmonicSolver<const N: usize>: std::fmt::Debug + Send + Sync {
    /// The discretisation that it solves.
    fn hhj(&self) -> &Hhj<N>;

    /// The (u, û) of a load, in the order of [`Hhj::cell_unknowns`]. The load holds f(v) for each v of [`Hhj::space`];
    /// entries of v on ∂Ω are to be ignored.
    ///
    /// An iterative solver tells `watch` of each of its steps.
    ///
    /// # Errors
    /// If the solver gives up.
    ///
    /// # Panics
    /// If the load has the wrong length; [`super::HMinus2`] looks at it before.
    fn solve(&self, load: &[f64], watch: &mut dyn FnMut(Step)) -> Result<Representative, Error>;

    /// What reports call it.
    fn name(&self) -> &'static str;
}

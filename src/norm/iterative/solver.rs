//! The iteration: the condensed operator, its preconditioner, and conjugate gradients with them.

use super::cg::{self, System};
use super::coarse::Coarse;
use super::cycle::{Cycle, Workshop};
use super::jacobi::BlockJacobi;
use super::mixed::Mixed;
use super::operator::Operator;
use super::skeleton::Skeleton;
use crate::Error;
use crate::norm::dual::{Representative, Step, Target};
use crate::norm::hhj::Hhj;
use crate::parallel::within;
use std::sync::Arc;

/// What [`super::Iterative`] knows of its solver, so that the code of one is compiled once; each method is the one of that
/// name there.
pub trait Iterates<const N: usize>: std::fmt::Debug + Send + Sync {
    fn hhj(&self) -> &Hhj<N>;
    fn solve(&self, load: &[f64], watch: &mut dyn FnMut(Step)) -> Result<Representative, Error>;
    fn unknowns(&self) -> usize;
    fn operations(&self) -> f64;
    fn apply(&self, x: &[f64], y: &mut [f64], room: &mut Vec<f64>);
    fn precondition(&self, r: &[f64], z: &mut [f64]);
}

/// The solver for one discretisation.
#[derive(Debug)]
pub struct Solver<const N: usize> {
    operator: Arc<Operator<f64, N>>,
    cycle: Cycle<N>,
    target: Target,
}

impl<const N: usize> Solver<N> {
    /// Sets it up.
    ///
    /// # Errors
    /// If a block of the operator is not positive definite.
    pub fn new(hhj: Arc<Hhj<N>>, target: Target) -> Result<Self, Error> {
        let skeleton = Arc::new(Skeleton::new(hhj.mesh(), hhj.space().degree()));
        let coarse = Coarse::new(&hhj, &skeleton)?;
        let jacobi = BlockJacobi::new(&hhj, &skeleton)?;
        let operator = Arc::new(Operator::new(&hhj, &skeleton));
        Ok(Self {
            cycle: Cycle::new(Mixed::new(&operator), jacobi, coarse),
            operator,
            target,
        })
    }
}

/// The operator and the cycle with what they work with.
struct Condensed<'a, const N: usize> {
    operator: &'a Operator<f64, N>,
    cycle: &'a Cycle<N>,
    /// What an application overwrites.
    room: Vec<f64>,
    workshop: Workshop<N>,
}

impl<const N: usize> System for Condensed<'_, N> {
    type Number = f32;

    fn apply(&mut self, p: &[f64], q: &mut [f64]) {
        self.operator.apply(p, q, &mut self.room);
    }

    fn precondition(&mut self, r: &[f64]) -> f64 {
        self.cycle.apply(r, &mut self.workshop)
    }

    fn preconditioned(&self) -> &[f32] {
        &self.workshop.z
    }
}

impl<const N: usize> Iterates<N> for Solver<N> {
    fn hhj(&self) -> &Hhj<N> {
        &self.operator.hhj
    }

    fn solve(&self, load: &[f64], watch: &mut dyn FnMut(Step)) -> Result<Representative, Error> {
        assert_eq!(
            load.len(),
            self.hhj().space().len(),
            "a load of another space"
        );
        let (operator, skeleton) = (&self.operator, &self.operator.skeleton);
        let mut system = Condensed {
            operator,
            cycle: &self.cycle,
            room: vec![0.0; operator.room()],
            workshop: self.cycle.workshop(),
        };
        let mut r = skeleton.gather(load);
        operator.condense(load, &mut r, &mut system.room);
        let x = cg::solve(&mut system, r, self.target, watch)?;
        let mut coefficients = vec![0.0; self.hhj().len()];
        skeleton.scatter(&x, &mut coefficients);
        operator.bubbles(load, &x, &mut coefficients, &mut system.room);
        Ok(Representative { coefficients })
    }

    fn unknowns(&self) -> usize {
        self.operator.skeleton.len()
    }

    fn operations(&self) -> f64 {
        self.operator.operations()
    }

    fn apply(&self, x: &[f64], y: &mut [f64], room: &mut Vec<f64>) {
        room.resize(self.operator.room(), 0.0);
        within(|| self.operator.apply(x, y, room));
    }

    fn precondition(&self, r: &[f64], z: &mut [f64]) {
        within(|| {
            let mut workshop = self.cycle.workshop();
            let size = self.cycle.apply(r, &mut workshop);
            cg::convert(&workshop.z, size, z);
        });
    }
}

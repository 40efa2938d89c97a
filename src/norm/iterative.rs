//! The matrix-free solver: conjugate gradients, preconditioned by blocks and a coarse space of splines.

use super::cg::{self, Target};
use super::coarse::Coarse;
use super::cycle::{Cycle, Room};
use super::hhj::{Deflection, Hhj};
use super::jacobi::BlockJacobi;
use super::lattice::Lattice;
use super::operator::Operator;
use super::{BiharmonicSolver, Step};
use crate::Error;

/// Conjugate gradients for meshes that [`crate::mesh::Mesh::cube`] made, with inner vertices moved or not. Nothing of the
/// operator is stored; its bits do not depend on the number of threads.
///
/// The preconditioner smooths by the inverse diagonal blocks, one a simplex, corrects in cubic splines and smooths again.
#[derive(Debug)]
pub struct Iterative<const N: usize> {
    operator: Operator,
    cycle: Cycle<N>,
    target: Target,
}

/// The residual at which the iteration ends, relative to that of u = 0. The error of ‖σ‖² is of the order of its square.
const RESIDUAL: f64 = 1e-8;
/// Far more steps than any mesh needs.
const STEPS: usize = 1000;

impl<const N: usize> Iterative<N> {
    /// Is it for this mesh?
    pub fn suits(hhj: &Hhj<N>) -> bool {
        (2..=3).contains(&N) && Lattice::of(hhj.mesh()).is_some()
    }

    /// Sets up the preconditioner for a discretisation.
    ///
    /// # Errors
    /// If the mesh is not a cube's or N > 3, or a block of the operator is not positive definite.
    pub fn new(hhj: &Hhj<N>) -> Result<Self, Error> {
        if !Self::suits(hhj) {
            let reason = "the iterative solver is for the cube's mesh, inner vertices moved or not, N = 2 or 3";
            return Err(Error::Input(reason.into()));
        }
        let operator = Operator::new(hhj);
        let coarse = Coarse::new(hhj, &operator.skeleton)?;
        let jacobi = BlockJacobi::new(hhj, &operator.skeleton)?;
        let cycle = Cycle::new(hhj, &operator, jacobi, coarse);
        Ok(Self {
            operator,
            cycle,
            target: Target {
                residual: RESIDUAL,
                steps: STEPS,
            },
        })
    }
}

/// What benches measure.
impl<const N: usize> Iterative<N> {
    /// How many unknowns it iterates on, clamped ones included.
    pub fn unknowns(&self) -> usize {
        self.operator.skeleton.len()
    }

    /// How many additions and multiplications one application of the operator is, as dense products count them.
    pub fn operations(&self, hhj: &Hhj<N>) -> f64 {
        self.operator.operations(hhj)
    }

    /// y = S x for the condensed operator S on all unknowns; `room` is overwritten and of the right size after the
    /// first time.
    ///
    /// # Panics
    /// If x or y has not [`Iterative::unknowns`] entries.
    pub fn apply(&self, hhj: &Hhj<N>, x: &[f64], y: &mut [f64], room: &mut Vec<f64>) {
        assert!(x.len() == self.unknowns() && y.len() == x.len());
        room.resize(self.operator.room(hhj), 0.0);
        self.operator.apply(hhj, x, y, room);
    }

    /// z = M⁻¹ r for the preconditioner M.
    ///
    /// # Panics
    /// If r or z has not [`Iterative::unknowns`] entries.
    pub fn precondition(&self, hhj: &Hhj<N>, r: &[f64], z: &mut [f64]) {
        assert!(r.len() == self.unknowns() && z.len() == r.len());
        let mut room = Room::new(hhj, &self.operator);
        self.cycle.apply(hhj, &self.operator, r, z, &mut room);
    }
}

impl<const N: usize> BiharmonicSolver<N> for Iterative<N> {
    fn name(&self) -> &'static str {
        "cg"
    }

    fn solve(
        &self,
        hhj: &Hhj<N>,
        load: &[f64],
        watch: &mut dyn FnMut(Step),
    ) -> Result<Deflection, Error> {
        let skeleton = &self.operator.skeleton;
        let mut r = skeleton.gather(hhj, load);
        let mut room = Room::new(hhj, &self.operator);
        self.operator.condense(hhj, load, &mut r, room.operator());
        let x = cg::solve(
            r,
            self.target,
            &mut room,
            |p, q, room| self.operator.apply(hhj, p, q, room.operator()),
            |r, z, room| self.cycle.apply(hhj, &self.operator, r, z, room),
            watch,
        )?;
        let mut coefficients = vec![0.0; hhj.len()];
        skeleton.scatter(hhj, &x, &mut coefficients);
        self.operator.bubbles(hhj, load, &x, &mut coefficients);
        Ok(Deflection { coefficients })
    }
}

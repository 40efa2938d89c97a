//! The matrix-free solver: conjugate gradients, preconditioned by blocks and a coarse space of splines.

mod batch;
mod cg;
mod closures;
mod coarse;
mod cycle;
mod jacobi;
mod kernel;
mod mixed;
mod number;
mod operator;
mod order;
mod packed;
mod pairing;
mod product;
mod skeleton;
mod smoother;
mod solver;
mod width;

use super::dimension::of_dimension;
use super::dual::{Representative, Step, Target};
use super::hhj::{Hhj, Size};
use super::solver::BiharmonicSolver;
use crate::Error;
use crate::mesh::Mesh;
use crate::parallel::within;
pub(super) use coarse::lattice::Lattice;
use solver::{Iterates, Solver};
use std::sync::Arc;

/// Conjugate gradients for meshes with points in the plane and in space. Nothing of the operator is stored; its bits do
/// not depend on the number of threads.
///
/// The preconditioner smooths by the inverse diagonal blocks, one a simplex, corrects in cubic splines and smooths again. On
/// meshes that [`Mesh::cube`] made, inner vertices moved or not, the splines' form is inverted by one transform, on others by
/// a cycle over coarser and coarser splines.
#[derive(Debug)]
pub struct Iterative<const N: usize> {
    solver: Box<dyn Iterates<N>>,
}

/// What sets up a solver.
type Make<const N: usize> = fn(Arc<Hhj<N>>, Target) -> Result<Box<dyn Iterates<N>>, Error>;

impl<const N: usize> Iterative<N> {
    /// Is it for this mesh?
    pub fn suits(mesh: &Mesh<N>) -> bool {
        Self::make(mesh).is_some()
    }

    /// Sets up the preconditioner for a discretisation, which is taken as it is or shared. It will iterate to
    /// [`Target::DEFAULT`].
    ///
    /// # Errors
    /// If the mesh has no points or N > 3, or a block of the operator is not positive definite.
    pub fn new(hhj: impl Into<Arc<Hhj<N>>>) -> Result<Self, Error> {
        Self::with_target(hhj, Target::DEFAULT)
    }

    /// [`Iterative::new`] with another target.
    ///
    /// # Errors
    /// As [`Iterative::new`].
    pub fn with_target(hhj: impl Into<Arc<Hhj<N>>>, target: Target) -> Result<Self, Error> {
        let hhj = hhj.into();
        let Some(make) = Self::make(hhj.mesh()) else {
            let reason =
                "the iterative solver is for meshes in the plane and in space that have points";
            return Err(Error::Input(reason.into()));
        };
        let solver = make(hhj, target)?;
        Ok(Self { solver })
    }

    /// What sets up a solver on a mesh, if the iteration is for it.
    fn make(mesh: &Mesh<N>) -> Option<Make<N>> {
        let (plane, space): (Make<2>, Make<3>) = (in_the_plane, in_space);
        mesh.points().and(of_dimension(N, plane, space))
    }
}

// The solver is much code, compiled once, and not at all for the library's own tests, as in the table of norms.

#[cfg_attr(not(test), inline(never))]
#[cfg_attr(test, inline)]
fn in_the_plane(hhj: Arc<Hhj<2>>, target: Target) -> Result<Box<dyn Iterates<2>>, Error> {
    Ok(Box::new(within(|| Solver::new(hhj, target))?))
}

#[cfg_attr(not(test), inline(never))]
#[cfg_attr(test, inline)]
fn in_space(hhj: Arc<Hhj<3>>, target: Target) -> Result<Box<dyn Iterates<3>>, Error> {
    Ok(Box::new(within(|| Solver::new(hhj, target))?))
}

/// What benches measure, and tests look at.
impl<const N: usize> Iterative<N> {
    /// How many unknowns it iterates on: u without its bubbles, and û, inside Ω.
    pub fn unknowns(&self) -> usize {
        self.solver.unknowns()
    }

    /// How many additions and multiplications one application of the operator is, as dense products count them.
    pub fn operations(&self) -> f64 {
        self.solver.operations()
    }

    /// y = S x for the condensed operator S on all unknowns; `room` is overwritten and of the right size after the
    /// first time.
    ///
    /// # Panics
    /// If x or y has not [`Iterative::unknowns`] entries.
    pub fn apply(&self, x: &[f64], y: &mut [f64], room: &mut Vec<f64>) {
        assert!(x.len() == self.unknowns() && y.len() == x.len());
        self.solver.apply(x, y, room);
    }

    /// z = M⁻¹ r for the preconditioner M.
    ///
    /// # Panics
    /// If r or z has not [`Iterative::unknowns`] entries.
    pub fn precondition(&self, r: &[f64], z: &mut [f64]) {
        assert!(r.len() == self.unknowns() && z.len() == r.len());
        self.solver.precondition(r, z);
    }
}

impl<const N: usize> BiharmonicSolver<N> for Iterative<N> {
    fn hhj(&self) -> &Hhj<N> {
        self.solver.hhj()
    }

    fn name(&self) -> &'static str {
        "cg"
    }

    fn solve(&self, load: &[f64], watch: &mut dyn FnMut(Step)) -> Result<Representative, Error> {
        self.solver.solve(load, watch)
    }
}

/// The bytes that the iteration takes: the cells' geometry, in both precisions, and order; inverse blocks in single precision, and in
/// double precision those of as many bad cells as may have one; four vectors of conjugate gradients and four of the cycle, which are
/// half as long; the load and the solution; a place for each cell's result, and for an eighth of them in double precision. While they
/// are set up the simplices' blocks are there in double precision too, and where the mesh is no cube with so many faces in ∂Ω the
/// splines' rows.
pub(super) fn memory(size: &Size, boundary: Option<usize>) -> f64 {
    let [blocks, unknowns, u, outer] = [
        size.blocks(),
        size.unknowns(),
        size.functions(),
        size.cells() * size.outer(),
    ]
    .map(|count| count as f64);
    let vectors = (8.0 * 4.0 + 4.0 * 4.0) * unknowns;
    let solution = 8.0 * 2.0 * (u + unknowns);
    let set_up = (8.0 * blocks - vectors).max(0.0);
    let splines = boundary.map_or(0.0, |faces| coarse::memory(size, faces));
    let of_cell = if size.dimension() == 2 { 230.0 } else { 420.0 };
    let cells = of_cell * size.cells() as f64 + closures::memory(size.cells(), size.outer());
    cells + 4.0 * blocks + vectors + solution + 5.0 * outer + set_up + splines
}

//! The preconditioner: a symmetric cycle of smoothing, coarse correction and smoothing again.
//!
//! The smoother S is a polynomial of J A times J, the blocks' inverses. With E = (1 − S A)(1 − C A)(1 − S A) the cycle is
//! (1 − E) A⁻¹, which is symmetric, and positive definite whenever the smoother converges, whatever the weight of C.

use super::cg::{convert, dot};
use super::coarse::{Coarse, Rooms};
use super::jacobi::BlockJacobi;
use super::mixed::Mixed;
use super::smoother::{Room, Smoothed, Smoother};

/// What the cycle is made of, in single precision but for flat cells: the steps of conjugate gradients around it are in double
/// precision, and none of them hangs on its last digits.
#[derive(Debug)]
pub(super) struct Cycle<const N: usize> {
    fine: Fine<N>,
    smoother: Smoother,
    coarse: Coarse<N>,
}

/// The operator on the mesh's unknowns with its blocks' inverses.
#[derive(Debug)]
struct Fine<const N: usize> {
    operator: Mixed<N>,
    jacobi: BlockJacobi,
}

impl<const N: usize> Smoothed for Fine<N> {
    type Number = f32;
    type Room = Vec<f32>;

    fn room(&self) -> Vec<f32> {
        vec![0.0; self.operator.room()]
    }

    fn len(&self) -> usize {
        self.operator.len()
    }

    fn apply(&self, x: &[f32], y: &mut [f32], room: &mut Vec<f32>) {
        self.operator.apply(x, y, room);
    }

    fn invert(&self, r: &[f32], z: &mut [f32]) {
        self.jacobi.apply(r, z);
    }

    fn subtract_image(&self, room: &mut Room<Self>) {
        let (x, r) = (&room.correction, &mut room.residual);
        self.operator.add(-1.0, x, r, &mut room.operator);
    }

    // Two passes after the cells': in one, which was tried, sums of what cells have wait for a simplex' block, and it takes a tenth longer.
    fn step(&self, weight: f64, z: &mut [f32], room: &mut Room<Self>) {
        self.subtract_image(room);
        let (r, x) = (&room.residual, &mut room.correction);
        self.jacobi.step(weight as f32, r, x, z);
    }
}

/// What a cycle works with.
pub(super) struct Workshop<const N: usize> {
    /// What it computes.
    pub z: Vec<f32>,
    room: Room<Fine<N>>,
    coarse: Rooms<N>,
}

impl<const N: usize> Cycle<N> {
    pub fn new(operator: Mixed<N>, jacobi: BlockJacobi, coarse: Coarse<N>) -> Self {
        let fine = Fine { operator, jacobi };
        Self {
            smoother: Smoother::new(coarse.smoothing(), &fine),
            fine,
            coarse,
        }
    }

    pub fn workshop(&self) -> Workshop<N> {
        Workshop {
            z: vec![0.0; self.fine.len()],
            room: Room::new(&self.fine),
            coarse: self.coarse.rooms(),
        }
    }

    /// Leaves M⁻¹ r in the workshop's z, divided by the size of r, which is returned: single precision has a narrow range.
    pub fn apply(&self, r: &[f64], workshop: &mut Workshop<N>) -> f64 {
        let size = dot(r, r).sqrt();
        match size == 0.0 {
            true => workshop.z.fill(0.0),
            false => {
                convert(r, 1.0 / size, &mut workshop.room.residual);
                self.cycle(workshop);
            }
        }
        size
    }

    /// z from the residual.
    fn cycle(&self, workshop: &mut Workshop<N>) {
        let Workshop { z, room, coarse } = workshop;
        self.smoother.begin(&self.fine, z, room);
        room.correction.fill(0.0);
        self.coarse
            .add(&room.residual, &mut room.correction, coarse);
        self.smoother.end(&self.fine, z, room);
    }
}

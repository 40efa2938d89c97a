//! The preconditioner: a symmetric cycle of smoothing, coarse correction and smoothing again.
//!
//! The smoother is Chebyshev's iteration with the blocks' inverses J. With E = (1 − S A)(1 − C A)(1 − S A) the cycle is
//! (1 − E) A⁻¹, which is symmetric, and positive definite whenever the smoother converges, whatever the weight of C.

use super::cg::{axpy, combine, dot, scale};
use super::coarse::Coarse;
use super::jacobi::BlockJacobi;
use super::operator::Operator;
use crate::mesh::SplitMix64;

/// How many steps of Chebyshev's iteration smooth.
const DEGREE: usize = 2;
/// The largest eigenvalue over the least that is smoothed. Measured: with 2 and 8 the iteration takes up to a fifth longer,
/// and a third step of smoothing saves next to nothing.
const RATIO: f64 = 4.0;
/// How many steps find the largest eigenvalue, and what is added to what they find, which is too low.
const POWER_STEPS: usize = 15;
const MARGIN: f64 = 1.1;

/// What the cycle is made of.
#[derive(Debug)]
pub(super) struct Cycle<const N: usize> {
    pub operator: Operator<N>,
    jacobi: BlockJacobi,
    coarse: Coarse<N>,
    /// The largest eigenvalue of J A.
    largest: f64,
}

/// Vectors that the cycle works with.
pub(super) struct Room {
    residual: Vec<f64>,
    correction: Vec<f64>,
    image: Vec<f64>,
    operator: Vec<f64>,
}

impl<const N: usize> Cycle<N> {
    pub fn new(operator: Operator<N>, jacobi: BlockJacobi, coarse: Coarse<N>) -> Self {
        let mut cycle = Self {
            operator,
            jacobi,
            coarse,
            largest: 1.0,
        };
        let mut random = SplitMix64::new(1);
        let len = cycle.operator.skeleton.len();
        let mut r: Vec<f64> = (0..len).map(|_| random.symmetric()).collect();
        let mut z = vec![0.0; r.len()];
        let mut room = vec![0.0; cycle.operator.room()];
        for _ in 0..POWER_STEPS {
            // z = J r has the square rᵀ J r in the norm of J⁻¹; the next r is A z.
            cycle.jacobi.apply(&r, &mut z);
            let square = dot(&r, &z);
            cycle.operator.apply(&z, &mut r, &mut room);
            cycle.largest = dot(&r, &z) / square;
            let factor = 1.0 / square.sqrt();
            scale(&mut r, factor);
        }
        cycle.largest *= MARGIN;
        cycle
    }

    /// z = M⁻¹ r.
    pub fn apply(&self, r: &[f64], z: &mut [f64], room: &mut Room) {
        z.fill(0.0);
        room.residual.copy_from_slice(r);
        self.smooth(z, room, true);
        room.correction.fill(0.0);
        self.coarse.add(&room.residual, &mut room.correction);
        axpy(z, 1.0, &room.correction);
        room.subtract_image(&self.operator);
        self.smooth(z, room, false);
    }

    /// Smoothes z; the residual follows if it is still wanted.
    fn smooth(&self, z: &mut [f64], room: &mut Room, follow: bool) {
        let (a, b) = (self.largest / RATIO, self.largest);
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let mut rho = half / middle;
        self.jacobi.apply(&room.residual, &mut room.correction);
        scale(&mut room.correction, 1.0 / middle);
        for step in 1..=DEGREE {
            axpy(z, 1.0, &room.correction);
            let last = step == DEGREE;
            if last && !follow {
                return;
            }
            room.subtract_image(&self.operator);
            if last {
                return;
            }
            let next = 1.0 / (2.0 * middle / half - rho);
            self.jacobi.apply(&room.residual, &mut room.image);
            combine(
                next * rho,
                &mut room.correction,
                2.0 * next / half,
                &room.image,
            );
            rho = next;
        }
    }
}

impl Room {
    pub fn new<const N: usize>(operator: &Operator<N>) -> Self {
        let zero = vec![0.0; operator.skeleton.len()];
        Self {
            residual: zero.clone(),
            correction: zero.clone(),
            image: zero,
            operator: vec![0.0; operator.room()],
        }
    }

    /// The room of [`Operator::apply`].
    pub fn operator(&mut self) -> &mut [f64] {
        &mut self.operator
    }

    /// residual −= A correction.
    fn subtract_image<const N: usize>(&mut self, operator: &Operator<N>) {
        operator.apply(&self.correction, &mut self.image, &mut self.operator);
        axpy(&mut self.residual, -1.0, &self.image);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::norm::hhj::Hhj;
    use crate::norm::hhj::cell::eliminate;
    use crate::norm::iterative::skeleton::Skeleton;
    use std::sync::Arc;

    fn random(len: usize, seed: u64, operator: &Operator<3>) -> Vec<f64> {
        let mut random = SplitMix64::new(seed);
        let mut x: Vec<f64> = (0..len).map(|_| random.symmetric()).collect();
        let (hhj, skeleton) = (&operator.hhj, &operator.skeleton);
        for k in 0..3 {
            for simplex in (0..hhj.mesh().count(k)).filter(|&s| !hhj.mesh().is_interior(k, s)) {
                let first = skeleton.first(k, simplex);
                x[first..first + skeleton.widths[k]].fill(0.0);
            }
        }
        x
    }

    /// S by the cells' matrices, which the direct solver assembles.
    fn by_matrices(operator: &Operator<3>, x: &[f64]) -> Vec<f64> {
        let (hhj, skeleton) = (&operator.hhj, &operator.skeleton);
        let layout = hhj.layout();
        let mut y = vec![0.0; x.len()];
        for cell in 0..hhj.mesh().cell_count() {
            let mut energy = hhj.energy(cell);
            eliminate(&mut energy, layout.bubbles);
            let mut at = vec![0; layout.len];
            for b in &layout.blocks {
                let simplex = hhj.mesh().simplices_of(cell, b.k)[b.place] as usize;
                for i in 0..b.width {
                    at[b.start + i] = skeleton.first(b.k, simplex) + i;
                }
            }
            for i in layout.bubbles..layout.len {
                for j in layout.bubbles..layout.len {
                    y[at[i]] += energy[(i.max(j), i.min(j))] * x[at[j]];
                }
            }
        }
        for k in 0..3 {
            for simplex in (0..hhj.mesh().count(k)).filter(|&s| !hhj.mesh().is_interior(k, s)) {
                let first = skeleton.first(k, simplex);
                y[first..first + skeleton.widths[k]].fill(0.0);
            }
        }
        y
    }

    /// The operator is that of the matrices, and the cycle is symmetric and positive, for all degrees.
    #[test]
    fn symmetric_positive_definite() {
        let mesh = Mesh::<3>::cube(3).unwrap().perturbed(0.08, 5).unwrap();
        for degree in 2..=5 {
            let hhj = Arc::new(Hhj::new(&mesh, degree).unwrap());
            let skeleton = Arc::new(Skeleton::new(&mesh, degree));
            let jacobi = BlockJacobi::new(&hhj, &skeleton).unwrap();
            let coarse = Coarse::new(&hhj, &skeleton).unwrap();
            let cycle = Cycle::new(Operator::new(&hhj, &skeleton), jacobi, coarse);
            let operator = &cycle.operator;
            let mut room = Room::new(operator);
            let len = operator.skeleton.len();
            let vectors: Vec<_> = (0..4).map(|i| random(len, i, operator)).collect();
            let mut image = vec![0.0; len];
            operator.apply(&vectors[0], &mut image, room.operator());
            let expected = by_matrices(operator, &vectors[0]);
            let size = dot(&expected, &expected).sqrt();
            axpy(&mut image, -1.0, &expected);
            assert!(dot(&image, &image).sqrt() < 1e-13 * size, "degree {degree}");
            let images: Vec<Vec<f64>> = vectors
                .iter()
                .map(|r| {
                    let mut z = vec![0.0; len];
                    cycle.apply(r, &mut z, &mut room);
                    z
                })
                .collect();
            let square = |i: usize| dot(&vectors[i], &images[i]);
            for i in 0..4 {
                assert!(square(i) > 0.0, "degree {degree}: {}", square(i));
                for j in 0..i {
                    let difference = dot(&vectors[i], &images[j]) - dot(&vectors[j], &images[i]);
                    // Single precision in blocks and splines.
                    let scale = (square(i) * square(j)).sqrt();
                    assert!(
                        difference.abs() < 1e-5 * scale,
                        "degree {degree}: {difference:e}, {scale:e}"
                    );
                }
            }
        }
    }
}

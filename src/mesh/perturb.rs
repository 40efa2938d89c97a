//! Random displacement of the inner vertices.

use super::{Chart, Mesh};
use crate::Error;

/// SplitMix64 (Steele, Lea, Flood 2014): a fixed, documented stream for every seed, on every machine.
#[derive(Clone, Debug)]
pub struct SplitMix64(u64);

impl SplitMix64 {
    /// The stream of this seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// 64 random bits.
    pub fn next_u64(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [−1, 1).
    pub fn symmetric(&mut self) -> f64 {
        2.0 * ((self.next_u64() >> 11) as f64 / (1u64 << 53) as f64) - 1.0
    }
}

impl<const N: usize> Mesh<N> {
    /// Moves each coordinate of each interior vertex by a number drawn uniformly from [−`amplitude`, `amplitude`].
    ///
    /// # Errors
    /// If the vertices have no points in ℝ^N, or a cell is inverted by the move (it is named).
    pub fn perturbed(&self, amplitude: f64, seed: u64) -> Result<Self, Error> {
        let points = self
            .points()
            .ok_or(Error::NoCoordinates("a perturbation"))?;
        let mut random = SplitMix64::new(seed);
        let mut moved = points.to_vec();
        for vertex in self.interior(0) {
            for x in moved[vertex].iter_mut() {
                *x += amplitude * random.symmetric();
            }
        }
        let mut mesh = self.clone();
        mesh.chart = Chart::Vertices(moved.into());
        mesh.check_orientation()?;
        Ok(mesh)
    }

    /// The perturbation of the paper's section 5 for the cube (−1, 1)^N with 2^k cells a side:
    /// amplitude h̃ 2^{−(2N+1)/2} with h̃ = √N 2^{1−k}.
    ///
    /// # Errors
    /// As [`Mesh::perturbed`].
    pub fn perturbed_as_in_paper(&self, level: u32, seed: u64) -> Result<Self, Error> {
        let h = (N as f64).sqrt() * 2f64.powi(1 - level as i32);
        self.perturbed(h * 2f64.powf(-((2 * N + 1) as f64) / 2.0), seed)
    }
}

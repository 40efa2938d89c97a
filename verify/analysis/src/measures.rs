//! Floor 1. Measures of fixed sets: what they have of segments, and of a smooth metric's curvature.

use regge_curvature::density::omega;
use regge_curvature::formulas::PAPER;
use regge_curvature::jet::{Jet2, lower};
use regge_curvature::linalg::{Vector, vector};
use regge_curvature::mesh::SplitMix64;
use regge_curvature::metrics::SmoothTensor;
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::riemann::{Connection, Curvature};
use std::f64::consts::{PI, TAU};

/// R ω of a formula at a point of ℝ^N.
pub fn curvature_at<M: SmoothTensor<N>, const N: usize>(g: &M, x: &[f64; N]) -> f64 {
    let jets = g.at(&std::array::from_fn(|i| Jet2::coordinate(x[i], i)));
    let connection = Connection::new(&lower(&jets));
    Curvature::new(&jets, &connection).scalar() * omega(&PAPER, connection.det)
}

/// A convex set in (−1, 1)^N.
#[derive(Clone, Copy, Debug)]
pub enum Body<const N: usize> {
    /// Between two corners.
    Box([f64; N], [f64; N]),
    /// Centre and radius.
    Ball([f64; N], f64),
}

/// Points in a direction for integrals over a body: its curvature is smooth there.
const POINTS: usize = 16;

impl<const N: usize> Body<N> {
    /// So many boxes and as many balls, from a fixed stream.
    pub fn some(count: usize) -> Vec<Self> {
        let mut random = SplitMix64::new(20_261_128);
        let mut between = |a: f64, b: f64| a + (b - a) * 0.5 * (1.0 + random.symmetric());
        let mut all = Vec::new();
        for _ in 0..count {
            let low: [f64; N] = std::array::from_fn(|_| between(-0.9, 0.0));
            let high = low.map(|a| a + between(0.4, 0.9));
            all.push(Self::Box(low, high));
            let centre = std::array::from_fn(|_| between(-0.4, 0.4));
            all.push(Self::Ball(centre, between(0.3, 0.5)));
        }
        all
    }

    /// The share of a segment that is inside; of a point, 1 or 0.
    pub fn share(&self, ends: &[Vector<f64, N>]) -> f64 {
        let (a, d) = (ends[0], ends[ends.len() - 1] - ends[0]);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        match self {
            Self::Box(low, high) => {
                for i in 0..N {
                    // a + t d between low and high.
                    let (mut t, mut u) = ((low[i] - a[i]) / d[i], (high[i] - a[i]) / d[i]);
                    if d[i] == 0.0 {
                        let inside = (low[i]..high[i]).contains(&a[i]);
                        (t, u) = if inside { (0.0, 1.0) } else { (1.0, 0.0) };
                    } else if t > u {
                        (t, u) = (u, t);
                    }
                    (from, to) = (from.max(t), to.min(u));
                }
            }
            Self::Ball(centre, radius) => {
                let c = a - vector(|i| centre[i]);
                let (p, q) = (d.norm_squared(), c.norm_squared() - radius * radius);
                let half = c.dot(&d);
                let root = half * half - p * q;
                match (p == 0.0, root > 0.0) {
                    (true, _) => to = if q < 0.0 { 1.0 } else { 0.0 },
                    (false, false) => to = 0.0,
                    (false, true) => {
                        from = from.max((-half - root.sqrt()) / p);
                        to = to.min((-half + root.sqrt()) / p);
                    }
                }
            }
        }
        (to - from).max(0.0)
    }

    /// ∫ f over it, N = 2 or 3.
    pub fn integral(&self, f: &dyn Fn(&[f64; N]) -> f64) -> f64 {
        let (points, weights) = gauss_legendre(POINTS);
        let mut sum = 0.0;
        for mut index in 0..POINTS.pow(N as u32) {
            let mut weight = 1.0;
            let unit: [f64; N] = std::array::from_fn(|_| {
                let digit = index % POINTS;
                index /= POINTS;
                weight *= weights[digit];
                points[digit]
            });
            let (x, stretch) = self.place(unit);
            sum += weight * stretch * f(&x);
        }
        sum
    }

    /// The image of a point of the unit cube, and how much volume is stretched there.
    fn place(&self, unit: [f64; N]) -> ([f64; N], f64) {
        match self {
            Self::Box(low, high) => {
                let sides: [f64; N] = std::array::from_fn(|i| high[i] - low[i]);
                let x = std::array::from_fn(|i| low[i] + unit[i] * sides[i]);
                (x, sides.iter().product())
            }
            Self::Ball(centre, radius) => {
                let (r, angle) = (radius * unit[0], TAU * unit[1]);
                // Polar coordinates; in space the cosine of the second angle is uniform on spheres.
                let (across, up) = match N {
                    2 => (r, 0.0),
                    _ => {
                        let cosine = 2.0 * unit[N - 1] - 1.0;
                        (r * (1.0 - cosine * cosine).sqrt(), r * cosine)
                    }
                };
                let place = [across * angle.cos(), across * angle.sin(), up];
                let stretch = match N {
                    2 => TAU * radius * r,
                    _ => 4.0 * PI * radius * r * r,
                };
                (std::array::from_fn(|i| centre[i] + place[i]), stretch)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_have_their_volume_and_their_part_of_segments() {
        let ball = Body::<3>::Ball([0.1, 0.0, -0.2], 0.5);
        // The root in the second angle converges algebraically.
        assert!((ball.integral(&|_| 1.0) / (PI / 6.0) - 1.0).abs() < 1e-12);
        assert!((ball.integral(&|x| x[2] - x[0]) / (PI / 6.0) + 0.3).abs() < 1e-5);
        let disc = Body::<2>::Ball([0.0, 0.3], 0.5);
        assert!((disc.integral(&|x| x[1]) / (0.25 * PI) - 0.3).abs() < 1e-12);
        let share = ball.share(&[vector(|_| -0.9), vector(|_| 0.9)]);
        let along = |x: f64| (x - 0.1).powi(2) + x.powi(2) + (x + 0.2).powi(2) < 0.25;
        let seen = (0..10_000).filter(|i| along(-0.9 + 1.8 * (*i as f64 + 0.5) / 1e4));
        assert!((share - seen.count() as f64 / 1e4).abs() < 2e-4);
        let cube = Body::<2>::Box([0.0; 2], [0.5, 0.2]);
        assert!((cube.integral(&|_| 1.0) - 0.1).abs() < 1e-15);
        let ends: [Vector<f64, 2>; 2] = [vector(|_| -0.1), vector(|_| 0.4)];
        assert!((cube.share(&ends) - 0.4).abs() < 1e-14);
        assert_eq!(cube.share(&[vector(|_| 0.1)]), 1.0);
        assert_eq!(disc.share(&[vector(|_| 0.9)]), 0.0);
    }
}

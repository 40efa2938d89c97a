//! Floor 0. What is measured: numbers over levels, run by run, and the order that is fitted to them.

use regge_study::slope;
use serde::Serialize;

/// A quantity over levels of refinement, or of degree, in several runs (random meshes, random fields).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    /// What the levels are: `1/h`, `degree`.
    pub axis: &'static str,
    /// The levels, ascending.
    pub levels: Vec<f64>,
    /// The values of each run, level by level.
    pub runs: Vec<Vec<f64>>,
}

/// Over so many of the last levels an order is fitted.
pub const FITTED: usize = 3;

impl Series {
    /// Values over 1/h.
    pub fn over_h(points: &[Vec<(f64, f64)>]) -> Self {
        Self::over("1/h", points, |h| 1.0 / h)
    }

    /// Values over 1/ε, ε the width of a layer.
    pub fn over_width(points: &[Vec<(f64, f64)>]) -> Self {
        Self::over("1/ε", points, |epsilon| 1.0 / epsilon)
    }

    /// Values over a polynomial degree.
    pub fn over_degree(points: &[Vec<(f64, f64)>]) -> Self {
        Self::over("degree", points, |p| p)
    }

    fn over(axis: &'static str, points: &[Vec<(f64, f64)>], level: fn(f64) -> f64) -> Self {
        let runs = points.iter().map(|run| run.iter().map(|p| p.1).collect());
        // The meshes of the runs are random: their sizes differ in the second digit, and the mean stands for them.
        let levels = (0..points[0].len()).map(|i| {
            let sum: f64 = points.iter().map(|run| level(run[i].0)).sum();
            sum / points.len() as f64
        });
        Self {
            axis,
            levels: levels.collect(),
            runs: runs.collect(),
        }
    }

    /// Values without levels: samples of one kind.
    pub fn samples(values: Vec<f64>) -> Self {
        let levels = (0..values.len()).map(|i| (i + 1) as f64).collect();
        Self {
            axis: "sample",
            levels,
            runs: vec![values],
        }
    }

    /// Every value divided by the one of another series of the same shape.
    pub fn over_series(&self, other: &Self) -> Self {
        let run = |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).map(|(a, b)| a / b).collect();
        Self {
            runs: self.runs.iter().zip(&other.runs).map(run).collect(),
            ..self.clone()
        }
    }

    /// Every value times a factor.
    pub fn times(&self, factor: f64) -> Self {
        let run = |run: &Vec<f64>| run.iter().map(|x| factor * x).collect();
        Self {
            runs: self.runs.iter().map(run).collect(),
            ..self.clone()
        }
    }

    /// Every value over a power of h, by the levels 1/h: what a claim would have with so many more powers of h.
    pub fn over_h_power(&self, power: i32) -> Self {
        let run = |run: &Vec<f64>| {
            let all = run.iter().zip(&self.levels);
            all.map(|(x, level)| x * level.powi(power)).collect()
        };
        Self {
            runs: self.runs.iter().map(run).collect(),
            ..self.clone()
        }
    }

    /// The greatest value of all.
    pub fn greatest(&self) -> f64 {
        let all = self.runs.iter().flatten();
        all.fold(f64::NEG_INFINITY, |max, x| max.max(*x))
    }

    /// By which power of the level the values of a run grow at its end: the slope over the last [`FITTED`] levels.
    fn growth_of(&self, run: &[f64]) -> f64 {
        let points: Vec<(f64, f64)> = self
            .levels
            .iter()
            .copied()
            .zip(run.iter().copied())
            .collect();
        let last = points.len().saturating_sub(FITTED);
        slope(&points[last..]).unwrap_or(f64::NAN)
    }

    /// The mean over the runs of the power by which values grow, and the difference of the greatest and the least.
    pub fn growth(&self) -> (f64, f64) {
        let all: Vec<f64> = self.runs.iter().map(|run| self.growth_of(run)).collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let (low, high) = (all.iter()).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
            (l.min(*x), h.max(*x))
        });
        (mean, high - low)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_is_that_of_the_end() {
        // Of order 2 from the second level on.
        let run = |c: f64| vec![(1.0, 9.0), (0.5, c), (0.25, c / 4.0), (0.125, c / 16.0)];
        let (growth, spread) = Series::over_h(&[run(1.0), run(5.0)]).growth();
        assert!((growth + 2.0).abs() < 1e-12 && spread.abs() < 1e-12);
    }
}

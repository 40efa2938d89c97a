//! Splines in one coordinate.

use nalgebra::DMatrix;
use regge_curvature::jet::Jet2;
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::scalar::Real;

/// The splines in one coordinate: piecewise polynomials of a degree, continuous with their first derivative, clamped at both ends.
#[derive(Clone, Debug)]
pub struct Line {
    /// The knots, ascending.
    pub grid: Vec<f64>,
    /// Of degree 2 the B-splines; of degree 3 and more Hermite's cubics at the knots, and in each interval what vanishes at its ends with
    /// its derivative.
    pub degree: usize,
}

impl Line {
    pub fn intervals(&self) -> usize {
        self.grid.len() - 1
    }

    /// How many there are on an interval, with those that the clamp takes away.
    pub fn on_one(&self) -> usize {
        if self.degree == 2 { 3 } else { self.degree + 1 }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.intervals() * (self.degree - 1) - 2
    }

    /// The number of the k-th on an interval, if it is there.
    pub fn number(&self, interval: usize, k: usize) -> Option<usize> {
        if self.degree == 2 {
            let number = (interval + k).checked_sub(2);
            return number.filter(|j| *j < self.len());
        }
        // In each interval first its own ones, then the two of its right end.
        let (stride, own) = (self.degree - 1, self.degree - 3);
        match k {
            0 | 1 => Some(interval.checked_sub(1)? * stride + own + k),
            2 | 3 if interval + 1 < self.intervals() => Some(interval * stride + own + k - 2),
            2 | 3 => None,
            _ => Some(interval * stride + k - 4),
        }
    }

    /// Those on an interval at x, with two derivatives.
    pub fn at(&self, interval: usize, x: f64) -> Vec<[f64; 3]> {
        if self.degree == 2 {
            return pieces(&self.grid, interval, x).to_vec();
        }
        let (a, size) = (
            self.grid[interval],
            self.grid[interval + 1] - self.grid[interval],
        );
        let t = Jet2::<f64, 1>::coordinate((x - a) / size, 0);
        let [one, two, three] = [1.0, 2.0, 3.0].map(Jet2::from_f64);
        let (left, bulge) = (one - t, t * t * (one - t) * (one - t));
        let mut all = vec![
            left * left * (one + two * t),
            t * left * left * Jet2::from_f64(size),
            t * t * (three - two * t),
            -(t * t * left) * Jet2::from_f64(size),
        ];
        let middle = two * t - one;
        all.extend((0..self.degree - 3).map(|m| (0..m).fold(bulge, |power, _| power * middle)));
        let scaled = |v: Jet2<f64, 1>| [v.value, v.d[0] / size, v.dd[0][0] / (size * size)];
        all.into_iter().map(scaled).collect()
    }

    /// ∫ of products of derivatives of order a, a = 0, 1, 2, over an interval.
    pub fn products(&self, interval: usize) -> [DMatrix<f64>; 3] {
        let (points, weights) = gauss_legendre(self.degree + 1);
        let (a, size) = (
            self.grid[interval],
            self.grid[interval + 1] - self.grid[interval],
        );
        let all: Vec<_> = (points.iter())
            .map(|t| self.at(interval, a + t * size))
            .collect();
        let count = self.on_one();
        std::array::from_fn(|order| {
            DMatrix::from_fn(count, count, |k, l| {
                let at = all.iter().zip(&weights);
                at.map(|(v, w)| w * size * v[k][order] * v[l][order]).sum()
            })
        })
    }
}

/// On one interval: x ↦ the three splines that are not zero there, with two derivatives.
fn pieces(grid: &[f64], interval: usize, x: f64) -> [[f64; 3]; 3] {
    std::array::from_fn(|k| match (interval + k).checked_sub(2) {
        Some(first) if first + 3 < grid.len() => spline(&grid[first..first + 4], x, 2 - k),
        _ => [0.0; 3],
    })
}

/// The quadratic B-spline of four knots in its first, second or third interval: value, first and second derivative.
fn spline(t: &[f64], x: f64, interval: usize) -> [f64; 3] {
    let (a, b) = ((t[2] - t[0]) * (t[1] - t[0]), (t[3] - t[1]) * (t[3] - t[2]));
    let rising = [(x - t[0]).powi(2) / a, 2.0 * (x - t[0]) / a, 2.0 / a];
    let falling = [(t[3] - x).powi(2) / b, -2.0 * (t[3] - x) / b, 2.0 / b];
    match interval {
        0 => rising,
        2 => falling,
        _ => {
            // What makes the rising parabola continuously differentiable with the falling one.
            let c = (1.0 / (t[1] - t[0]) + 1.0 / (t[3] - t[1])) / (t[2] - t[1]);
            let d = x - t[1];
            [
                rising[0] - c * d * d,
                rising[1] - 2.0 * c * d,
                rising[2] - 2.0 * c,
            ]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::best::{Form, HELD, is_certified};

    /// A spline and its derivative are continuous at the knots, and its second derivative is that of the pieces.
    #[test]
    fn splines_are_continuously_differentiable() {
        let t = [0.0, 0.3, 1.0, 1.2];
        for (left, right, x) in [(0, 1, 0.3), (1, 2, 1.0)] {
            let (a, b) = (spline(&t, x, left), spline(&t, x, right));
            assert!(
                (a[0] - b[0]).abs() < 1e-14 && (a[1] - b[1]).abs() < 1e-13,
                "{a:?} {b:?}"
            );
        }
        assert_eq!(spline(&t, 0.0, 0)[..2], [0.0, 0.0]);
        assert_eq!(spline(&t, 1.2, 2)[..2], [0.0, 0.0]);
        let [plus, minus] = [0.501, 0.499].map(|x| spline(&t, x, 1)[0]);
        let slope = spline(&t, 0.5, 1)[1];
        assert!(((plus - minus) / 0.002 - slope).abs() < 1e-10);
    }

    /// Every function of every degree is zero with its derivative at the ends and does not jump, nor does its derivative.
    #[test]
    fn lines_are_clamped_and_continuously_differentiable() {
        for degree in 2..6 {
            let line = Line {
                grid: vec![-1.0, -0.4, 0.1, 0.7, 1.0],
                degree,
            };
            let at = |interval: usize, x: f64| {
                let mut all = vec![[0.0; 2]; line.len()];
                for (k, v) in line.at(interval, x).into_iter().enumerate() {
                    if let Some(number) = line.number(interval, k) {
                        all[number] = [v[0], v[1]];
                    }
                }
                all.concat()
            };
            let zero = |list: Vec<f64>| list.iter().all(|x| x.abs() < 1e-12);
            assert!(zero(at(0, -1.0)) && zero(at(3, 1.0)), "degree {degree}");
            for interval in 0..3 {
                let x = line.grid[interval + 1];
                let apart = at(interval, x).into_iter().zip(at(interval + 1, x));
                assert!(zero(apart.map(|(a, b)| a - b).collect()), "degree {degree}");
            }
            // They are independent.
            let mut form = Form::zero(line.len());
            for interval in 0..line.intervals() {
                let all = (0..line.on_one()).map(|k| line.number(interval, k).unwrap_or(HELD));
                form.add(&all.collect::<Vec<_>>(), &line.products(interval)[0]);
            }
            assert!(is_certified(&Form::zero(line.len()), &form, 1.0).unwrap());
        }
    }
}

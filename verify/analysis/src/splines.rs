//! Floor 1. Clamped splines: functions of H²_0 that are polynomials on every cell of a cube's mesh.
//!
//! Products of quadratic C¹ splines in the coordinates, on the grid that the cubes are made of. They and their first derivatives
//! vanish on the boundary, so that a functional tested with them is bounded by its H⁻² norm from below, whatever else is
//! known of that norm.

use nalgebra::{DMatrix, DVector};
use regge_curvature::Error;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::Vector;
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::simplex::Points;
use regge_curvature::spaces::Lagrange;

/// The tensor products of the splines of one grid.
#[derive(Clone, Debug)]
pub struct Clamped<const N: usize> {
    /// The grid in each coordinate, ascending.
    grids: [Vec<f64>; N],
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

impl<const N: usize> Clamped<N> {
    /// The splines of these grids, each of at least four knots.
    pub fn new(grids: [Vec<f64>; N]) -> Self {
        Self { grids }
    }

    /// How many in each coordinate.
    fn sides(&self) -> [usize; N] {
        std::array::from_fn(|i| self.grids[i].len() - 3)
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.sides().iter().product()
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// ∫ of products of derivatives of orders (a, a) of the splines in one coordinate, a = 0, 1, 2.
    fn in_one(&self, i: usize) -> [DMatrix<f64>; 3] {
        let (grid, count) = (&self.grids[i], self.grids[i].len() - 3);
        let (points, weights) = gauss_legendre(3);
        let mut all = std::array::from_fn(|_| DMatrix::zeros(count, count));
        for (interval, ends) in grid.windows(2).enumerate() {
            for (point, weight) in points.iter().zip(&weights) {
                let x = ends[0] + point * (ends[1] - ends[0]);
                let here = pieces(grid, interval, x);
                for (k, one) in here.iter().enumerate() {
                    for (l, two) in here.iter().enumerate() {
                        let place = |k: usize| (interval + k).checked_sub(2).filter(|j| *j < count);
                        if let (Some(a), Some(b)) = (place(k), place(l)) {
                            for (order, matrix) in all.iter_mut().enumerate() {
                                let product = one[order] * two[order];
                                matrix[(a, b)] += weight * (ends[1] - ends[0]) * product;
                            }
                        }
                    }
                }
            }
        }
        all
    }

    /// The matrix of Σ |∂^α v|² over all derivatives of these orders, mixed ones as often as they are there in the tensor.
    pub fn norm(&self, orders: &[usize]) -> DMatrix<f64> {
        let one: [[DMatrix<f64>; 3]; N] = std::array::from_fn(|i| self.in_one(i));
        let mut sum = DMatrix::zeros(self.len(), self.len());
        for &order in orders {
            // All lists of so many coordinates.
            for mut list in 0..N.pow(order as u32) {
                let mut alpha = [0; N];
                for _ in 0..order {
                    alpha[list % N] += 1;
                    list /= N;
                }
                // The first coordinate runs fastest.
                let product = (0..N).fold(DMatrix::identity(1, 1), |product, i| {
                    one[i][alpha[i]].kronecker(&product)
                });
                sum += product;
            }
        }
        sum
    }

    /// f(v) of every spline, from f(φ) of the basis functions of a Lagrange space that contains them (degree 2N at least) on the mesh
    /// of the grid, cubes cut into simplices.
    ///
    /// # Errors
    /// If the mesh has no coordinates.
    pub fn loads(&self, space: &Lagrange<N>, load: &[f64]) -> Result<Vec<f64>, Error> {
        let (mesh, basis) = (space.mesh(), space.basis(N));
        let share = |a: &usize| *a as f64 / space.degree() as f64;
        let lambda: Vec<f64> = basis.exponents().iter().flatten().map(share).collect();
        let points = Points::new(N + 1, lambda);
        let rows = basis.tabulate::<f64>(&points);
        let values = DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j]);
        let inverse = (values.try_inverse()).expect("polynomials are determined on their lattice");
        let mut taken = vec![false; space.len()];
        let mut all = vec![0.0; self.len()];
        for cell in 0..mesh.cell_count() {
            let corners: Option<Vec<Vector<f64, N>>> =
                (0..=N).map(|i| mesh.corner(cell, i)).collect();
            let corners = corners.ok_or(Error::NoCoordinates("a spline"))?;
            let centre = corners.iter().sum::<Vector<f64, N>>() / (N + 1) as f64;
            let box_ = self.box_of(&centre);
            // A function counts where it is met first: splines that are zero in that cell are zero on all of its faces.
            let first: Vec<f64> = space
                .cell_dofs(cell)
                .map(|dof| {
                    if std::mem::replace(&mut taken[dof], true) {
                        0.0
                    } else {
                        load[dof]
                    }
                })
                .collect();
            let dual = inverse.tr_mul(&DVector::from_vec(first));
            for (point, factor) in dual.iter().enumerate() {
                let corners = corners.iter().zip(points.lambda(point));
                let x: Vector<f64, N> = corners.map(|(c, l)| c * *l).sum();
                self.add_values(box_, &x, *factor, &mut all);
            }
        }
        Ok(all)
    }

    /// In which box of the grid a point is.
    pub fn box_of(&self, x: &Vector<f64, N>) -> [usize; N] {
        std::array::from_fn(|i| {
            let right = self.grids[i].iter().position(|t| *t > x[i]);
            right.expect("the mesh is in the grid") - 1
        })
    }

    /// The splines on a box: their numbers, none for those that are not there.
    pub fn on_box(&self, box_: [usize; N]) -> Vec<Option<usize>> {
        let sides = self.sides();
        let number = |mut index: usize| {
            let (mut place, mut stride) = (0, 1);
            for i in 0..N {
                let j = (box_[i] + index % 3)
                    .checked_sub(2)
                    .filter(|j| *j < sides[i])?;
                index /= 3;
                place += stride * j;
                stride *= sides[i];
            }
            Some(place)
        };
        (0..3_usize.pow(N as u32)).map(number).collect()
    }

    /// The same splines at a point of the box: derivatives in the coordinates of ℝ^N.
    pub fn jets(&self, box_: [usize; N], x: &Vector<f64, N>) -> Vec<Jet2<f64, N>> {
        let one: [[[f64; 3]; 3]; N] =
            std::array::from_fn(|i| pieces(&self.grids[i], box_[i], x[i]));
        let product = |index: usize, orders: [usize; N]| -> f64 {
            (0..N)
                .map(|i| one[i][index / 3_usize.pow(i as u32) % 3][orders[i]])
                .product()
        };
        let jet = |index: usize| {
            let of = |ones: &[usize]| {
                product(
                    index,
                    std::array::from_fn(|i| ones.iter().filter(|o| **o == i).count()),
                )
            };
            Jet2 {
                value: of(&[]),
                d: std::array::from_fn(|m| of(&[m])),
                dd: std::array::from_fn(|m| std::array::from_fn(|n| of(&[m, n]))),
            }
        };
        (0..3_usize.pow(N as u32)).map(jet).collect()
    }

    /// Adds a multiple of the values at a point of a box of the grid.
    fn add_values(&self, box_: [usize; N], x: &Vector<f64, N>, factor: f64, all: &mut [f64]) {
        let one: [[[f64; 3]; 3]; N] =
            std::array::from_fn(|i| pieces(&self.grids[i], box_[i], x[i]));
        for (index, number) in self.on_box(box_).into_iter().enumerate() {
            if let Some(number) = number {
                let values = (0..N).map(|i| one[i][index / 3_usize.pow(i as u32) % 3][0]);
                all[number] += factor * values.product::<f64>();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
}

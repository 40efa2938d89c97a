//! Floor 2. A metric that is smooth on the four quadrants around a hinge, and smooth metrics near it.

use regge_curvature::Error;
use regge_curvature::field::{Evaluate, TensorField};
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, matrix, symmetric};
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{AffineMap, Smooth, SmoothTensor};
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::scalar::{Number, Real};
use regge_curvature::simplex::Points;

/// The metric on the quadrant where the first two coordinates have these signs; N = 3 or more. Its tangential-tangential components
/// are single-valued where two quadrants meet, the others jump.
#[derive(Clone, Copy, Debug)]
pub struct Quadrant {
    signs: [f64; 2],
    /// The same on all of the quadrant, or changing.
    is_constant: bool,
}

impl<const N: usize> SmoothTensor<N> for Quadrant {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        let c = S::from_f64;
        let [s, t] = self.signs;
        let along = |i: usize| if self.is_constant { S::zero() } else { x[i] };
        // |x| and |y|, which are continuous.
        let (kink_x, kink_y) = (c(s) * along(0), c(t) * along(1));
        let last = along(N - 1);
        symmetric(|i, j| match (i.min(j), i.max(j)) {
            (0, 0) => c(1.2 + 0.2 * s) + c(0.15) * kink_y - c(0.1) * last + c(0.1) * along(0),
            (0, 1) => c(0.1 + 0.15 * s - 0.1 * t + 0.1 * s * t) + c(0.1) * last,
            (1, 1) => c(1.1 + 0.2 * t) + c(0.2) * kink_x + c(0.1) * along(0) * last,
            (0, _) => c(-0.05 + 0.1 * s) + c(0.1) * kink_y,
            (1, _) => c(0.1 + 0.1 * t) + c(0.1) * kink_x,
            _ if i == j => c(1.0) + c(0.1) * along(0) + c(0.15) * kink_x + c(0.1) * kink_y,
            _ => c(0.05),
        })
    }
}

/// Which of the four quadrants.
fn quadrants(is_constant: bool) -> [Quadrant; 4] {
    [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]]
        .map(|signs| Quadrant { signs, is_constant })
}

/// The four metrics on a mesh whose cells lie in one quadrant each.
pub struct Quadrants<const N: usize> {
    parts: [Smooth<Quadrant, N>; 4],
    /// By cell.
    which: Vec<usize>,
}

impl<const N: usize> Quadrants<N> {
    /// On a mesh with coordinates.
    ///
    /// # Errors
    /// If it has none.
    pub fn new(mesh: &Mesh<N>, is_constant: bool) -> Result<Self, Error> {
        let [a, b, c, d] = quadrants(is_constant).map(|part| Smooth::new(mesh, part));
        let side = |cell: usize, i: usize| {
            let corners = (0..=N).filter_map(|k| mesh.corner(cell, k));
            usize::from(corners.map(|x| x[i]).sum::<f64>() > 0.0)
        };
        Ok(Self {
            parts: [a?, b?, c?, d?],
            which: (0..mesh.cell_count())
                .map(|cell| side(cell, 0) + 2 * side(cell, 1))
                .collect(),
        })
    }
}

impl<T: Real, const N: usize> Evaluate<T, N> for Quadrants<N> {
    type Table = Vec<[T; N]>;
    type Local = (usize, AffineMap<N>);

    fn tabulate(&self, points: &Points) -> Self::Table {
        self.parts[0].tabulate(points)
    }

    fn on_cell(&self, cell: usize) -> Self::Local {
        let map = Evaluate::<T, N>::on_cell(&self.parts[0], cell);
        (self.which[cell], map)
    }

    fn jet2(&self, at: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        self.parts[at.0].jet2(&at.1, table, block)
    }

    fn jet1(&self, at: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        self.parts[at.0].jet1(&at.1, table, block)
    }

    fn value(&self, at: &Self::Local, table: &Self::Table, block: usize) -> Mat<T, N> {
        self.parts[at.0].value(&at.1, table, block)
    }
}

impl<const N: usize> TensorField<N> for Quadrants<N> {
    type Scalar = f64;
    type Wide = <f64 as Number>::Wide;
}

/// A smooth metric: the four of the quadrants, blended in layers of width 2ε where they meet.
#[derive(Clone, Copy, Debug)]
pub struct Mollified {
    is_constant: bool,
    epsilon: f64,
    /// In each of the first two coordinates: below the layer, in it, above it.
    place: [Place; 2],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    Below,
    Layer,
    Above,
}

impl<const N: usize> SmoothTensor<N> for Mollified {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        let share: [S; 2] = std::array::from_fn(|i| match self.place[i] {
            Place::Below => S::zero(),
            Place::Above => S::one(),
            Place::Layer => step(S::from_f64(0.5) * (x[i] / S::from_f64(self.epsilon) + S::one())),
        });
        let parts: [(S, Mat<S, N>); 4] = quadrants(self.is_constant).map(|part| {
            let [a, b]: [S; 2] = std::array::from_fn(|i| match part.signs[i] > 0.0 {
                true => share[i],
                false => S::one() - share[i],
            });
            (a * b, part.at(x))
        });
        matrix(|i, j| {
            let sum = |sum: S, (weight, part): &(S, Mat<S, N>)| sum + *weight * part[(i, j)];
            parts.iter().fold(S::zero(), sum)
        })
    }
}

/// From 0 at 0 to 1 at 1, with three derivatives that vanish at both.
fn step<S: Real>(t: S) -> S {
    let c = S::from_f64;
    let (t2, t4) = (t * t, t * t * t * t);
    t4 * (c(35.0) - c(84.0) * t + c(70.0) * t2 - c(20.0) * t2 * t)
}

/// ∫ f over (−1, 1)^N for the mollified metric of width ε, given to f with the point: Gauss's rule on each piece.
pub fn integral<const N: usize>(
    epsilon: f64,
    is_constant: bool,
    points: usize,
    f: &dyn Fn(&Mollified, &[f64; N]) -> f64,
) -> f64 {
    let (gauss, weights) = gauss_legendre(points);
    let pieces = [
        (Place::Below, -1.0, -epsilon),
        (Place::Layer, -epsilon, epsilon),
        (Place::Above, epsilon, 1.0),
    ];
    let mut sum = 0.0;
    for (first, a, b) in pieces {
        for (second, c, d) in pieces {
            let metric = Mollified {
                is_constant,
                epsilon,
                place: [first, second],
            };
            for mut index in 0..points.pow(N as u32) {
                let mut weight = 1.0;
                let x: [f64; N] = std::array::from_fn(|i| {
                    let (low, high) = [(a, b), (c, d), (-1.0, 1.0)][i.min(2)];
                    let digit = index % points;
                    index /= points;
                    weight *= weights[digit] * (high - low);
                    low + gauss[digit] * (high - low)
                });
                sum += weight * f(&metric, &x);
            }
        }
    }
    sum
}

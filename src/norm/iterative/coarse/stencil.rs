//! The value and gradient of a tensor-product cubic spline at a point, and the transpose.

use super::spline::{slopes, values};
use crate::linalg::Vector;

/// The precision of the correction: a preconditioner needs no more.
pub(super) type Short = f32;

/// 4^(N−1) for the largest N.
const ROWS: usize = 16;

/// The splines' lattice.
#[derive(Clone, Debug)]
pub(super) struct Grid<const N: usize> {
    /// How many coefficients along each axis: three more than cells.
    pub sides: [usize; N],
    /// The corner with the least coordinates.
    pub lower: Vector<f64, N>,
    /// How many cells to a unit of length, by axis.
    pub density: Vector<f64, N>,
}

impl<const N: usize> Grid<N> {
    /// How many coefficients.
    pub fn len(&self) -> usize {
        self.sides.iter().product()
    }

    /// How many coefficients a plane across the last axis.
    pub fn plane(&self) -> usize {
        self.len() / self.sides[N - 1]
    }

    /// The coefficients along an axis that make the splines between two places: the first one, and the one behind the last.
    pub fn span(&self, axis: usize, from: f64, to: f64) -> (usize, usize) {
        let cell = |x: f64| (x.max(0.0) as usize).min(self.sides[axis] - 4);
        let place = |x: f64| (x - self.lower[axis]) * self.density[axis];
        (cell(place(from) - ROUNDING), cell(place(to) + ROUNDING) + 4)
    }
}

/// How far, in cells, rounding may bring a point across a plane between two cells.
const ROUNDING: f64 = 1e-6;

/// A value and a gradient at a point, or what is dual to them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jet<const N: usize> {
    pub value: Short,
    pub gradient: [Short; N],
}

impl<const N: usize> Jet<N> {
    pub const ZERO: Self = Self {
        value: 0.0,
        gradient: [0.0; N],
    };
}

/// Where a point is in the splines' lattice: what multiplies the rows of four coefficients along the first axis.
pub(super) struct Stencil<const N: usize> {
    /// The first coefficient of the first row, and how far the others are from it.
    first: usize,
    offsets: [usize; ROWS],
    /// Along the first axis: values and slopes.
    along: [[Short; 4]; 2],
    /// Across: `[0]` the product of the other axes' values, `[i]` with axis i's value replaced by its slope.
    across: [[Short; ROWS]; N],
}

impl<const N: usize> Stencil<N> {
    /// How many rows there are.
    const COUNT: usize = 1 << (2 * (N - 1));

    pub fn new(grid: &Grid<N>) -> Self {
        let mut offsets = [0; ROWS];
        for (row, offset) in offsets.iter_mut().enumerate() {
            let (mut stride, mut digits) = (1, row);
            for side in &grid.sides[..N - 1] {
                stride *= side;
                *offset += digits % 4 * stride;
                digits /= 4;
            }
        }
        Self {
            first: 0,
            offsets,
            along: [[0.0; 4]; 2],
            across: [[1.0; ROWS]; N],
        }
    }

    /// Moves it to a point of a box whose first spline is given.
    #[inline]
    pub fn place(&mut self, grid: &Grid<N>, first: usize, at: &[Short; N]) {
        self.first = first;
        let mut count = 1;
        for across in &mut self.across {
            across[0] = 1.0;
        }
        for axis in 0..N {
            let (f, density) = (f64::from(at[axis]), grid.density[axis]);
            let value = values(f).map(|x| x as Short);
            let slope = slopes(f).map(|x| (x * density) as Short);
            if axis == 0 {
                self.along = [value, slope];
            } else {
                self.cross(axis, count, value, slope);
                count *= 4;
            }
        }
    }

    /// Goes from `count` rows to four times as many: one more axis.
    #[inline(always)]
    fn cross(&mut self, axis: usize, count: usize, value: [Short; 4], slope: [Short; 4]) {
        // From the last to the first: row 0 is still needed.
        for i in (0..4).rev() {
            for row in 0..count {
                for other in 0..N {
                    let factor = if other == axis { slope[i] } else { value[i] };
                    self.across[other][i * count + row] = factor * self.across[other][row];
                }
            }
        }
    }

    /// s and its gradient.
    #[inline]
    pub fn evaluate(&self, c: &[Short]) -> Jet<N> {
        let mut sums = [[0.0; 4]; N];
        for row in 0..Self::COUNT {
            let from = self.first + self.offsets[row];
            let c: &[Short] = &c[from..from + 4];
            for (sum, across) in sums.iter_mut().zip(&self.across) {
                for x in 0..4 {
                    sum[x] += across[row] * c[x];
                }
            }
        }
        let along = |sum: &[Short; 4], w: &[Short; 4]| {
            sum[0] * w[0] + sum[1] * w[1] + (sum[2] * w[2] + sum[3] * w[3])
        };
        let gradient = std::array::from_fn(|i| match i {
            0 => along(&sums[0], &self.along[1]),
            _ => along(&sums[i], &self.along[0]),
        });
        Jet {
            value: along(&sums[0], &self.along[0]),
            gradient,
        }
    }

    /// The transpose of [`Stencil::evaluate`].
    #[inline]
    pub fn spread(&self, Jet { value, gradient }: Jet<N>, c: &mut [Short]) {
        let first: [Short; 4] =
            std::array::from_fn(|x| value * self.along[0][x] + gradient[0] * self.along[1][x]);
        for row in 0..Self::COUNT {
            let across: Short = (1..N).map(|i| gradient[i] * self.across[i][row]).sum();
            let from = self.first + self.offsets[row];
            let c = &mut c[from..from + 4];
            for x in 0..4 {
                c[x] += self.across[0][row] * first[x] + across * self.along[0][x];
            }
        }
    }
}

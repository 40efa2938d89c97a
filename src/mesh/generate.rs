//! Meshes made from nothing: Freudenthal's cube and torus, the boundary of a simplex, Alfeld's split.

use super::Mesh;
use crate::Error;
use crate::linalg::Vector;

/// All permutations of 0…n−1.
fn permutations(n: usize) -> Vec<Vec<usize>> {
    if n == 0 {
        return vec![vec![]];
    }
    let shorter = permutations(n - 1);
    (0..n)
        .flat_map(|place| {
            shorter.iter().map(move |p| {
                let mut p = p.clone();
                p.insert(place, n - 1);
                p
            })
        })
        .collect()
}

/// Visits the grid {0…size−1}^N.
fn grid<const N: usize>(size: usize) -> impl Iterator<Item = [usize; N]> {
    (0..size.pow(N as u32)).map(move |mut index| {
        std::array::from_fn(|_| {
            let digit = index % size;
            index /= size;
            digit
        })
    })
}

/// The N! Freudenthal simplices of the unit cube: corners from 0 to (1…1) along a permutation of the axes.
fn freudenthal<const N: usize>() -> Vec<Vec<[usize; N]>> {
    permutations(N)
        .into_iter()
        .map(|axes| {
            let mut corner = [0; N];
            let mut corners = vec![corner];
            for axis in axes {
                corner[axis] += 1;
                corners.push(corner);
            }
            corners
        })
        .collect()
}

/// The index of a grid point when there are `size` points a side, coordinates modulo `size`.
fn index<const N: usize>(point: [usize; N], size: usize) -> usize {
    point
        .iter()
        .rev()
        .fold(0, |index, x| index * size + x % size)
}

impl<const N: usize> Mesh<N> {
    /// (−1, 1)^N cut into `side`^N cubes of N! simplices each.
    ///
    /// # Errors
    /// If `side` is 0 or the mesh would be too large.
    pub fn cube(side: usize) -> Result<Self, Error> {
        let points = grid::<N>(side + 1)
            .map(|p| Vector::from_fn(|i, _| -1.0 + 2.0 * p[i] as f64 / side as f64))
            .collect();
        let mut cells = Vec::new();
        for base in grid::<N>(side) {
            for simplex in freudenthal::<N>() {
                let shift =
                    |c: [usize; N]| -> [usize; N] { std::array::from_fn(|i| base[i] + c[i]) };
                cells.push(
                    simplex
                        .into_iter()
                        .map(|c| index(shift(c), side + 1))
                        .collect(),
                );
            }
        }
        Self::new(points, &cells)
    }

    /// ℝ^N / 2ℤ^N, the cube with opposite faces identified, `side` ≥ 3 cubes a direction.
    ///
    /// # Errors
    /// If `side` < 3: two cells would have the same vertices, which a simplicial complex does not allow.
    pub fn torus(side: usize) -> Result<Self, Error> {
        if side < 3 {
            return Err(Error::Input(format!(
                "a simplicial torus needs 3 cubes a side, not {side}"
            )));
        }
        let (mut cells, mut corners) = (Vec::new(), Vec::new());
        for base in grid::<N>(side) {
            for simplex in freudenthal::<N>() {
                let shift =
                    |c: [usize; N]| -> [usize; N] { std::array::from_fn(|i| base[i] + c[i]) };
                cells.push(simplex.iter().map(|&c| index(shift(c), side)).collect());
                let place = |c: [usize; N]| {
                    Vector::from_fn(|i, _| -1.0 + 2.0 * shift(c)[i] as f64 / side as f64)
                };
                corners.push(simplex.into_iter().map(place).collect());
            }
        }
        Self::with_cell_charts(side.pow(N as u32), &cells, &corners)
    }

    /// ∂Δ^{N+1}: the sphere as the boundary of one simplex, without coordinates.
    ///
    /// # Errors
    /// If N < 2.
    pub fn simplex_boundary() -> Result<Self, Error> {
        let cells: Vec<Vec<usize>> = (0..N + 2)
            .map(|out| (0..N + 2).filter(|&v| v != out).collect())
            .collect();
        Self::new_abstract(N + 2, &cells)
    }

    /// The reference simplex, alone.
    ///
    /// # Errors
    /// If N < 2.
    pub fn single() -> Result<Self, Error> {
        Self::new(reference_points(), &[(0..=N).collect()])
    }

    /// The reference simplex cut into N+1 cells at its barycentre, which is vertex N+1.
    ///
    /// # Errors
    /// If N < 2.
    pub fn alfeld() -> Result<Self, Error> {
        let mut points = reference_points();
        points.push(Vector::from_element(1.0 / (N + 1) as f64));
        let cells: Vec<Vec<usize>> = (0..=N)
            .map(|out| (0..N + 2).filter(|&v| v != out).collect())
            .collect();
        Self::new(points, &cells)
    }
}

/// The origin and the N unit points.
fn reference_points<const N: usize>() -> Vec<Vector<f64, N>> {
    let mut points = vec![Vector::zeros()];
    points.extend((0..N).map(|i| Vector::from_fn(|j, _| f64::from(u8::from(i == j)))));
    points
}

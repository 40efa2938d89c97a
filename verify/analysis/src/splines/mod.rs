//! Floor 1. Clamped splines: functions of H²_0 that are polynomials on every cell of a cube's mesh.
//!
//! Products of C¹ splines in the coordinates, on the grid that the cubes are made of. They and their first derivatives
//! vanish on the boundary, so that a functional tested with them is bounded by its H⁻² norm from below, whatever else is
//! known of that norm.

mod line;

use crate::best::{Form, HELD};
use line::Line;
use nalgebra::{DMatrix, DVector};
use regge_curvature::Error;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::Vector;
use regge_curvature::mesh::Mesh;
use regge_curvature::simplex::Points;
use regge_curvature::spaces::Lagrange;

/// The tensor products of the splines of one grid.
#[derive(Clone, Debug)]
pub struct Clamped<const N: usize> {
    lines: [Line; N],
}

impl<const N: usize> Clamped<N> {
    /// The splines of these grids, each of at least four knots, of a degree of at least 2 in each coordinate.
    pub fn new(grids: [Vec<f64>; N], degree: usize) -> Self {
        Self {
            lines: grids.map(|grid| Line { grid, degree }),
        }
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.lines.iter().map(Line::len).product()
    }

    /// Is there none?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The degree of Lagrange functions that they are.
    pub fn total_degree(&self) -> usize {
        N * self.lines[0].degree
    }

    /// How many there are on a box, with those that the clamp takes away.
    fn on_one(&self) -> usize {
        self.lines[0].on_one().pow(N as u32)
    }

    /// The place of a spline of a box in each coordinate: the first runs fastest.
    fn places(&self, index: usize) -> [usize; N] {
        let on_one = self.lines[0].on_one();
        std::array::from_fn(|i| index / on_one.pow(i as u32) % on_one)
    }

    /// Σ |∂^α v|² over all derivatives of these orders, mixed ones as often as they are there in the tensor.
    pub fn norm(&self, orders: &[usize]) -> Form {
        let intervals: Vec<Vec<[DMatrix<f64>; 3]>> = (self.lines.iter())
            .map(|line| (0..line.intervals()).map(|i| line.products(i)).collect())
            .collect();
        let lists: Vec<[usize; N]> = orders
            .iter()
            .flat_map(|order| derivatives(*order))
            .collect();
        let mut form = Form::zero(self.len());
        let boxes: usize = self.lines.iter().map(Line::intervals).product();
        for mut index in 0..boxes {
            let box_: [usize; N] = std::array::from_fn(|i| {
                let here = index % self.lines[i].intervals();
                index /= self.lines[i].intervals();
                here
            });
            let product = |alpha: &[usize; N]| {
                (0..N).fold(DMatrix::identity(1, 1), |product, i| {
                    intervals[i][box_[i]][alpha[i]].kronecker(&product)
                })
            };
            let sum = lists.iter().map(product).reduce(|a, b| a + b);
            let numbers = self.on_box(box_).into_iter().map(|n| n.unwrap_or(HELD));
            form.add(
                &numbers.collect::<Vec<_>>(),
                &sum.expect("an order is given"),
            );
        }
        form
    }

    /// f(v) of every spline, from f(φ) of the basis functions of a Lagrange space that contains them (of their total degree) on the
    /// mesh of the grid, cubes cut into simplices.
    ///
    /// # Errors
    /// If the mesh has no coordinates.
    pub fn loads(&self, space: &Lagrange<N>, load: &[f64]) -> Result<Vec<f64>, Error> {
        let lattice = Lattice::new(space);
        let mut taken = vec![false; space.len()];
        let mut all = vec![0.0; self.len()];
        for cell in 0..space.mesh().cell_count() {
            let (corners, box_) = self.place(space.mesh(), cell)?;
            // A function counts where it is met first: splines that are zero in that cell are zero on all of its faces.
            let mut first = |dof: usize| match std::mem::replace(&mut taken[dof], true) {
                true => 0.0,
                false => load[dof],
            };
            let first =
                DVector::from_iterator(lattice.points.len(), space.cell_dofs(cell).map(&mut first));
            let dual = lattice.inverse.tr_mul(&first);
            let numbers = self.on_box(box_);
            for (point, factor) in dual.iter().enumerate() {
                let values = self.values(box_, &lattice.at(&corners, point));
                for (number, value) in numbers.iter().zip(values) {
                    if let Some(number) = number {
                        all[*number] += factor * value;
                    }
                }
            }
        }
        Ok(all)
    }

    /// In which box of the grid a point is.
    pub fn box_of(&self, x: &Vector<f64, N>) -> [usize; N] {
        std::array::from_fn(|i| {
            let right = self.lines[i].grid.iter().position(|t| *t > x[i]);
            right.expect("the mesh is in the grid") - 1
        })
    }

    /// The splines on a box: their numbers, none for those that are not there.
    pub fn on_box(&self, box_: [usize; N]) -> Vec<Option<usize>> {
        let number = |index: usize| {
            let (mut place, mut stride) = (0, 1);
            for (i, k) in self.places(index).into_iter().enumerate() {
                place += stride * self.lines[i].number(box_[i], k)?;
                stride *= self.lines[i].len();
            }
            Some(place)
        };
        (0..self.on_one()).map(number).collect()
    }

    /// The same splines at a point of the box: derivatives in the coordinates of ℝ^N.
    pub fn jets(&self, box_: [usize; N], x: &Vector<f64, N>) -> Vec<Jet2<f64, N>> {
        let one: [Vec<[f64; 3]>; N] = std::array::from_fn(|i| self.lines[i].at(box_[i], x[i]));
        let jet = |index: usize| {
            let places = self.places(index);
            let of = |along: &[usize]| -> f64 {
                let order = |i: usize| along.iter().filter(|o| **o == i).count();
                (0..N).map(|i| one[i][places[i]][order(i)]).product()
            };
            Jet2 {
                value: of(&[]),
                d: std::array::from_fn(|m| of(&[m])),
                dd: std::array::from_fn(|m| std::array::from_fn(|n| of(&[m, n]))),
            }
        };
        (0..self.on_one()).map(jet).collect()
    }

    /// The coefficients of the splines on a cell, columns, in a Lagrange space that contains them.
    ///
    /// # Errors
    /// If the mesh has no coordinates.
    pub fn coefficients(
        &self,
        lattice: &Lattice,
        mesh: &Mesh<N>,
        cell: usize,
    ) -> Result<DMatrix<f64>, Error> {
        let (corners, box_) = self.place(mesh, cell)?;
        let mut values = DMatrix::zeros(lattice.points.len(), self.on_one());
        for point in 0..lattice.points.len() {
            let x = lattice.at(&corners, point);
            for (k, value) in self.values(box_, &x).enumerate() {
                values[(point, k)] = value;
            }
        }
        Ok(&lattice.inverse * values)
    }

    /// The splines on a cell: their numbers, none for those that are not there.
    ///
    /// # Errors
    /// If the mesh has no coordinates.
    pub fn on_cell(&self, mesh: &Mesh<N>, cell: usize) -> Result<Vec<Option<usize>>, Error> {
        Ok(self.on_box(self.place(mesh, cell)?.1))
    }

    /// The corners of a cell and the box that it is in.
    fn place(
        &self,
        mesh: &Mesh<N>,
        cell: usize,
    ) -> Result<(Vec<Vector<f64, N>>, [usize; N]), Error> {
        let corners: Option<Vec<Vector<f64, N>>> = (0..=N).map(|i| mesh.corner(cell, i)).collect();
        let corners = corners.ok_or(Error::NoCoordinates("a spline"))?;
        let centre = corners.iter().sum::<Vector<f64, N>>() / (N + 1) as f64;
        let box_ = self.box_of(&centre);
        Ok((corners, box_))
    }

    /// The values of the splines of a box at a point of it.
    fn values(&self, box_: [usize; N], x: &Vector<f64, N>) -> impl Iterator<Item = f64> + use<N> {
        let one: [Vec<[f64; 3]>; N] = std::array::from_fn(|i| self.lines[i].at(box_[i], x[i]));
        let places: Vec<[usize; N]> = (0..self.on_one()).map(|index| self.places(index)).collect();
        let value = move |places: [usize; N]| (0..N).map(|i| one[i][places[i]][0]).product();
        places.into_iter().map(value)
    }
}

/// All lists of so many coordinates, as how often each coordinate is in them.
fn derivatives<const N: usize>(order: usize) -> Vec<[usize; N]> {
    let count = |mut list: usize| {
        let mut alpha = [0; N];
        for _ in 0..order {
            alpha[list % N] += 1;
            list /= N;
        }
        alpha
    };
    (0..N.pow(order as u32)).map(count).collect()
}

/// The lattice on which Lagrange functions of a degree are determined.
#[derive(Clone, Debug)]
pub struct Lattice {
    points: Points,
    /// Values at the points ↦ coefficients.
    inverse: DMatrix<f64>,
}

impl Lattice {
    /// That of a space.
    pub fn new<const N: usize>(space: &Lagrange<N>) -> Self {
        let basis = space.basis(N);
        let share = |a: &usize| *a as f64 / space.degree() as f64;
        let lambda: Vec<f64> = basis.exponents().iter().flatten().map(share).collect();
        let points = Points::new(N + 1, lambda);
        let rows = basis.tabulate::<f64>(&points);
        let values = DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j]);
        let inverse = values.try_inverse();
        Self {
            points,
            inverse: inverse.expect("polynomials are determined on their lattice"),
        }
    }

    fn at<const N: usize>(&self, corners: &[Vector<f64, N>], point: usize) -> Vector<f64, N> {
        let all = corners.iter().zip(self.points.lambda(point));
        all.map(|(c, l)| c * *l).sum()
    }
}

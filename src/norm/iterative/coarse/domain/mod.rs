//! Splines on a lattice that reaches past a domain of any shape: all those that meet the mesh, and a cycle over lattices with
//! boxes twice, four times, … as large to solve with their form.

mod coarser;
mod energy;
mod forms;
mod galerkin;
mod halve;
mod inside;
mod level;
mod rows;

use super::stencil::{Grid, Short};
use super::transfer::Transfer;
use crate::Error;
use crate::linalg::Vector;
use crate::norm::hhj::{Hhj, Size};
use crate::norm::iterative::smoother::{Room, Smoother};
use crate::parallel::collect;
use level::{Kind, Level};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// How many steps smooth the splines of the lattice after `depth` halvings of the finest: twice as many on each as on the one before, up
/// to the eight of which it is known that rounding does not see them (`smoother.rs`). They cost little there, and a cycle with more steps on coarser lattices does not get worse with
/// their number: on a disc with holes of 995 072 triangles, p = 3, three steps on all seven lattices take 19 iterations, eight on the
/// coarser ones 12, where there are 11 on 124 977 triangles.
fn steps(depth: usize) -> usize {
    [3, 6].get(depth).copied().unwrap_or(8)
}

/// With so many splines a lattice is solved on by a dense factor.
const FEW: usize = 600;
/// What is added to the factor's diagonal of ones: splines that differ only outside the mesh are all but the same there, and
/// single precision leaves eigenvalues of either sign, up to 1e-5. The least that matter are above 1e-3 on so few splines.
const SHIFT: f64 = 1e-4;
/// The edge of the lattice's boxes in units of h/p. The smoother must reach down to what the splines see, and its steps are cheaper
/// than splines: on a ball of 16 692 tetrahedra, 2.25 with eight steps takes 12, 15 and 19 iterations (p = 2, 3, 4), 2 with seven 13, 16
/// and 22, as long or up to a seventh longer; 1.75 with six 18 for p = 3, and a fifth longer. In the plane 1 takes as many iterations as
/// 1.5, and more time.
const fn coarseness(n: usize) -> f64 {
    if n == 2 { 1.5 } else { 2.25 }
}

/// The lattice: p boxes of it, or fewer by [`coarseness`], to the edge h of a cube of N! mean cells.
///
/// # Errors
/// If the mesh has no points.
pub(super) fn background<const N: usize>(hhj: &Hhj<N>) -> Result<Grid<N>, Error> {
    let points = hhj.mesh().points();
    let points = points.ok_or(Error::NoCoordinates("the iterative solver"))?;
    let (mut lower, mut upper) = (points[0], points[0]);
    for x in points {
        lower = lower.inf(x);
        upper = upper.sup(x);
    }
    // The reference simplex has 1/N! of the volume of its cube.
    let cells = hhj.mesh().cell_count();
    let volumes = collect(cells, |cell| hhj.shape(cell).volume);
    let volume: f64 = volumes.into_iter().sum();
    let mean = (volume / cells as f64).powf(1.0 / N as f64);
    let density = hhj.space().degree().max(2) as f64 / (coarseness(N) * mean);
    let boxes = (upper - lower).map(|extent| (extent * density).ceil().max(1.0));
    // The domain is in the middle.
    let lower = (lower + upper - boxes / density) * 0.5;
    Ok(Grid {
        sides: std::array::from_fn(|axis| boxes[axis] as usize + 3),
        lower,
        density: Vector::from_element(density),
    })
}

/// The lattices' forms, the finest first.
#[derive(Debug)]
pub(super) struct Levels<const N: usize> {
    levels: Vec<(Level<N>, Smoother)>,
    coarsest: Dense,
}

impl<const N: usize> Levels<N> {
    /// # Errors
    /// If rounding makes the coarsest form indefinite.
    pub fn new(transfer: &Transfer<N>) -> Result<Self, Error> {
        let (mut level, mut levels) = (galerkin::finest(transfer), Vec::new());
        while level
            .kinds
            .iter()
            .filter(|&&kind| kind != Kind::Idle)
            .count()
            > FEW
        {
            let coarser = level.halved();
            let smoother = Smoother::new(steps(levels.len()), &level);
            levels.push((std::mem::replace(&mut level, coarser), smoother));
        }
        Ok(Self {
            levels,
            coarsest: Dense::new(&level)?,
        })
    }

    /// What [`Levels::solve`] works with.
    pub fn rooms(&self) -> Rooms<N> {
        let levels = self.levels.iter();
        Rooms(levels.map(|(level, _)| Room::new(level)).collect())
    }

    /// s becomes about C⁻¹ s.
    pub fn solve(&self, s: &mut [Short], rooms: &mut Rooms<N>) {
        self.cycle(0, s, &mut rooms.0);
    }

    /// A symmetric cycle from this level on: z becomes about C⁻¹ z.
    fn cycle(&self, depth: usize, z: &mut [Short], rooms: &mut [Room<Level<N>>]) {
        let Some((level, smoother)) = self.levels.get(depth) else {
            return self.coarsest.solve(z);
        };
        let (room, rooms) = rooms.split_first_mut().expect("a room for each level");
        room.residual.copy_from_slice(z);
        level.clear(&mut room.residual);
        smoother.begin(level, z, room);
        let mut coarse = halve::restrict(&room.residual, &level.sides);
        self.cycle(depth + 1, &mut coarse, rooms);
        room.correction = halve::prolong(coarse, &level.sides);
        level.clear(&mut room.correction);
        smoother.end(level, z, room);
    }
}

/// Vectors for each level but the coarsest.
#[derive(Default)]
pub(in crate::norm::iterative) struct Rooms<const N: usize>(Vec<Room<Level<N>>>);

/// The form on a coarsest lattice, factorised.
#[derive(Debug)]
struct Dense {
    /// The splines that are not idle.
    active: Vec<usize>,
    /// The inverse square roots of the diagonal.
    scales: Vec<f64>,
    factor: Cholesky<f64, Dyn>,
}

impl Dense {
    fn new<const N: usize>(level: &Level<N>) -> Result<Self, Error> {
        let splines = 0..level.kinds.len();
        let active: Vec<usize> = splines
            .filter(|&at| level.kinds[at] != Kind::Idle)
            .collect();
        let mut places = vec![None; level.kinds.len()];
        for (place, &at) in active.iter().enumerate() {
            places[at] = Some(place);
        }
        let mut a = DMatrix::zeros(active.len(), active.len());
        for (i, &at) in active.iter().enumerate() {
            level.for_row(at, |column, number| {
                if let Some(j) = places[column] {
                    a[(i, j)] = number;
                    a[(j, i)] = number;
                }
            });
        }
        let scales: Vec<f64> = a
            .diagonal()
            .iter()
            .map(|x: &f64| x.sqrt().recip())
            .collect();
        for (i, x) in scales.iter().enumerate() {
            a.row_mut(i).scale_mut(*x);
            a.column_mut(i).scale_mut(*x);
            a[(i, i)] += SHIFT;
        }
        let failed = || Error::Solver("the coarsest splines' form is indefinite".into());
        Ok(Self {
            factor: a.cholesky().ok_or_else(failed)?,
            active,
            scales,
        })
    }

    fn solve(&self, z: &mut [Short]) {
        let scaled = self.active.iter().zip(&self.scales);
        let scaled = scaled.map(|(&at, scale)| scale * f64::from(z[at]));
        let mut x = DVector::from_vec(scaled.collect());
        self.factor.solve_mut(&mut x);
        z.fill(0.0);
        for ((&at, scale), x) in self.active.iter().zip(&self.scales).zip(x.iter()) {
            z[at] = (scale * x) as Short;
        }
    }
}

/// The bytes of the forms while they are set up, on a mesh with so many faces in ∂Ω. A row is stored where a spline is fewer
/// than some 6 + p boxes from ∂Ω; its spline is coupled to about (3p/c + 6)^N others, c the coarseness, half of which have a number
/// there, and for a time there are those handed on to the next lattice besides. Measured: the whole command takes 1/2 to 3/4 of what
/// is estimated for it.
pub(super) fn memory(size: &Size, boundary: usize) -> f64 {
    let (n, p) = (size.dimension() as i32, size.degree().max(2) as f64);
    let simplices = |n: i32| (1..=n).map(f64::from).product::<f64>();
    let per_edge = p / coarseness(size.dimension());
    // The lattice is that of a box around Ω, which may be twice as large.
    let splines = 2.0 * size.cells() as f64 * per_edge.powi(n) / simplices(n);
    let on_boundary = boundary as f64 * per_edge.powi(n - 1) / simplices(n - 1);
    let rows = ((6.0 + p) * on_boundary).min(splines);
    120.0 * splines + 2.2 * rows * (3.0 * per_edge + 6.0).powi(n)
}

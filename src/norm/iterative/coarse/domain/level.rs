//! The form on the splines of one lattice: a constant stencil far inside, rows of numbers near ∂Ω.

use super::super::patch::Patch;
use super::super::stencil::Short;
use crate::norm::iterative::smoother::{Room, Smoothed};
use crate::parallel::{for_chunks, for_chunks_together};

/// What is known of a spline's row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// The spline does not meet the mesh.
    Idle,
    /// The row is written down.
    Stored,
    /// The row is that of a spline in all of ℝ^N.
    Deep,
}

/// A symmetric form on the splines of a lattice.
#[derive(Debug)]
pub(super) struct Level<const N: usize> {
    /// How many splines along each axis.
    pub sides: [usize; N],
    pub kinds: Vec<Kind>,
    /// The rows by planes across the last axis.
    pub planes: Vec<Plane<N>>,
    /// The row of every deep spline: 7^N numbers.
    pub stencil: Vec<f64>,
    /// The inverse diagonal; zero where there is no row.
    inverse: Vec<Short>,
}

/// The stored rows of a plane.
#[derive(Clone, Debug, Default)]
pub(super) struct Plane<const N: usize> {
    /// In the order of their splines.
    pub rows: Vec<Row<N>>,
    pub values: Vec<Short>,
}

/// A stored row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<const N: usize> {
    /// Which spline of the plane.
    pub site: u32,
    /// Where its numbers begin.
    pub start: usize,
    /// The splines that they belong to.
    pub patch: Patch<N>,
}

/// A diagonal entry below this part of a deep spline's is one of a spline that hardly touches the mesh: what P makes of it is below
/// 1e-5 in size, and single precision leaves an error of up to 1e-7 there. With less, a spline whose edge lies on vertices
/// (meshes along the lattice, p = 1) has nothing but rounding, 1e-10, in its row, and the inverse makes much of it.
const NOTHING: f64 = 1e-10;

impl<const N: usize> Plane<N> {
    /// Rows of zeros.
    pub fn new(rows: impl Iterator<Item = (u32, Patch<N>)>) -> Self {
        let mut plane = Self {
            rows: Vec::new(),
            values: Vec::new(),
        };
        let mut start = 0;
        for (site, patch) in rows {
            plane.rows.push(Row { site, start, patch });
            start += patch.len();
        }
        plane.values = vec![0.0; start];
        plane
    }

    /// The numbers of a row.
    pub fn numbers(&self, row: &Row<N>) -> &[Short] {
        &self.values[row.start..row.start + row.patch.len()]
    }

    /// The row of a spline of the plane.
    pub fn row(&self, site: usize) -> Option<&Row<N>> {
        let found = self
            .rows
            .binary_search_by_key(&site, |row| row.site as usize);
        found.ok().map(|row| &self.rows[row])
    }
}

impl<const N: usize> Level<N> {
    pub fn new(
        sides: [usize; N],
        kinds: Vec<Kind>,
        planes: Vec<Plane<N>>,
        stencil: Vec<f64>,
    ) -> Self {
        let mut level = Self {
            sides,
            inverse: vec![0.0; kinds.len()],
            kinds,
            planes,
            stencil,
        };
        let middle = level.stencil[level.stencil.len() / 2];
        for at in 0..level.inverse.len() {
            let diagonal = match level.kinds[at] {
                Kind::Idle => continue,
                Kind::Deep => middle,
                Kind::Stored => level.entry(at),
            };
            match diagonal > NOTHING * middle {
                true => level.inverse[at] = (1.0 / diagonal) as Short,
                false => level.kinds[at] = Kind::Idle,
            }
        }
        level
    }

    /// How many splines a plane.
    pub fn plane(&self) -> usize {
        self.sides[..N - 1].iter().product()
    }

    /// The diagonal entry of a stored row.
    fn entry(&self, at: usize) -> f64 {
        let (plane, site) = (at / self.plane(), Patch::whole(&self.sides).site(at));
        let plane_of = &self.planes[plane];
        let row = plane_of.row(at % self.plane()).expect("a stored row");
        f64::from(plane_of.values[row.start + row.patch.position(&site)])
    }

    /// The numbers of the row of a spline that is not idle, with the splines that they belong to.
    pub fn for_row(&self, at: usize, mut work: impl FnMut(usize, f64)) {
        let whole = Patch::whole(&self.sides);
        if self.kinds[at] == Kind::Deep {
            let patch = Patch::around(&whole.site(at), 3, &self.sides);
            for (site, x) in patch.sites().zip(&self.stencil) {
                work(whole.position(&site), *x);
            }
            return;
        }
        let plane = &self.planes[at / self.plane()];
        let row = plane.row(at % self.plane()).expect("a stored row");
        for (site, x) in row.patch.sites().zip(plane.numbers(row)) {
            work(whole.position(&site), f64::from(*x));
        }
    }

    /// Sets to zero what belongs to no row.
    pub fn clear(&self, x: &mut [Short]) {
        for (x, kind) in x.iter_mut().zip(&self.kinds) {
            if *kind == Kind::Idle {
                *x = 0.0;
            }
        }
    }

    /// The part of `apply` along a line of a plane for deep splines next to each other.
    fn stencil_line(&self, x: &[Short], at: usize, y: &mut [Short]) {
        let site = Patch::whole(&self.sides).site(at);
        let patch = Patch::around(&site, 3, &self.sides);
        let whole = Patch::whole(&self.sides);
        for (line, weights) in patch.lines().zip(self.stencil.chunks_exact(7)) {
            let begin = whole.position(&line);
            for (i, &weight) in weights.iter().enumerate() {
                let weight = weight as Short;
                for (y, x) in y.iter_mut().zip(&x[begin + i..]) {
                    *y += weight * x;
                }
            }
        }
    }

    /// A stored row times x. Four sums, which do not wait for each other, and one of what is left of the lines.
    fn row_times(&self, plane: &Plane<N>, row: &Row<N>, x: &[Short]) -> Short {
        let (whole, along) = (Patch::whole(&self.sides), row.patch.sides()[0]);
        let values = plane.numbers(row);
        let (mut sums, mut last) = ([0.0; 4], 0.0);
        for (line, values) in row.patch.lines().zip(values.chunks_exact(along)) {
            let begin = whole.position(&line);
            let (fours, rest) = values.as_chunks::<4>();
            let (x_fours, x_rest) = x[begin..begin + along].as_chunks::<4>();
            for (values, x) in fours.iter().zip(x_fours) {
                for i in 0..4 {
                    sums[i] += values[i] * x[i];
                }
            }
            for (value, x) in rest.iter().zip(x_rest) {
                last += value * x;
            }
        }
        sums.into_iter().sum::<Short>() + last
    }

    /// A x on a plane.
    fn plane_times(&self, plane: usize, x: &[Short], y: &mut [Short]) {
        let unit = self.plane();
        y.fill(0.0);
        let kinds = &self.kinds[plane * unit..(plane + 1) * unit];
        // Runs of deep splines never go beyond a line: the first and the last spline of a line are not deep.
        let mut begin = 0;
        for run in kinds.chunk_by(|a, b| a == b) {
            if run[0] == Kind::Deep {
                self.stencil_line(x, plane * unit + begin, &mut y[begin..begin + run.len()]);
            }
            begin += run.len();
        }
        let stored = &self.planes[plane];
        for row in &stored.rows {
            y[row.site as usize] = self.row_times(stored, row, x);
        }
    }
}

impl<const N: usize> Smoothed for Level<N> {
    type Number = Short;
    /// The image of a vector.
    type Room = Vec<Short>;

    fn room(&self) -> Vec<Short> {
        vec![0.0; self.len()]
    }

    fn len(&self) -> usize {
        self.inverse.len()
    }

    fn apply(&self, x: &[Short], y: &mut [Short], _: &mut Vec<Short>) {
        for_chunks(y, self.plane(), |plane, y| self.plane_times(plane, x, y));
    }

    fn invert(&self, r: &[Short], z: &mut [Short]) {
        for ((z, r), inverse) in z.iter_mut().zip(r).zip(&self.inverse) {
            *z = r * inverse;
        }
    }

    fn subtract_image(&self, room: &mut Room<Self>) {
        let (x, vectors) = (
            &room.correction,
            [&mut room.residual[..], &mut room.operator],
        );
        for_chunks_together(
            vectors,
            self.plane(),
            || (),
            |plane, [r, image], ()| {
                self.plane_times(plane, x, image);
                for (r, image) in r.iter_mut().zip(image) {
                    *r -= *image;
                }
            },
        );
    }

    fn step(&self, weight: f64, z: &mut [Short], room: &mut Room<Self>) {
        let (unit, weight) = (self.plane(), weight as Short);
        let (x, vectors) = (
            &room.correction,
            [&mut room.residual[..], &mut room.operator, z],
        );
        // The old correction is still needed on the planes nearby: the new one goes to where the image is.
        for_chunks_together(
            vectors,
            unit,
            || (),
            |plane, [r, image, z], ()| {
                self.plane_times(plane, x, image);
                let inverses = &self.inverse[plane * unit..];
                for (((r, c), z), inverse) in r.iter_mut().zip(image).zip(z).zip(inverses) {
                    *r -= *c;
                    *c = weight * (*r * inverse);
                    *z += *c;
                }
            },
        );
        std::mem::swap(&mut room.correction, &mut room.operator);
    }
}

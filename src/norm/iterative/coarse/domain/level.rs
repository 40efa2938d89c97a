//! The form on the splines of one lattice: a constant stencil far inside, rows of numbers near ∂Ω. Each pair of splines is there once.

use super::super::patch::Patch;
use super::super::stencil::Short;
use super::rows::{Plane, Row};
use crate::norm::iterative::smoother::{Room, Smoothed};
use crate::parallel::{for_chunks, for_chunks_in, for_chunks_together};
use std::ops::Range;

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
    /// The row of every deep spline: 7^N numbers, of which the application takes those from the middle on.
    pub stencil: Vec<f64>,
    /// Planes whose rows are applied one after the other.
    pieces: Vec<Piece>,
    /// The inverse diagonal; zero where there is no row.
    inverse: Vec<Short>,
}

/// A diagonal entry below this part of a deep spline's is one of a spline that hardly touches the mesh: what P makes of it is below
/// 1e-5 in size, and single precision leaves an error of up to 1e-7 there. With less, a spline whose edge lies on vertices
/// (meshes along the lattice, p = 1) has nothing but rounding, 1e-10, in its row, and the inverse makes much of it.
const NOTHING: f64 = 1e-10;

/// How many pieces there are about: more than threads, and few enough that what they share is little.
const PIECES: usize = 16;

/// Consecutive planes, whose rows reach the planes before `end`.
#[derive(Clone, Debug)]
struct Piece {
    planes: Range<usize>,
    end: usize,
}

/// The planes in pieces with about as many numbers each.
fn pieces<const N: usize>(sides: &[usize; N], planes: &[Plane<N>]) -> Vec<Piece> {
    let unit: usize = sides[..N - 1].iter().product();
    let work = |plane: &Plane<N>| plane.values.len() + unit;
    let share = planes.iter().map(work).sum::<usize>().div_ceil(PIECES);
    let (mut pieces, mut begin, mut sum, mut end) = (Vec::new(), 0, 0, 0);
    for (i, plane) in planes.iter().enumerate() {
        let reached = plane.rows.iter().map(|row| row.patch.high[N - 1]);
        // Deep splines reach three planes.
        end = reached.fold(end.max(i + 4), usize::max).min(planes.len());
        sum += work(plane);
        if sum >= share || i + 1 == planes.len() {
            let planes = begin..i + 1;
            pieces.push(Piece { planes, end });
            (begin, sum, end) = (i + 1, 0, 0);
        }
    }
    pieces
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
            pieces: pieces(&sides, &planes),
            kinds,
            planes,
            stencil,
        };
        let (middle, mut lost) = (level.stencil[level.stencil.len() / 2], false);
        for at in 0..level.inverse.len() {
            let diagonal = match level.kinds[at] {
                Kind::Idle => continue,
                Kind::Deep => middle,
                Kind::Stored => level.entry(at),
            };
            if diagonal > NOTHING * middle {
                level.inverse[at] = (1.0 / diagonal) as Short;
            } else {
                level.kinds[at] = Kind::Idle;
                lost = true;
            }
        }
        if lost {
            level.drop_idle();
        }
        level
    }

    /// Sets the numbers to zero that belong to an idle spline, in its row and in others.
    fn drop_idle(&mut self) {
        let (whole, unit, kinds) = (Patch::whole(&self.sides), self.plane(), &self.kinds);
        for_chunks(&mut self.planes, 1, |plane, planes| {
            let Plane { rows, values, .. } = &mut planes[0];
            for row in rows {
                let at = plane * unit + row.spline as usize;
                let mut values = &mut values[row.range()];
                for (line, along) in row.patch.lines_from(&whole.site(at)) {
                    let (numbers, rest) = values.split_at_mut(along);
                    let kinds_of_line = &kinds[whole.position(&line)..];
                    for (x, kind) in numbers.iter_mut().zip(kinds_of_line) {
                        if kinds[at] == Kind::Idle || *kind == Kind::Idle {
                            *x = 0.0;
                        }
                    }
                    values = rest;
                }
            }
        });
    }

    /// How many splines a plane.
    pub fn plane(&self) -> usize {
        self.sides[..N - 1].iter().product()
    }

    /// The diagonal entry of a stored row: its first number.
    fn entry(&self, at: usize) -> f64 {
        let plane = &self.planes[at / self.plane()];
        let row = plane.row(at % self.plane()).expect("a stored row");
        f64::from(plane.numbers(row)[0])
    }

    /// The numbers in the row of a spline that is not idle, from its own on, with the splines that they belong to.
    pub fn for_row(&self, at: usize, mut work: impl FnMut(usize, f64)) {
        let whole = Patch::whole(&self.sides);
        let site = whole.site(at);
        let numbers = |patch: &Patch<N>| {
            let lines = patch.lines_from(&site);
            lines.flat_map(|(line, along)| (0..along).map(move |i| (line, i)))
        };
        let mut take = |(line, i): ([usize; N], usize), x| work(whole.position(&line) + i, x);
        if self.kinds[at] == Kind::Deep {
            let patch = Patch::around(&site, 3, &self.sides);
            for (place, x) in numbers(&patch).zip(self.half_stencil()) {
                take(place, *x);
            }
            return;
        }
        let plane = &self.planes[at / self.plane()];
        let row = plane.row(at % self.plane()).expect("a stored row");
        for (place, x) in numbers(&row.patch).zip(plane.numbers(row)) {
            take(place, f64::from(*x));
        }
    }

    /// The stencil from the spline itself on.
    pub fn half_stencil(&self) -> &[f64] {
        &self.stencil[self.stencil.len() / 2..]
    }

    /// Sets to zero what belongs to no row.
    pub fn clear(&self, x: &mut [Short]) {
        for (x, kind) in x.iter_mut().zip(&self.kinds) {
            if *kind == Kind::Idle {
                *x = 0.0;
            }
        }
    }

    /// Adds what a line's deep splines next to each other, the first of them `at`, have to A x; y begins at spline `begin`.
    fn add_run(&self, x: &[Short], at: usize, run: usize, y: &mut [Short], begin: usize) {
        let whole = Patch::whole(&self.sides);
        let site = whole.site(at);
        let mut weights = self.half_stencil();
        for (line, along) in Patch::around(&site, 3, &self.sides).lines_from(&site) {
            let (of_line, rest) = weights.split_at(along);
            for (other, &weight) in (whole.position(&line)..).zip(of_line) {
                let weight = weight as Short;
                add(&mut y[at - begin..][..run], weight, &x[other..]);
                if other != at {
                    add(&mut y[other - begin..][..run], weight, &x[at..]);
                }
            }
            weights = rest;
        }
    }

    /// Adds what a stored row has to A x. Four sums, which do not wait for each other, and one of what is left of the lines.
    fn add_row(&self, x: &[Short], at: usize, row: &Row<N>, y: &mut [Short], begin: usize) {
        let (whole, unit) = (Patch::whole(&self.sides), self.plane());
        let mut values = self.planes[at / unit].numbers(row);
        let (own, mut sums, mut last) = (x[at], [0.0; 4], -values[0] * x[at]);
        for (line, along) in row.patch.lines_from(&whole.site(at)) {
            let (of_line, rest) = values.split_at(along);
            let other = whole.position(&line);
            let (x, y) = (&x[other..][..along], &mut y[other - begin..][..along]);
            let (fours, ends) = of_line.as_chunks::<4>();
            let (x_fours, x_ends) = x.as_chunks::<4>();
            let (y_fours, y_ends) = y.as_chunks_mut::<4>();
            for ((values, x), y) in fours.iter().zip(x_fours).zip(y_fours) {
                for i in 0..4 {
                    sums[i] += values[i] * x[i];
                    y[i] += values[i] * own;
                }
            }
            for ((value, x), y) in ends.iter().zip(x_ends).zip(y_ends) {
                last += value * x;
                *y += value * own;
            }
            values = rest;
        }
        // The diagonal was in both.
        y[at - begin] += sums.into_iter().sum::<Short>() + last;
    }

    /// What the rows of some planes have to A x.
    fn piece_times(&self, piece: &Piece, x: &[Short], y: &mut [Short]) {
        let (unit, begin) = (self.plane(), piece.planes.start * self.plane());
        y.fill(0.0);
        for plane in piece.planes.clone() {
            // Runs of deep splines never go beyond a line: the first and the last spline of a line are not deep.
            let mut at = plane * unit;
            for run in self.kinds[at..at + unit].chunk_by(|a, b| a == b) {
                if run[0] == Kind::Deep {
                    self.add_run(x, at, run.len(), y, begin);
                }
                at += run.len();
            }
            for row in &self.planes[plane].rows {
                self.add_row(x, plane * unit + row.spline as usize, row, y, begin);
            }
        }
    }

    /// A x, piece by piece.
    fn by_piece(&self, x: &[Short], parts: &mut [Vec<Short>]) {
        for_chunks(parts, 1, |i, part| {
            self.piece_times(&self.pieces[i], x, &mut part[0])
        });
    }

    /// The sum over the pieces on a plane.
    fn collect(&self, parts: &[Vec<Short>], plane: usize, y: &mut [Short]) {
        y.fill(0.0);
        for (piece, part) in self.pieces.iter().zip(parts) {
            if (piece.planes.start..piece.end).contains(&plane) {
                add(y, 1.0, &part[(plane - piece.planes.start) * y.len()..]);
            }
        }
    }
}

/// y += α x, as far as y goes.
#[inline]
fn add(y: &mut [Short], alpha: Short, x: &[Short]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += alpha * x;
    }
}

impl<const N: usize> Smoothed for Level<N> {
    type Number = Short;
    /// What the pieces have to A x.
    type Room = Vec<Vec<Short>>;

    fn room(&self) -> Self::Room {
        let len = |piece: &Piece| (piece.end - piece.planes.start) * self.plane();
        self.pieces
            .iter()
            .map(|piece| vec![0.0; len(piece)])
            .collect()
    }

    fn len(&self) -> usize {
        self.inverse.len()
    }

    fn apply(&self, x: &[Short], y: &mut [Short], room: &mut Self::Room) {
        self.by_piece(x, room);
        for_chunks(y, self.plane(), |plane, y| self.collect(room, plane, y));
    }

    fn invert(&self, r: &[Short], z: &mut [Short]) {
        for ((z, r), inverse) in z.iter_mut().zip(r).zip(&self.inverse) {
            *z = r * inverse;
        }
    }

    fn subtract_image(&self, room: &mut Room<Self>) {
        let (unit, parts) = (self.plane(), &mut room.operator);
        self.by_piece(&room.correction, parts);
        let image = || vec![0.0; unit];
        for_chunks_in(&mut room.residual, unit, image, |plane, r, image| {
            self.collect(parts, plane, image);
            add(r, -1.0, image);
        });
    }

    fn step(&self, weight: f64, z: &mut [Short], room: &mut Room<Self>) {
        let (unit, weight, parts) = (self.plane(), weight as Short, &mut room.operator);
        self.by_piece(&room.correction, parts);
        let image = || vec![0.0; unit];
        let vectors = [&mut room.residual[..], &mut room.correction, z];
        for_chunks_together(vectors, unit, image, |plane, [r, c, z], image| {
            self.collect(parts, plane, image);
            add(r, -1.0, image);
            let inverses = &self.inverse[plane * unit..];
            for (((r, c), z), inverse) in r.iter().zip(c).zip(z).zip(inverses) {
                *c = weight * (r * inverse);
                *z += *c;
            }
        });
    }
}

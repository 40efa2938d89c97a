//! The stored rows of a symmetric form on a lattice's splines. Each pair of splines is there once, in the row of the one that comes
//! first in the lattice's order: what a row has begins at its own spline.

use super::super::patch::Patch;
use super::super::stencil::Short;
use crate::parallel::zeros;

/// The stored rows of a plane across the last axis.
#[derive(Clone, Debug, Default)]
pub(super) struct Plane<const N: usize> {
    /// In the order of their splines.
    pub rows: Vec<Row<N>>,
    /// For each spline of the plane up to the last that has one, which of the rows is its: [`NONE`] without.
    places: Vec<u32>,
    pub values: Vec<Short>,
}

/// No row.
const NONE: u32 = u32::MAX;

/// A stored row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<const N: usize> {
    /// Which spline of the plane.
    pub spline: u32,
    /// The splines that its numbers belong to, from place `first` in this box on.
    pub patch: Patch<N>,
    pub first: usize,
    /// Where its numbers begin.
    start: usize,
}

impl<const N: usize> Plane<N> {
    /// Rows of zeros: the spline, the box and the first place in it.
    pub fn new(rows: impl Iterator<Item = (u32, Patch<N>, usize)>) -> Self {
        let (mut list, mut places, mut start) = (Vec::new(), Vec::new(), 0);
        for (spline, patch, first) in rows {
            places.resize(spline as usize, NONE);
            places.push(list.len() as u32);
            list.push(Row {
                spline,
                patch,
                first,
                start,
            });
            start += patch.len() - first;
        }
        Self {
            rows: list,
            places,
            values: zeros(start),
        }
    }

    /// The numbers of a row.
    pub fn numbers(&self, row: &Row<N>) -> &[Short] {
        &self.values[row.range()]
    }

    /// The row of a spline of the plane.
    pub fn row(&self, spline: usize) -> Option<&Row<N>> {
        let place = self.places.get(spline).filter(|&&place| place != NONE);
        place.map(|&place| &self.rows[place as usize])
    }
}

impl<const N: usize> Row<N> {
    /// Where its numbers are among the plane's.
    pub fn range(&self) -> std::ops::Range<usize> {
        self.start..self.start + self.patch.len() - self.first
    }

    /// Where among the plane's the number of another spline is.
    pub fn place(&self, other: &[usize; N]) -> usize {
        self.start + self.patch.position(other) - self.first
    }

    /// Adds to the plane's numbers what a tensor on a box has from the row's own spline on, number by number as `convert` makes them.
    pub fn add<T: Copy>(
        &self,
        site: &[usize; N],
        from: &Patch<N>,
        tensor: &[T],
        values: &mut [Short],
        convert: impl Fn(T) -> Short,
    ) {
        let values = &mut values[self.range()];
        let mut tensor = &tensor[from.position(site)..];
        for (line, along) in from.lines_from(site) {
            let (numbers, rest) = tensor.split_at(along);
            let begin = self.patch.position(&line) - self.first;
            for (to, x) in values[begin..begin + along].iter_mut().zip(numbers) {
                *to += convert(*x);
            }
            tensor = rest;
        }
    }
}

/// The part of a box from a site's plane on, and the site's place in it.
pub(super) fn from_site<const N: usize>(patch: &Patch<N>, site: &[usize; N]) -> (Patch<N>, usize) {
    let mut part = *patch;
    part.low[N - 1] = site[N - 1];
    (part, part.position(site))
}

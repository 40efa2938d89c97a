//! Bounds of a number over a whole simplex, by halving it where they are wide.

use super::boxes::View;
use super::polynomial::Exponents;
use crate::scalar::Interval;

/// How long simplices are halved.
#[derive(Clone, Copy, Debug)]
pub(super) struct Effort {
    /// Until the bounds are this close, relative to the larger of them.
    pub relative: f64,
    /// Or until there are so many parts.
    pub parts: usize,
}

/// A part of a simplex, as the cells around see it.
pub(super) struct Part<const N: usize> {
    /// Barycentric coordinates of its vertices in the simplex.
    pub corners: Vec<Vec<f64>>,
    pub views: Vec<View<N>>,
}

impl<const N: usize> Part<N> {
    /// All of a simplex.
    pub fn whole(views: Vec<View<N>>, vertices: usize) -> Self {
        let unit = |v: usize| (0..vertices).map(|w| f64::from(u8::from(v == w))).collect();
        Self {
            corners: (0..vertices).map(unit).collect(),
            views,
        }
    }

    /// Both halves, cut through the middle of the longest edge.
    pub fn halves(&self, exponents: &[Exponents; 3]) -> [Self; 2] {
        let [a, b] = self.longest();
        [[a, b], [b, a]].map(|[kept, gone]| {
            let mut corners = self.corners.clone();
            // Halves of powers of two are exact.
            corners[gone] = (self.corners[a].iter().zip(&self.corners[b]))
                .map(|(x, y)| f64::midpoint(*x, *y))
                .collect();
            let half = |view: &View<N>| view.half(exponents, kept, gone);
            Self {
                corners,
                views: self.views.iter().map(half).collect(),
            }
        })
    }

    fn longest(&self) -> [usize; 2] {
        let square = |a: usize, b: usize| -> f64 {
            let pairs = self.corners[a].iter().zip(&self.corners[b]);
            pairs.map(|(x, y)| (x - y) * (x - y)).sum()
        };
        let (mut longest, mut most) = ([0, 1], 0.0);
        for b in 1..self.corners.len() {
            for a in 0..b {
                if square(a, b) > most {
                    (longest, most) = ([a, b], square(a, b));
                }
            }
        }
        longest
    }
}

/// Bounds of `of` over the simplex that these views are of.
pub(super) fn enclose<const N: usize>(
    views: Vec<View<N>>,
    exponents: &[Exponents; 3],
    effort: Effort,
    of: &dyn Fn(&[View<N>]) -> Interval,
) -> Interval {
    let whole = Part::whole(views, exponents[0].all[0].len());
    let mut parts = vec![(of(&whole.views), whole)];
    loop {
        let (worst, all) = widest(&parts);
        let magnitude = all.low().abs().max(all.high().abs());
        let narrow = all.width() <= effort.relative * magnitude || magnitude == 0.0;
        // A point has no halves.
        if narrow || parts.len() >= effort.parts || parts[worst].1.corners.len() == 1 {
            return all;
        }
        let (_, part) = parts.swap_remove(worst);
        parts.extend(part.halves(exponents).map(|half| (of(&half.views), half)));
    }
}

/// Of the parts that have the least and the largest bound the one with the wider bounds, or one without any; and the bounds of
/// all.
fn widest<const N: usize>(parts: &[(Interval, Part<N>)]) -> (usize, Interval) {
    if let Some(undefined) = parts.iter().position(|(x, _)| x.low().is_nan()) {
        return (undefined, parts[undefined].0);
    }
    let (mut low, mut high, mut all) = (0, 0, parts[0].0);
    for (k, (x, _)) in parts.iter().enumerate() {
        if x.low() < parts[low].0.low() {
            low = k;
        }
        if x.high() > parts[high].0.high() {
            high = k;
        }
        all = all.hull(*x);
    }
    let wider = parts[low].0.width() >= parts[high].0.width();
    (if wider { low } else { high }, all)
}

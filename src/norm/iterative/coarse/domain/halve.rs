//! From a lattice to one with boxes twice as large: a spline there is Σ_k w_k b_(2I−3+k) along each axis, w = (1 4 6 4 1)/8.

use super::super::patch::Patch;
use super::super::slabs::Slabs;
use super::super::stencil::Short;
use super::galerkin::planes;
use super::level::{Kind, Level};
use super::rows::{Plane, from_site};
use crate::norm::iterative::number::Number;
use crate::parallel::{collect, for_chunks};
use std::borrow::Cow;

/// The two-scale relation.
const WEIGHTS: [f64; 5] = [0.125, 0.5, 0.75, 0.5, 0.125];

/// How many splines along an axis the coarser lattice has.
pub(super) fn halved(side: usize) -> usize {
    (side - 3).div_ceil(2) + 3
}

/// The fine splines, of `side`, that a coarse one is made of: the first, and the one behind the last.
fn children(coarse: usize, side: usize) -> (usize, usize) {
    ((2 * coarse).saturating_sub(3), (2 * coarse + 2).min(side))
}

/// The weight of a child.
#[inline]
fn weight(coarse: usize, fine: usize) -> f64 {
    WEIGHTS[fine + 3 - 2 * coarse]
}

/// The coarse splines that are made of some fine ones, `low` ≤ i < `high`.
fn parents(low: usize, high: usize) -> (usize, usize) {
    (low / 2, (high + 2) / 2 + 1)
}

/// One axis: the sums over the children of the coarse splines from `to.0` to `to.1`, of the numbers of the fine ones from
/// `from.0` to `from.1`; `inner` numbers belong to each.
fn gather<T: Number>(x: &[T], inner: usize, from: (usize, usize), to: (usize, usize), y: &mut [T]) {
    for coarse in to.0..to.1 {
        let y = &mut y[(coarse - to.0) * inner..][..inner];
        let (first, end) = children(coarse, from.1);
        for fine in first.max(from.0)..end {
            let weight = T::of(weight(coarse, fine));
            let x = &x[(fine - from.0) * inner..][..inner];
            for (y, x) in y.iter_mut().zip(x) {
                *y += weight * *x;
            }
        }
    }
}

/// The transpose of [`gather`] for all splines of an axis.
fn spread(x: &[Short], inner: usize, coarse: usize, fine: usize, y: &mut [Short]) {
    for (parent, x) in x.chunks_exact(inner).enumerate().take(coarse) {
        let (first, end) = children(parent, fine);
        for child in first..end {
            let weight = weight(parent, child) as Short;
            let y = &mut y[child * inner..][..inner];
            for (y, x) in y.iter_mut().zip(x) {
                *y += weight * x;
            }
        }
    }
}

/// The dual vector of the coarser lattice from that of the finer one.
pub(super) fn restrict<const N: usize>(x: &[Short], sides: &[usize; N]) -> Vec<Short> {
    let (mut x, mut inner) = (Cow::Borrowed(x), 1);
    for &side in sides {
        let coarse = halved(side);
        let outer = x.len() / (inner * side);
        let mut y = vec![0.0; inner * coarse * outer];
        for_chunks(&mut y, inner * coarse, |i, y| {
            let x = &x[i * inner * side..][..inner * side];
            gather(x, inner, (0, side), (0, coarse), y);
        });
        x = Cow::Owned(y);
        inner *= coarse;
    }
    x.into_owned()
}

/// The spline of the coarser lattice on the finer one.
pub(super) fn prolong<const N: usize>(mut x: Vec<Short>, sides: &[usize; N]) -> Vec<Short> {
    let mut inner = 1;
    for &side in sides {
        let coarse = halved(side);
        let outer = x.len() / (inner * coarse);
        let mut y = vec![0.0; inner * side * outer];
        for_chunks(&mut y, inner * side, |i, y| {
            let x = &x[i * inner * coarse..][..inner * coarse];
            spread(x, inner, coarse, side, y);
        });
        x = y;
        inner *= side;
    }
    x
}

/// The splines of the coarser lattice that a tensor on the finer one is handed on to.
fn reduced_patch<const N: usize>(patch: &Patch<N>) -> Patch<N> {
    let ends = |axis: usize| parents(patch.low[axis], patch.high[axis]);
    Patch {
        low: std::array::from_fn(|axis| ends(axis).0),
        high: std::array::from_fn(|axis| ends(axis).1),
    }
}

/// A tensor on the finer lattice handed on: the numbers on [`reduced_patch`].
fn reduce<const N: usize>(patch: &Patch<N>, numbers: &[f64]) -> Vec<f64> {
    let (reduced, mut x, mut inner) = (reduced_patch(patch), numbers.to_vec(), 1);
    for axis in 0..N {
        let from = (patch.low[axis], patch.high[axis]);
        let to = (reduced.low[axis], reduced.high[axis]);
        let (before, after) = (inner * (from.1 - from.0), inner * (to.1 - to.0));
        let mut y = vec![0.0; x.len() / before * after];
        for (x, y) in x.chunks_exact(before).zip(y.chunks_exact_mut(after)) {
            gather(x, inner, from, to, y);
        }
        x = y;
        inner = after;
    }
    x
}

/// Half of a symmetric form has each pair of splines once, and the diagonal by halves: the form is it and its transpose. What a row
/// of it has from the spline itself on, as a tensor on the row's box.
fn half<T: Copy + Into<f64>>(len: usize, first: usize, numbers: &[T]) -> Vec<f64> {
    let mut tensor = vec![0.0; len];
    for (to, &x) in tensor[first..].iter_mut().zip(numbers) {
        *to = x.into();
    }
    tensor[first] *= 0.5;
    tensor
}

/// The rows of half a level's form, their columns handed on to the coarser lattice.
struct Halfway<'a, const N: usize> {
    level: &'a Level<N>,
    stored: Vec<Plane<N>>,
    /// Those of deep splines, by the parities of their places: bit by axis.
    deep: Vec<Vec<f64>>,
}

impl<'a, const N: usize> Halfway<'a, N> {
    fn new(level: &'a Level<N>) -> Self {
        let rows = |plane: &Plane<N>| {
            let rows = plane.rows.iter();
            Plane::new(rows.map(|row| (row.spline, reduced_patch(&row.patch), 0)))
        };
        let mut stored: Vec<Plane<N>> = level.planes.iter().map(rows).collect();
        for_chunks(&mut stored, 1, |plane, stored| {
            let (from, Plane { rows, values, .. }) = (&level.planes[plane], &mut stored[0]);
            for (row, to) in from.rows.iter().zip(rows) {
                let tensor = half(row.patch.len(), row.first, from.numbers(row));
                let reduced = reduce(&row.patch, &tensor);
                for (to, x) in values[to.range()].iter_mut().zip(reduced) {
                    *to = x as _;
                }
            }
        });
        let by_parity = |bits: usize| {
            let site = std::array::from_fn(|axis| 4 + (bits >> axis & 1));
            let (patch, first) = from_site(&Patch::<N>::around(&site, 3, &[9; N]), &site);
            reduce(&patch, &half(patch.len(), first, level.half_stencil()))
        };
        Self {
            level,
            stored,
            deep: (0..1 << N).map(by_parity).collect(),
        }
    }

    /// The splines that a row has numbers for now.
    fn patch(&self, at: usize) -> Patch<N> {
        let unit = self.level.plane();
        match self.level.kinds[at] {
            Kind::Idle => Patch::EMPTY,
            Kind::Deep => {
                let site = Patch::whole(&self.level.sides).site(at);
                let around = Patch::around(&site, 3, &self.level.sides);
                reduced_patch(&from_site(&around, &site).0)
            }
            Kind::Stored => {
                let row = self.stored[at / unit].row(at % unit);
                row.expect("a stored row").patch
            }
        }
    }

    /// Adds a multiple of a row to one that is as large or larger.
    fn add(&self, at: usize, factor: f64, patch: &Patch<N>, sums: &mut [f64]) {
        let unit = self.level.plane();
        match self.level.kinds[at] {
            Kind::Idle => (),
            Kind::Deep => {
                let site = Patch::whole(&self.level.sides).site(at);
                let bits = (0..N).map(|axis| (site[axis] & 1) << axis).sum::<usize>();
                patch.add(sums, &self.patch(at), &self.deep[bits], |x| factor * x);
            }
            Kind::Stored => {
                let plane = &self.stored[at / unit];
                let row = plane.row(at % unit).expect("a stored row");
                patch.add(sums, &row.patch, plane.numbers(row), |x| {
                    factor * f64::from(x)
                });
            }
        }
    }

    /// The splines of the coarser lattice for which one of them has numbers in H, see [`Level::halved`].
    fn patch_of_sum(&self, site: &[usize; N]) -> Patch<N> {
        let mut patch = Patch::EMPTY;
        self.level
            .for_children(site, |at, _| patch.join(&self.patch(at)));
        patch
    }

    /// These numbers.
    fn sum(&self, site: &[usize; N], patch: &Patch<N>) -> Vec<f64> {
        let mut sums = vec![0.0; patch.len()];
        self.level
            .for_children(site, |at, factor| self.add(at, factor, patch, &mut sums));
        sums
    }
}

/// The rows of H, see [`Level::halved`], on the coarser lattice.
struct Sums<'a, const N: usize> {
    halfway: Halfway<'a, N>,
    whole: Patch<N>,
    kinds: Vec<Kind>,
    patches: Vec<Patch<N>>,
}

impl<'a, const N: usize> Sums<'a, N> {
    fn new(level: &'a Level<N>, sides: &[usize; N]) -> Self {
        let (halfway, whole) = (Halfway::new(level), Patch::whole(sides));
        let kinds = collect(whole.len(), |at| level.kind_of_sum(&whole.site(at)));
        let patches = collect(whole.len(), |at| match kinds[at] {
            Kind::Idle => Patch::EMPTY,
            _ => halfway.patch_of_sum(&whole.site(at)),
        });
        Self {
            halfway,
            whole,
            kinds,
            patches,
        }
    }

    /// The splines before this one for which it has numbers and which have a stored row, with their places in its box.
    fn before(&self, at: usize) -> impl Iterator<Item = (usize, [usize; N])> {
        let (patch, site) = (&self.patches[at], self.whole.site(at));
        let sites = patch.sites().take(patch.position(&site)).enumerate();
        sites.filter(|(_, other)| self.kinds[self.whole.position(other)] == Kind::Stored)
    }

    /// The splines that are somewhere in H but in no row of a spline that is not stored.
    fn splines(&self) -> Vec<usize> {
        let splines = 0..self.kinds.len();
        let counts = |&at: &usize| match self.kinds[at] {
            Kind::Idle => false,
            Kind::Stored => true,
            Kind::Deep => self.before(at).next().is_some(),
        };
        splines.filter(counts).collect()
    }

    /// The boxes of the rows of H + Hᵀ.
    fn symmetric(&self, splines: &[usize]) -> Vec<Patch<N>> {
        let mut patches = self.patches.clone();
        for &at in splines {
            let only = Patch::around(&self.whole.site(at), 0, &self.whole.high);
            for (_, other) in self.before(at) {
                patches[self.whole.position(&other)].join(&only);
            }
        }
        patches
    }

    /// Adds what H has of a spline to the rows of H + Hᵀ, of which those are there that begin with plane `first`.
    fn add(&self, at: usize, planes: &mut [Plane<N>], first: usize) {
        let (site, patch) = (self.whole.site(at), &self.patches[at]);
        let unit = self.whole.len() / self.whole.high[N - 1];
        let mut numbers = self.halfway.sum(&site, patch);
        let row_of = |site: &[usize; N], plane: &Plane<N>| {
            let row = plane.row(self.whole.position(site) % unit);
            *row.expect("a stored row")
        };
        for (place, other) in self.before(at) {
            let plane = &mut planes[other[N - 1] - first];
            let row = row_of(&other, plane);
            plane.values[row.place(&site)] += numbers[place] as Short;
        }
        if self.kinds[at] == Kind::Stored {
            numbers[patch.position(&site)] *= 2.0;
            let plane = &mut planes[site[N - 1] - first];
            let row = row_of(&site, plane);
            row.add(&site, patch, &numbers, &mut plane.values, |x| x as Short);
        }
    }
}

impl<const N: usize> Level<N> {
    /// The same form on the coarser lattice's splines, Galerkin's way: H + Hᵀ with H = W A Wᵀ for half of the form, A.
    pub fn halved(&self) -> Self {
        let sides = self.sides.map(halved);
        let sums = Sums::new(self, &sides);
        let splines = sums.splines();
        let mut planes = planes(&sides, &sums.kinds, &sums.symmetric(&splines));
        // A spline adds to its own row and to those of splines at most two planes before it.
        let reached = |&at: &usize| {
            let plane = sums.whole.site(at)[N - 1];
            (at as u32, sums.patches[at].low[N - 1], plane + 1)
        };
        let slabs = Slabs::new(planes.len(), splines.iter().map(reached).collect());
        slabs.add_up(&mut planes, 1, |splines, planes, first| {
            for &at in splines {
                sums.add(at as usize, planes, first);
            }
        });
        let scale = 2.0_f64.powi(N as i32 - 4);
        let stencil = self.stencil.iter().map(|x| scale * x).collect();
        Self::new(sides, sums.kinds, planes, stencil)
    }

    /// What is known of the row of a spline of the coarser lattice.
    fn kind_of_sum(&self, site: &[usize; N]) -> Kind {
        let (mut deep, mut idle, mut all) = (0, 0, 0);
        self.for_children(site, |at, _| {
            all += 1;
            deep += usize::from(self.kinds[at] == Kind::Deep);
            idle += usize::from(self.kinds[at] == Kind::Idle);
        });
        match () {
            () if idle == all => Kind::Idle,
            () if deep == 5_usize.pow(N as u32) => Kind::Deep,
            () => Kind::Stored,
        }
    }

    /// The splines that one of the coarser lattice is made of, with their weights.
    fn for_children(&self, site: &[usize; N], mut work: impl FnMut(usize, f64)) {
        let ends: [(usize, usize); N] =
            std::array::from_fn(|axis| children(site[axis], self.sides[axis]));
        let patch = Patch {
            low: ends.map(|(low, _)| low),
            high: ends.map(|(_, high)| high),
        };
        let whole = Patch::whole(&self.sides);
        for child in patch.sites() {
            let factor = (0..N).map(|axis| weight(site[axis], child[axis])).product();
            work(whole.position(&child), factor);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Mesh, SplitMix64};
    use crate::norm::hhj::Hhj;
    use crate::norm::iterative::cg::dot;
    use crate::norm::iterative::coarse::domain::{background, galerkin};
    use crate::norm::iterative::coarse::transfer::Transfer;
    use crate::norm::iterative::skeleton::Skeleton;
    use crate::norm::iterative::smoother::Smoothed;
    use std::sync::Arc;

    /// On every lattice a spline has the energy that it has on the finer one, and the form is symmetric.
    #[test]
    fn energies_are_those_of_the_finer_lattice() {
        let mesh = Mesh::<3>::cube(8).unwrap().perturbed(0.05, 5).unwrap();
        let hhj = Arc::new(Hhj::new(&mesh, 3).unwrap());
        let skeleton = Arc::new(Skeleton::new(&mesh, 3));
        let transfer = Transfer::new(&hhj, &skeleton, background(&hhj).unwrap());
        let mut fine = galerkin::finest(&transfer);
        let energy = |level: &Level<3>, x: &[Short], y: &[Short]| {
            let mut image = vec![0.0; x.len()];
            level.apply(x, &mut image, &mut level.room());
            dot(&image, y)
        };
        for lattice in 1..=2 {
            let coarse = fine.halved();
            let has = |level: &Level<3>, kind| level.kinds.contains(&kind);
            assert!(has(&coarse, Kind::Stored) && (lattice == 2 || has(&fine, Kind::Deep)));
            let mut random = SplitMix64::new(lattice);
            let mut spline = || {
                let mut x: Vec<Short> = (0..coarse.kinds.len())
                    .map(|_| random.symmetric() as Short)
                    .collect();
                coarse.clear(&mut x);
                x
            };
            let (x, y) = (spline(), spline());
            let finer = |x: &[Short]| {
                let mut finer = prolong(x.to_vec(), &fine.sides);
                fine.clear(&mut finer);
                finer
            };
            let expected = energy(&fine, &finer(&x), &finer(&y));
            let scale = (energy(&coarse, &x, &x) * energy(&coarse, &y, &y)).sqrt();
            for found in [energy(&coarse, &x, &y), energy(&coarse, &y, &x)] {
                assert!(
                    (found - expected).abs() < 1e-5 * scale,
                    "{found}, {expected}, {scale}"
                );
            }
            fine = coarse;
        }
    }
}

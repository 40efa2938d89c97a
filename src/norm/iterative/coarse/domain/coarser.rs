//! The form on a lattice with boxes twice as large, Galerkin's way: H + Hᵀ with H = W A Wᵀ for half of the form, A, in which each
//! pair of splines is once.

use super::super::patch::Patch;
use super::super::slabs::Slabs;
use super::super::stencil::Short;
use super::galerkin::planes;
use super::halve::{children, halved, reduce, reduced_patch, weight};
use super::level::{Kind, Level};
use super::rows::{Plane, from_site};
use crate::parallel::{collect, for_chunks};

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

    /// The splines of which H has something for a stored row: the stored ones, and deep ones near them.
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
    use crate::norm::iterative::coarse::domain::{background, galerkin, halve::prolong};
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

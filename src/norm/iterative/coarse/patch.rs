//! Boxes of lattice sites, and tensors of numbers on them, the first axis running fastest.

/// The sites with `low` ≤ index < `high` along every axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Patch<const N: usize> {
    pub low: [usize; N],
    pub high: [usize; N],
}

impl<const N: usize> Patch<N> {
    /// Without any site.
    pub const EMPTY: Self = Self {
        low: [usize::MAX; N],
        high: [0; N],
    };

    /// All sites of a lattice.
    pub fn whole(sides: &[usize; N]) -> Self {
        Self {
            low: [0; N],
            high: *sides,
        }
    }

    /// The sites at most `reach` from a site along every axis, of those that a lattice has.
    pub fn around(site: &[usize; N], reach: usize, sides: &[usize; N]) -> Self {
        Self {
            low: site.map(|i| i.saturating_sub(reach)),
            high: std::array::from_fn(|axis| (site[axis] + reach + 1).min(sides[axis])),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.high[0] == 0
    }

    /// How many sites along each axis.
    pub fn sides(&self) -> [usize; N] {
        std::array::from_fn(|axis| self.high[axis].saturating_sub(self.low[axis]))
    }

    /// How many sites.
    pub fn len(&self) -> usize {
        self.sides().iter().product()
    }

    /// The least box with these sites and those of another box.
    pub fn join(&mut self, other: &Self) {
        for axis in 0..N {
            self.low[axis] = self.low[axis].min(other.low[axis]);
            self.high[axis] = self.high[axis].max(other.high[axis]);
        }
    }

    /// Where a site is in a tensor on this box.
    #[inline]
    pub fn position(&self, site: &[usize; N]) -> usize {
        let (mut position, mut stride) = (0, 1);
        for axis in 0..N {
            position += (site[axis] - self.low[axis]) * stride;
            stride *= self.high[axis] - self.low[axis];
        }
        position
    }

    /// The site at a place of a tensor on this box.
    #[inline]
    pub fn site(&self, mut position: usize) -> [usize; N] {
        std::array::from_fn(|axis| {
            let side = self.high[axis] - self.low[axis];
            let index = position % side;
            position /= side;
            self.low[axis] + index
        })
    }

    /// The first site of each line along the first axis.
    #[inline]
    pub fn lines(&self) -> Lines<N> {
        let along = self.sides()[0];
        Lines {
            patch: *self,
            next: self.low,
            left: self.len().checked_div(along).unwrap_or(0),
        }
    }

    /// The lines from a site of the box on, with their lengths; the first one begins there.
    #[inline]
    pub fn lines_from(
        &self,
        site: &[usize; N],
    ) -> impl Iterator<Item = ([usize; N], usize)> + use<N> {
        let along = self.sides()[0];
        let before = self.position(site) / along;
        let mut next = *site;
        next[0] = self.low[0];
        let lines = Lines {
            patch: *self,
            next,
            left: self.len() / along - before,
        };
        let first = (*site, self.high[0] - site[0]);
        std::iter::once(first).chain(lines.skip(1).map(move |line| (line, along)))
    }

    /// All sites.
    pub fn sites(&self) -> impl Iterator<Item = [usize; N]> + use<N> {
        let along = self.sides()[0];
        self.lines().flat_map(move |line| {
            (0..along).map(move |i| {
                let mut site = line;
                site[0] += i;
                site
            })
        })
    }

    /// Adds a tensor on a box within this one, number by number as `convert` makes them.
    pub fn add<A: std::ops::AddAssign, B: Copy>(
        &self,
        to: &mut [A],
        from: &Self,
        tensor: &[B],
        convert: impl Fn(B) -> A,
    ) {
        let along = from.sides()[0];
        for (line, tensor) in from.lines().zip(tensor.chunks_exact(along)) {
            let begin = self.position(&line);
            for (to, x) in to[begin..begin + along].iter_mut().zip(tensor) {
                *to += convert(*x);
            }
        }
    }
}

/// The lines of a [`Patch`].
pub(super) struct Lines<const N: usize> {
    patch: Patch<N>,
    next: [usize; N],
    left: usize,
}

impl<const N: usize> Iterator for Lines<N> {
    type Item = [usize; N];

    #[inline]
    fn next(&mut self) -> Option<[usize; N]> {
        self.left = self.left.checked_sub(1)?;
        let line = self.next;
        for axis in 1..N {
            self.next[axis] += 1;
            if self.next[axis] < self.patch.high[axis] {
                break;
            }
            self.next[axis] = self.patch.low[axis];
        }
        Some(line)
    }
}

//! Products of small constant matrices with rows of lanes.
//!
//! faer's dense products were tried: with matrices as small as these the norm of a ball of 20 149 tetrahedra, p = 3, took 2.4 s
//! where it takes 2.3 with all of B̂ in one product, zeros included, and 2.1 with these loops.

use super::number::Number;

/// How many sums of a lane are added up side by side.
const SUMS: usize = 4;
/// Of so many bytes of lanes: they fit into registers.
const BYTES: usize = 128;

/// A matrix from some rows to others.
#[derive(Clone, Debug)]
pub(super) struct Product<T> {
    from: Vec<usize>,
    to: Vec<usize>,
    /// The entries of [`SUMS`] results, zero beyond the last, of one row after the other that they are made from, and then the
    /// next results'.
    entries: Vec<[T; SUMS]>,
}

impl<T: Number> Product<T> {
    /// `entry(row, column)` is what row `column`, of those in `from`, adds to row `row`, of those in `to`.
    pub fn new(from: &[usize], to: &[usize], entry: &dyn Fn(usize, usize) -> T) -> Self {
        let mut entries = Vec::new();
        for rows in to.chunks(SUMS) {
            let of_column = |&column: &usize| {
                std::array::from_fn(|i| rows.get(i).map_or(T::ZERO, |&row| entry(row, column)))
            };
            entries.extend(from.iter().map(of_column));
        }
        Self {
            from: from.to_vec(),
            to: to.to_vec(),
            entries,
        }
    }

    /// y = M x in the rows that the matrix reaches.
    pub fn set(&self, x: &[T], y: &mut [T], lanes: usize) {
        self.apply(x, y, lanes, |y, sum| *y = sum);
    }

    /// y += M x.
    pub fn add(&self, x: &[T], y: &mut [T], lanes: usize) {
        self.apply(x, y, lanes, |y, sum| *y += sum);
    }

    #[inline(always)]
    fn apply(&self, x: &[T], y: &mut [T], lanes: usize, write: impl Fn(&mut T, T)) {
        match BYTES / size_of::<T>() {
            16 => self.by_lanes::<16>(x, y, lanes, write),
            _ => self.by_lanes::<32>(x, y, lanes, write),
        }
    }

    /// W lanes at a time.
    #[inline(always)]
    fn by_lanes<const W: usize>(
        &self,
        x: &[T],
        y: &mut [T],
        lanes: usize,
        write: impl Fn(&mut T, T),
    ) {
        let count = self.from.len();
        for (group, rows) in self.to.chunks(SUMS).enumerate() {
            // There may be none, and their sum is zero.
            let entries = &self.entries[group * count..][..count];
            for begin in (0..lanes).step_by(W) {
                let width = W.min(lanes - begin);
                let sums = self.sums::<W>(x, entries, lanes, begin, width);
                for (row, sums) in rows.iter().zip(&sums) {
                    let at = row * lanes + begin;
                    for (y, sum) in y[at..at + width].iter_mut().zip(sums) {
                        write(y, *sum);
                    }
                }
            }
        }
    }

    /// The sums of one group in some lanes.
    #[inline]
    fn sums<const W: usize>(
        &self,
        x: &[T],
        entries: &[[T; SUMS]],
        lanes: usize,
        begin: usize,
        width: usize,
    ) -> [[T; W]; SUMS] {
        let mut sums = [[T::ZERO; W]; SUMS];
        for (row, entries) in self.from.iter().zip(entries) {
            let row = &x[row * lanes + begin..][..width];
            match row.first_chunk::<W>() {
                Some(row) => add(&mut sums, entries, row),
                None => {
                    let mut padded = [T::ZERO; W];
                    padded[..width].copy_from_slice(row);
                    add(&mut sums, entries, &padded);
                }
            }
        }
        sums
    }

    /// How many numbers the matrix has.
    pub fn len(&self) -> usize {
        self.from.len() * self.to.len()
    }
}

#[inline(always)]
fn add<T: Number, const W: usize>(sums: &mut [[T; W]; SUMS], entries: &[T; SUMS], row: &[T; W]) {
    for (sums, entry) in sums.iter_mut().zip(entries) {
        for (sum, x) in sums.iter_mut().zip(row) {
            *sum = sum.plus_product(*entry, *x);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Entry by entry, in whole numbers, for more and fewer lanes and rows than are taken at a time.
    fn entry_by_entry<T: Number + std::fmt::Debug>() {
        let entry = |i: usize, j: usize| T::of((3 * i * i + 5 * j + i * j) as f64 - 7.0);
        for (lanes, inputs, outputs) in [(64, 3, 9), (5, 1, 4), (41, 7, 2), (32, 0, 5)] {
            let from: Vec<usize> = (1..=inputs).rev().collect();
            let to: Vec<usize> = (0..outputs).map(|i| 3 * i + 2).collect();
            let product = Product::new(&from, &to, &entry);
            let numbers = (0..(inputs + 1) * lanes).map(|i| (i % 13) as f64);
            let x: Vec<T> = numbers.map(T::of).collect();
            let mut y = vec![T::ONE; 3 * outputs * lanes];
            product.add(&x, &mut y, lanes);
            let mut expected = vec![T::ONE; y.len()];
            for (&i, &j) in to.iter().flat_map(|i| from.iter().map(move |j| (i, j))) {
                for lane in 0..lanes {
                    expected[i * lanes + lane] += entry(i, j) * x[j * lanes + lane];
                }
            }
            assert_eq!(y, expected, "{lanes} lanes");
            product.set(&x, &mut y, lanes);
            for &i in &to {
                for at in i * lanes..(i + 1) * lanes {
                    assert_eq!(y[at], expected[at] - T::ONE, "{lanes} lanes");
                }
            }
        }
    }

    #[test]
    fn in_both_precisions() {
        entry_by_entry::<f64>();
        entry_by_entry::<f32>();
    }
}

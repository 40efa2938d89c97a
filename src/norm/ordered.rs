//! Loops over cells: on several threads where the feature `parallel` allows it, the results in the cells' order.

use std::ops::Range;

/// f of each index, in order.
#[cfg(feature = "parallel")]
pub(super) fn ordered_map<T: Send>(
    range: Range<usize>,
    f: impl Fn(usize) -> T + Sync + Send,
) -> Vec<T> {
    use rayon::iter::{IntoParallelIterator, ParallelIterator};
    range.into_par_iter().map(f).collect()
}

/// f of each index, in order.
#[cfg(not(feature = "parallel"))]
pub(super) fn ordered_map<T>(range: Range<usize>, f: impl Fn(usize) -> T) -> Vec<T> {
    range.map(f).collect()
}

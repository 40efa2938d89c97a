//! Floor 1. Work over many items, by threads where the feature `parallel` is on, with results taken in order.

/// How many items are computed before their results are consumed: bounds the memory for results.
const BATCH: usize = 8192;

/// The same for [`rows_in_order`], whose results shall stay in the cache.
const ROWS: usize = 2048;

/// `compute(i)` for i = 0…count−1, in any order and by several threads; `consume(i, …)` in ascending order.
///
/// What `consume` sees does not depend on the number of threads, so sums made by it do not either.
pub(crate) fn in_order<R: Send>(
    count: usize,
    compute: impl Fn(usize) -> R + Sync,
    mut consume: impl FnMut(usize, R),
) {
    for start in (0..count).step_by(BATCH) {
        let end = (start + BATCH).min(count);
        for (i, result) in (start..end).zip(map(start, end, &compute)) {
            consume(i, result);
        }
    }
}

#[cfg(feature = "parallel")]
fn map<R: Send>(start: usize, end: usize, compute: &(impl Fn(usize) -> R + Sync)) -> Vec<R> {
    use rayon::prelude::*;
    (start..end)
        .into_par_iter()
        .with_min_len(16)
        .map(compute)
        .collect()
}

#[cfg(not(feature = "parallel"))]
fn map<R: Send>(start: usize, end: usize, compute: &(impl Fn(usize) -> R + Sync)) -> Vec<R> {
    (start..end).map(compute).collect()
}

/// [`in_order`] for results of one length: `compute(i, row)` fills a row of `width` ≥ 1 entries, `zero` before.
pub(crate) fn rows_in_order<R: Copy + Send + Sync>(
    count: usize,
    width: usize,
    zero: R,
    compute: impl Fn(usize, &mut [R]) + Sync,
    mut consume: impl FnMut(usize, &[R]),
) {
    let mut table = vec![zero; width * ROWS.min(count)];
    for start in (0..count).step_by(ROWS) {
        let rows = &mut table[..width * ROWS.min(count - start)];
        rows.fill(zero);
        fill(rows, width, &|i, row: &mut [R]| compute(start + i, row));
        for (i, row) in rows.chunks_exact(width).enumerate() {
            consume(start + i, row);
        }
    }
}

#[cfg(feature = "parallel")]
fn fill<R: Send>(rows: &mut [R], width: usize, compute: &(impl Fn(usize, &mut [R]) + Sync)) {
    use rayon::prelude::*;
    rows.par_chunks_exact_mut(width)
        .enumerate()
        .with_min_len(16)
        .for_each(|(i, row)| compute(i, row));
}

#[cfg(not(feature = "parallel"))]
fn fill<R: Send>(rows: &mut [R], width: usize, compute: &(impl Fn(usize, &mut [R]) + Sync)) {
    for (i, row) in rows.chunks_exact_mut(width).enumerate() {
        compute(i, row);
    }
}

//! Floor 1. Work over many items, by threads where the feature `parallel` is on, with results taken in order.
//!
//! Inside, what is done for an item is a `&dyn Fn`, so that the machinery of threads is compiled once for each type of result
//! and not once for each piece of work.

/// How many items are computed before their results are consumed: bounds the memory for results.
const BATCH: usize = 8192;

/// The same for [`rows_in_order`], whose results shall stay in the cache.
const ROWS: usize = 2048;

/// How many items a thread takes at least.
const GRAIN: usize = 16;

/// `compute(i)` for i = 0…count−1, in any order and by several threads; `consume(i, …)` in ascending order.
///
/// What `consume` sees does not depend on the number of threads, so sums made by it do not either.
pub(crate) fn in_order<R: Send>(
    count: usize,
    compute: impl Fn(usize) -> R + Sync,
    mut consume: impl FnMut(usize, R),
) {
    batches(count, &compute, &mut consume);
}

fn batches<R: Send>(
    count: usize,
    compute: &(dyn Fn(usize) -> R + Sync),
    consume: &mut dyn FnMut(usize, R),
) {
    for start in (0..count).step_by(BATCH) {
        let end = (start + BATCH).min(count);
        for (i, result) in (start..end).zip(map(start, end, compute)) {
            consume(i, result);
        }
    }
}

/// [`in_order`] with the results in a list.
pub(crate) fn collect<R: Send>(count: usize, compute: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let mut all = Vec::with_capacity(count);
    batches(count, &compute, &mut |_, result| all.push(result));
    all
}

#[cfg(feature = "parallel")]
fn map<R: Send>(start: usize, end: usize, compute: &(dyn Fn(usize) -> R + Sync)) -> Vec<R> {
    use rayon::prelude::*;
    (start..end)
        .into_par_iter()
        .with_min_len(GRAIN)
        .map(compute)
        .collect()
}

#[cfg(not(feature = "parallel"))]
fn map<R: Send>(start: usize, end: usize, compute: &(dyn Fn(usize) -> R + Sync)) -> Vec<R> {
    (start..end).map(compute).collect()
}

/// [`in_order`] for results of one length: `compute(i, row, room)` fills a row of `width` ≥ 1 entries, `zero` before. `room` is
/// a thread's own, as the last item left it.
pub(crate) fn rows_in_order<R: Copy + Send + Sync, W: Send>(
    count: usize,
    width: usize,
    zero: R,
    room: impl Fn() -> W + Sync,
    compute: impl Fn(usize, &mut [R], &mut W) + Sync,
    mut consume: impl FnMut(usize, &[R]),
) {
    rows(count, width, zero, &room, &compute, &mut consume);
}

fn rows<R: Copy + Send + Sync, W: Send>(
    count: usize,
    width: usize,
    zero: R,
    room: &(dyn Fn() -> W + Sync),
    compute: &(dyn Fn(usize, &mut [R], &mut W) + Sync),
    consume: &mut dyn FnMut(usize, &[R]),
) {
    let mut table = vec![zero; width * ROWS.min(count)];
    for start in (0..count).step_by(ROWS) {
        let rows = &mut table[..width * ROWS.min(count - start)];
        rows.fill(zero);
        fill(rows, width, GRAIN, room, &|i, row, room| {
            compute(start + i, row, room);
        });
        for (i, row) in rows.chunks_exact(width).enumerate() {
            consume(start + i, row);
        }
    }
}

/// `work(i, chunk i)` for the consecutive chunks of `data` of this length (the last may be shorter), in any order and
/// by several threads.
#[cfg(feature = "norms")]
pub(crate) fn for_chunks<T: Send>(
    data: &mut [T],
    length: usize,
    work: impl Fn(usize, &mut [T]) + Sync,
) {
    fill(data, length, 1, &|| (), &|i, chunk, ()| work(i, chunk));
}

/// A thread takes `grain` chunks at least.
#[cfg(feature = "parallel")]
fn fill<R: Send, W: Send>(
    data: &mut [R],
    length: usize,
    grain: usize,
    room: &(dyn Fn() -> W + Sync),
    work: &(dyn Fn(usize, &mut [R], &mut W) + Sync),
) {
    use rayon::prelude::*;
    data.par_chunks_mut(length)
        .enumerate()
        .with_min_len(grain)
        .for_each_init(room, |room, (i, chunk)| work(i, chunk, room));
}

#[cfg(not(feature = "parallel"))]
fn fill<R: Send, W: Send>(
    data: &mut [R],
    length: usize,
    _grain: usize,
    room: &(dyn Fn() -> W + Sync),
    work: &(dyn Fn(usize, &mut [R], &mut W) + Sync),
) {
    let mut room = room();
    for (i, chunk) in data.chunks_mut(length).enumerate() {
        work(i, chunk, &mut room);
    }
}

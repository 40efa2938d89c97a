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

/// [`in_order`] for results of one length: `compute(i, row, room)` fills a row of `width` entries, `zero` before. `room` is a
/// thread's own, as the last item left it.
pub(crate) fn rows_in_order<R: Copy + Send + Sync, W: Send>(
    count: usize,
    width: usize,
    zero: R,
    room: impl Fn() -> W + Sync,
    compute: impl Fn(usize, &mut [R], &mut W) + Sync,
    mut consume: impl FnMut(usize, &[R]),
) {
    let (first, none) = ((width, zero), (0, ()));
    two_rows(
        count,
        first,
        none,
        &room,
        &|i, row, _, room| compute(i, row, room),
        &mut |i, row, _| consume(i, row),
    );
}

/// [`rows_in_order`] for results of two kinds: a row of each, by their widths.
pub(crate) fn two_rows_in_order<R, S, W>(
    count: usize,
    first: (usize, R),
    second: (usize, S),
    room: impl Fn() -> W + Sync,
    compute: impl Fn(usize, &mut [R], &mut [S], &mut W) + Sync,
    mut consume: impl FnMut(usize, &[R], &[S]),
) where
    R: Copy + Send + Sync,
    S: Copy + Send + Sync,
    W: Send,
{
    two_rows(count, first, second, &room, &compute, &mut consume);
}

fn two_rows<R: Copy + Send + Sync, S: Copy + Send + Sync, W: Send>(
    count: usize,
    first: (usize, R),
    second: (usize, S),
    room: &(dyn Fn() -> W + Sync),
    compute: &(dyn Fn(usize, &mut [R], &mut [S], &mut W) + Sync),
    consume: &mut dyn FnMut(usize, &[R], &[S]),
) {
    let mut tables = (
        vec![first.1; first.0 * ROWS.min(count)],
        vec![second.1; second.0 * ROWS.min(count)],
    );
    for start in (0..count).step_by(ROWS) {
        let len = ROWS.min(count - start);
        tables.0.fill(first.1);
        tables.1.fill(second.1);
        let mut rest = (&mut tables.0[..], &mut tables.1[..]);
        let known = "a table has as many rows";
        let mut rows: Vec<(&mut [R], &mut [S])> = (0..len)
            .map(|_| {
                let row = rest.0.split_off_mut(..first.0).expect(known);
                (row, rest.1.split_off_mut(..second.0).expect(known))
            })
            .collect();
        fill(&mut rows, 1, GRAIN, room, &|i, rows, room| {
            let (row, other) = &mut rows[0];
            compute(start + i, row, other, room);
        });
        for (i, (row, other)) in rows.into_iter().enumerate() {
            consume(start + i, row, other);
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

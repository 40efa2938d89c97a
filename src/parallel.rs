//! Floor 1. Work over many items, by threads where the feature `parallel` is on, with results taken in order.
//!
//! Threads are started in one function, [`spread`], that knows nothing of types: it is compiled once, in this library, and not
//! for each type of result in each crate that uses it. [`sort`] is the exception, and is used in this library alone.

use std::sync::{Mutex, PoisonError};

/// How many items are computed before their results are consumed: bounds the memory for results, and they shall stay in the cache.
const BATCH: usize = 2048;

/// How many items a piece of work has at least.
const GRAIN: usize = 16;

/// Into how many pieces work is divided at most: more than a machine has threads, so that none waits long for the others.
const PIECES: usize = 128;

/// `work(i)` for every i below `count`, in any order and by several threads.
#[cfg(feature = "parallel")]
fn spread(count: usize, work: &(dyn Fn(usize) + Sync)) {
    use rayon::prelude::*;
    (0..count).into_par_iter().for_each(work);
}

#[cfg(not(feature = "parallel"))]
fn spread(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).for_each(work);
}

/// Does `work` on one of the threads that compute: it hands pieces to the others without being sent to sleep and woken for each
/// [`spread`], of which a step of an iteration has hundreds.
#[cfg(all(feature = "norms", feature = "parallel"))]
pub(crate) fn within<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    rayon::scope(|_| work())
}

/// Does `work`.
#[cfg(all(feature = "norms", not(feature = "parallel")))]
pub(crate) fn within<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    work()
}

/// `work(i, piece i)` for all pieces, in any order and by several threads.
fn for_pieces<P: Send>(pieces: impl Iterator<Item = P>, work: &(dyn Fn(usize, P) + Sync)) {
    let pieces: Vec<_> = pieces.map(|piece| Mutex::new(Some(piece))).collect();
    spread(pieces.len(), &|i| {
        let piece = pieces[i]
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .take();
        work(i, piece.expect("a piece is worked on once"));
    });
}

/// Rooms in which pieces are worked on, one after the other: as many are made as threads want one at a time.
struct Rooms<'a, W> {
    make: &'a (dyn Fn() -> W + Sync),
    free: Mutex<Vec<W>>,
}

impl<'a, W> Rooms<'a, W> {
    fn new(make: &'a (dyn Fn() -> W + Sync)) -> Self {
        Self {
            make,
            free: Mutex::default(),
        }
    }

    /// A room as the last piece left it, or a new one.
    fn take(&self) -> W {
        let free = self
            .free
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .pop();
        free.unwrap_or_else(self.make)
    }

    fn give_back(&self, room: W) {
        let mut free = self.free.lock().unwrap_or_else(PoisonError::into_inner);
        free.push(room);
    }
}

/// How many of so many items make a piece, of `grain` at least.
fn piece_of(count: usize, grain: usize) -> usize {
    count.div_ceil(PIECES).max(grain)
}

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

/// Sorts what has no two equal items, so that there is one result.
#[cfg(feature = "parallel")]
pub(crate) fn sort<T: Ord + Send>(items: &mut [T]) {
    use rayon::prelude::*;
    items.par_sort_unstable();
}

/// Sorts what has no two equal items, so that there is one result.
#[cfg(not(feature = "parallel"))]
pub(crate) fn sort<T: Ord + Send>(items: &mut [T]) {
    items.sort_unstable();
}

/// `compute(i)` for start ≤ i < end.
fn map<R: Send>(
    start: usize,
    end: usize,
    compute: &(dyn Fn(usize) -> R + Sync),
) -> impl Iterator<Item = R> {
    let (count, length) = (end - start, piece_of(end - start, GRAIN));
    let mut results: Vec<Vec<R>> = (0..count.div_ceil(length)).map(|_| Vec::new()).collect();
    for_pieces(results.iter_mut(), &|piece, results| {
        let first = start + piece * length;
        results.extend((first..(first + length).min(end)).map(compute));
    });
    results.into_iter().flatten()
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
        vec![first.1; first.0 * BATCH.min(count)],
        vec![second.1; second.0 * BATCH.min(count)],
    );
    let (rooms, known) = (Rooms::new(room), "a table has as many rows");
    for start in (0..count).step_by(BATCH) {
        let len = BATCH.min(count - start);
        tables.0.fill(first.1);
        tables.1.fill(second.1);
        let length = piece_of(len, GRAIN);
        let mut rest = (&mut tables.0[..], &mut tables.1[..]);
        let pieces = (0..len).step_by(length).map(|from| {
            let items = from..(from + length).min(len);
            let rows = rest.0.split_off_mut(..first.0 * items.len());
            let others = rest.1.split_off_mut(..second.0 * items.len());
            (items, rows.expect(known), others.expect(known))
        });
        for_pieces(pieces, &|_, (items, rows, others)| {
            let mut room = rooms.take();
            for (i, item) in items.enumerate() {
                let row = &mut rows[i * first.0..][..first.0];
                let other = &mut others[i * second.0..][..second.0];
                compute(start + item, row, other, &mut room);
            }
            rooms.give_back(room);
        });
        for i in 0..len {
            let row = &tables.0[i * first.0..][..first.0];
            consume(start + i, row, &tables.1[i * second.0..][..second.0]);
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
    for_chunks_in(data, length, || (), |i, chunk, ()| work(i, chunk));
}

/// [`for_chunks`] with a room: `work(i, chunk i, room)`. `room` is a thread's own, as the last chunk left it.
#[cfg(feature = "norms")]
pub(crate) fn for_chunks_in<T: Send, W: Send>(
    data: &mut [T],
    length: usize,
    room: impl Fn() -> W + Sync,
    work: impl Fn(usize, &mut [T], &mut W) + Sync,
) {
    chunks([data], length, &room, &|i, [chunk], room| {
        work(i, chunk, room)
    });
}

/// [`for_chunks_in`] for the chunks of some lists of one length.
#[cfg(feature = "norms")]
pub(crate) fn for_chunks_together<T: Send, W: Send, const M: usize>(
    data: [&mut [T]; M],
    length: usize,
    room: impl Fn() -> W + Sync,
    work: impl Fn(usize, [&mut [T]; M], &mut W) + Sync,
) {
    chunks(data, length, &room, &work);
}

/// `work(i, part i of each list)` for consecutive parts of some lists, by their lengths, in any order and by several threads.
#[cfg(feature = "norms")]
pub(crate) fn for_parts<T: Send, const M: usize>(
    data: [&mut [T]; M],
    lengths: impl Iterator<Item = usize>,
    work: impl Fn(usize, [&mut [T]; M]) + Sync,
) {
    let mut rest = data;
    let parts = lengths.map(|length| {
        let lists = rest.each_mut();
        lists.map(|list| list.split_off_mut(..length).expect("parts of a list"))
    });
    for_pieces(parts, &work);
}

#[cfg(feature = "norms")]
fn chunks<T: Send, W: Send, const M: usize>(
    data: [&mut [T]; M],
    length: usize,
    room: &(dyn Fn() -> W + Sync),
    work: &(dyn Fn(usize, [&mut [T]; M], &mut W) + Sync),
) {
    let len = data.iter().map(|list| list.len()).max().unwrap_or(0);
    let many = piece_of(len.div_ceil(length), 1);
    let rooms = Rooms::new(room);
    for_pieces(together(data, many * length), &|piece, data| {
        let mut room = rooms.take();
        for (i, chunks) in (piece * many..).zip(together(data, length)) {
            work(i, chunks, &mut room);
        }
        rooms.give_back(room);
    });
}

/// The chunks of some lists of one length, side by side.
#[cfg(feature = "norms")]
fn together<T, const M: usize>(
    data: [&mut [T]; M],
    length: usize,
) -> impl Iterator<Item = [&mut [T]; M]> {
    let mut lists = data.map(|list| list.chunks_mut(length));
    std::iter::from_fn(move || {
        let chunks = lists.each_mut().map(Iterator::next);
        // Lists of one length end together.
        chunks[0]
            .is_some()
            .then(|| chunks.map(|chunk| chunk.expect("lists of one length")))
    })
}

/// Zeros that are written: those that the system gives are pages of its own until they are, and to read such a page first, as
/// adding to an entry does, is to be given it twice, while other threads that want one wait. Without these, sparse systems take 7 to 11 %
/// more of the processor, and two threads five times as long for the splines' stored rows.
#[cfg(feature = "norms")]
pub(crate) fn zeros<T: Clone + Default>(len: usize) -> Vec<T> {
    let mut zeros = Vec::with_capacity(len);
    zeros.resize(len, T::default());
    zeros
}

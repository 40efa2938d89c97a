//! Lists of what a closure yields. A closure that is mapped and collected costs five functions for each scalar and dimension
//! that it is compiled for; inlined where it is called, a loop costs none.

/// f(0), f(1), …, f(len − 1).
#[inline(always)]
pub fn list<T>(len: usize, mut f: impl FnMut(usize) -> T) -> Vec<T> {
    let mut all = Vec::with_capacity(len);
    for k in 0..len {
        all.push(f(k));
    }
    all
}

/// f of each item.
#[inline(always)]
pub fn each<X, T>(items: &[X], mut f: impl FnMut(&X) -> T) -> Vec<T> {
    list(items.len(), |k| f(&items[k]))
}

/// f of the items of two lists of one length, side by side.
#[inline(always)]
pub fn pairwise<X, Y, T>(xs: &[X], ys: &[Y], mut f: impl FnMut(&X, &Y) -> T) -> Vec<T> {
    assert_eq!(xs.len(), ys.len(), "the lists belong together");
    list(xs.len(), |k| f(&xs[k], &ys[k]))
}

/// `[i·len + j]` = f(i, j).
#[inline(always)]
pub fn table<T>(len: usize, mut f: impl FnMut(usize, usize) -> T) -> Vec<T> {
    list(len * len, |k| f(k / len, k % len))
}

/// The numbers below `len` that are not among these.
pub fn others(len: usize, these: &[usize]) -> Vec<usize> {
    (0..len).filter(|k| !these.contains(k)).collect()
}

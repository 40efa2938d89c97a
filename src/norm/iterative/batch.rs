//! Some cells side by side: every number of a cell is a lane of a row, and rows are what loops and products run over.

use super::number::Number;
use super::packed::lower;
use crate::norm::hhj::Hhj;
use crate::norm::hhj::cell::raise;
use crate::norm::hhj::element::Element;
use crate::parallel::for_chunks;
use nalgebra::DMatrix;

/// How many cells are worked on side by side: their rows fit into the second cache.
pub(super) const CELLS: usize = 64;

/// The geometry of all cells, batch after batch, row by row.
#[derive(Clone, Debug)]
pub(super) struct Geometry<T> {
    numbers: Vec<T>,
    /// How many rows a batch has: |det J|; g^{ij} by pairs; ±h_f by face; p τ_v by face and vertex of the face.
    rows: usize,
}

impl<T: Number> Geometry<T> {
    /// Of the mesh's cells in this order.
    pub fn new<const N: usize>(hhj: &Hhj<N>, cells: &[u32]) -> Self {
        let element = hhj.element();
        let rows = 1 + element.pairs.len() + (N + 1) * (N + 1);
        let mut numbers = vec![T::ZERO; rows * cells.len()];
        for_chunks(&mut numbers, CELLS * rows, |batch, numbers| {
            let lanes = numbers.len() / rows;
            for lane in 0..lanes {
                let shape = hhj.shape(cells[batch * CELLS + lane] as usize);
                let inverse = element.pairs.iter().map(|&pair| shape.inverse[pair]);
                let heights = shape.faces.iter().map(|face| face.height);
                let tangents = shape.faces.iter().flat_map(|face| face.tangent);
                let tangents = tangents.map(|tau| element.degree as f64 * tau);
                let all = std::iter::once(shape.volume).chain(inverse);
                for (row, number) in all.chain(heights).chain(tangents).enumerate() {
                    numbers[row * lanes + lane] = T::of(number);
                }
            }
        });
        Self { numbers, rows }
    }
}

/// The geometry of some cells, lane by lane.
pub(super) struct Batch<'a, T> {
    /// How many cells.
    pub lanes: usize,
    /// The symmetric weights W_ab that stand between B̂ᵀ and B̂, b ≤ a: row [`lower`].
    weights: Vec<T>,
    /// ±h_f, by face.
    heights: &'a [T],
    /// p τ_v, by face and vertex of the face.
    tangents: &'a [T],
    /// Room for the bubbles' energy.
    energy: Vec<T>,
}

impl<'a, T: Number> Batch<'a, T> {
    /// No cells.
    pub const EMPTY: Self = Self {
        lanes: 0,
        weights: Vec::new(),
        heights: &[],
        tangents: &[],
        energy: Vec::new(),
    };

    /// To one of the batches of consecutive cells.
    pub fn turn_to<const N: usize>(
        &mut self,
        element: &Element<N>,
        geometry: &'a Geometry<T>,
        batch: usize,
    ) {
        let unit = CELLS * geometry.rows;
        let numbers = &geometry.numbers[batch * unit..];
        let numbers = &numbers[..unit.min(numbers.len())];
        let (n, pairs) = (numbers.len() / geometry.rows, element.pairs.len());
        let (volume, rest) = numbers.split_at(n);
        let (inverse, rest) = rest.split_at(pairs * n);
        let (heights, tangents) = rest.split_at((N + 1) * n);
        let position = |i: usize, j: usize| {
            let mut pairs = element.pairs.iter();
            pairs.position(|&pair| pair == (i.min(j), i.max(j)))
        };
        let q = |i: usize, j: usize| row(inverse, position(i, j).expect("a pair"), n);
        self.weights.resize(lower(pairs, 0) * n, T::ZERO);
        for a in 0..pairs {
            for b in 0..=a {
                let ((i, j), (k, l)) = (element.pairs[a], element.pairs[b]);
                let factors = [q(i, k), q(j, l), q(i, l), q(j, k)];
                let target = row_mut(&mut self.weights, lower(a, b), n);
                for (lane, (w, volume)) in target.iter_mut().zip(volume).enumerate() {
                    *w = *volume * raise(factors.map(|row| row[lane]));
                }
            }
        }
        (self.lanes, self.heights, self.tangents) = (n, heights, tangents);
    }

    /// (u, û) without the bubbles becomes (u, ŵ): ŵ_β = ±h û_β − p (Σ_v τ_v u_{β+e_v} − u_{β+e_f}).
    pub fn shift<const N: usize>(&self, element: &Element<N>, x: &mut [T]) {
        let (n, bubbles) = (self.lanes, element.layout.bubbles);
        for (f, moments) in element.layout.faces.iter().enumerate() {
            for moment in moments {
                let slope = moment.slope - bubbles;
                scale(row_mut(x, slope, n), row(self.heights, f, n));
                for (v, &raised) in moment.raised.iter().enumerate() {
                    let tangent = row(self.tangents, f * N + v, n);
                    let (target, source) = two_rows(x, slope, raised - bubbles, n);
                    subtract(target, tangent, source);
                }
                if let Some(opposite) = element.layout.opposite(moment) {
                    let (target, source) = two_rows(x, slope, opposite - bubbles, n);
                    add(target, T::of(element.degree as f64), source);
                }
            }
        }
    }

    /// The transpose of [`Batch::shift`].
    pub fn shift_back<const N: usize>(&self, element: &Element<N>, x: &mut [T]) {
        let (n, bubbles) = (self.lanes, element.layout.bubbles);
        for (f, moments) in element.layout.faces.iter().enumerate() {
            for moment in moments {
                let slope = moment.slope - bubbles;
                for (v, &raised) in moment.raised.iter().enumerate() {
                    let tangent = row(self.tangents, f * N + v, n);
                    let (target, source) = two_rows(x, raised - bubbles, slope, n);
                    subtract(target, tangent, source);
                }
                if let Some(opposite) = element.layout.opposite(moment) {
                    let (target, source) = two_rows(x, opposite - bubbles, slope, n);
                    add(target, T::of(element.degree as f64), source);
                }
                scale(row_mut(x, slope, n), row(self.heights, f, n));
            }
        }
    }

    /// z = (W ⊗ I) y, both with rows a·size + k.
    pub fn weigh(&self, pairs: usize, size: usize, y: &[T], z: &mut [T]) {
        let n = self.lanes;
        for k in 0..size {
            for a in 0..pairs {
                let target = row_mut(z, a * size + k, n);
                target.fill(T::ZERO);
                let term = |b: usize| {
                    let weights = row(&self.weights, lower(a.max(b), a.min(b)), n);
                    weights.iter().zip(row(y, b * size + k, n))
                };
                // Three at a time: there are three pairs in the plane and six in space, and a sum is loaded and stored less often.
                for b in (0..pairs).step_by(3) {
                    let terms = term(b).zip(term(b + 1)).zip(term(b + 2));
                    for (t, ((p, q), r)) in target.iter_mut().zip(terms) {
                        let sum = t.plus_product(*p.0, *p.1).plus_product(*q.0, *q.1);
                        *t = sum.plus_product(*r.0, *r.1);
                    }
                }
            }
        }
    }

    /// t becomes (B̂_bᵀ (W ⊗ I) B̂_b)⁻¹ t for the bubbles b, by Cholesky's method lane by lane. `gram` has a matrix for each of the
    /// weights.
    pub fn solve_bubbles(&mut self, gram: &[DMatrix<T>], t: &mut [T]) {
        let (n, bubbles, a) = (self.lanes, t.len() / self.lanes, &mut self.energy);
        a.clear();
        a.resize(bubbles * bubbles * n, T::ZERO);
        for (w, gram) in self.weights.chunks_exact(n).zip(gram) {
            for i in 0..bubbles {
                for j in 0..=i {
                    let g = gram[(i, j)];
                    for (a, w) in row_mut(a, i * bubbles + j, n).iter_mut().zip(w) {
                        *a += g * *w;
                    }
                }
            }
        }
        for lane in 0..n {
            let at = |i: usize, j: usize| (i * bubbles + j) * n + lane;
            for j in 0..bubbles {
                let square = sum((0..j).map(|k| a[at(j, k)] * a[at(j, k)]));
                a[at(j, j)] = (a[at(j, j)] - square).root();
                for i in j + 1..bubbles {
                    let sum = sum((0..j).map(|k| a[at(i, k)] * a[at(j, k)]));
                    a[at(i, j)] = (a[at(i, j)] - sum) / a[at(j, j)];
                }
            }
            for i in 0..bubbles {
                let sum = sum((0..i).map(|j| a[at(i, j)] * t[j * n + lane]));
                t[i * n + lane] = (t[i * n + lane] - sum) / a[at(i, i)];
            }
            for i in (0..bubbles).rev() {
                let sum = sum((i + 1..bubbles).map(|j| a[at(j, i)] * t[j * n + lane]));
                t[i * n + lane] = (t[i * n + lane] - sum) / a[at(i, i)];
            }
        }
    }
}

/// Row i of rows of n lanes.
#[inline]
pub(super) fn row<T: Number>(x: &[T], i: usize, n: usize) -> &[T] {
    &x[i * n..(i + 1) * n]
}

/// Row i of rows of n lanes.
#[inline]
pub(super) fn row_mut<T: Number>(x: &mut [T], i: usize, n: usize) -> &mut [T] {
    &mut x[i * n..(i + 1) * n]
}

/// Row i to be changed, and another row j.
#[inline]
fn two_rows<T: Number>(x: &mut [T], i: usize, j: usize, n: usize) -> (&mut [T], &[T]) {
    if i < j {
        let (low, high) = x.split_at_mut(j * n);
        (&mut low[i * n..(i + 1) * n], &high[..n])
    } else {
        let (low, high) = x.split_at_mut(i * n);
        (&mut high[..n], &low[j * n..(j + 1) * n])
    }
}

fn scale<T: Number>(x: &mut [T], factor: &[T]) {
    for (x, f) in x.iter_mut().zip(factor) {
        *x *= *f;
    }
}

fn subtract<T: Number>(x: &mut [T], factor: &[T], y: &[T]) {
    for ((x, f), y) in x.iter_mut().zip(factor).zip(y) {
        *x = x.plus_product(-*f, *y);
    }
}

fn add<T: Number>(x: &mut [T], factor: T, y: &[T]) {
    for (x, y) in x.iter_mut().zip(y) {
        *x = x.plus_product(factor, *y);
    }
}

fn sum<T: Number>(terms: impl Iterator<Item = T>) -> T {
    terms.fold(T::ZERO, |sum, term| sum + term)
}

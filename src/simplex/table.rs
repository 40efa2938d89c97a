//! Polynomials on an N-simplex at many points, with their derivatives.
//!
//! The derivatives of a polynomial in Bernstein form are polynomials of one degree less, whose coefficients are differences:
//! ∂_m Σ_α c_α B_α = Σ_β r (c_{β+e_{m+1}} − c_{β+e_0}) B_β, |α| = r, |β| = r − 1. So the differences are taken once for a cell,
//! and a point costs as many products as the derivatives have coefficients of their own: of a polynomial of degree 1, the
//! first derivatives cost one each and the second none.

use super::{Bernstein, Points, raised};
use crate::jet::{Jet1, Jet2};
use crate::linalg::{Mat, matrix, zeros};
use crate::scalar::{Field, Lift, Real};

/// Where the coefficients stand whose differences are those of a derivative.
#[derive(Clone, Copy, Debug)]
struct Difference<const N: usize> {
    /// β + e_0.
    origin: usize,
    /// β + e_{m+1}.
    along: [usize; N],
}

/// The derivatives of polynomials of one degree on an N-simplex, by their coefficients.
#[derive(Clone, Debug)]
pub struct Derivatives<const N: usize> {
    degree: usize,
    /// How many coefficients a polynomial has.
    size: usize,
    /// By β of degree r − 1.
    first: Vec<Difference<N>>,
    /// By β of degree r − 2.
    second: Vec<Difference<N>>,
}

impl<const N: usize> Derivatives<N> {
    /// Of polynomials of degree r.
    pub fn new(degree: usize) -> Self {
        let differences = |degree: usize| {
            let up = raised(N, degree);
            let difference = |up: &Vec<usize>| Difference {
                origin: up[0],
                along: std::array::from_fn(|m| up[m + 1]),
            };
            up.iter().map(difference).collect()
        };
        Self {
            degree,
            size: Bernstein::new(N + 1, degree).len(),
            first: differences(degree),
            second: differences(degree.saturating_sub(1)),
        }
    }

    /// The coefficients of this many polynomials, one polynomial after the other, in the order in which [`JetTable`] reads
    /// them, followed by those of their derivatives: c by α and polynomial, ∂_m c by β, polynomial and m, ∂_m∂_n c with m ≤ n
    /// by γ, polynomial, m and n.
    pub fn follow<C: Field>(&self, count: usize, coefficients: &[C]) -> Vec<C> {
        let size = coefficients.len() / count;
        let first = count * N;
        let width = size + N * self.first.len() + pairs(N) * self.second.len();
        let mut all = Vec::with_capacity(count * width);
        for alpha in 0..size {
            all.extend(coefficients[alpha..].iter().step_by(size));
        }
        let factors = [self.degree, self.degree.saturating_sub(1)].map(|r| C::from_int(r as i64));
        for beta in &self.first {
            for polynomial in 0..count {
                let c = |alpha: usize| coefficients[polynomial * size + alpha];
                let origin = c(beta.origin);
                all.extend(beta.along.map(|along| (c(along) - origin) * factors[0]));
            }
        }
        for gamma in &self.second {
            for derivative in (0..first).step_by(N) {
                for m in 0..N {
                    let start = count * size + derivative + m;
                    for along in &gamma.along[m..] {
                        let [a, b] = [*along, gamma.origin].map(|beta| all[start + beta * first]);
                        all.push((a - b) * factors[1]);
                    }
                }
            }
        }
        debug_assert_eq!(all.len(), count * width, "of one length for every cell");
        all
    }

    /// Calls `change` with what this many polynomials have for each α, β and γ: a chunk for each polynomial.
    pub fn each_row<C>(&self, count: usize, all: &mut [C], mut change: impl FnMut(&mut [C])) {
        let mut rest = all;
        let [values, first, second] = [self.size, self.first.len(), self.second.len()];
        for (rows, width) in [(values, 1), (first, N), (second, pairs(N))] {
            let own = rest.split_off_mut(..rows * width * count);
            let own = own.expect("polynomials are followed by their derivatives");
            own.chunks_exact_mut(width * count).for_each(&mut change);
        }
    }

    /// The coefficients of ∂_m of a single polynomial, from those that follow it.
    pub fn along<'a, C: Copy>(&self, c: &'a [C], m: usize) -> impl Iterator<Item = C> + 'a {
        let first = &c[self.size..][..N * self.first.len()];
        first.iter().skip(m).step_by(N).copied()
    }
}

/// All B_α of one degree at points, by blocks: `[block][α]`.
#[derive(Clone, Debug)]
struct Values<T> {
    size: usize,
    values: Vec<T>,
}

impl<T: Real> Values<T> {
    fn new(vertices: usize, degree: usize, points: &Points) -> Self {
        let basis = Bernstein::new(vertices, degree);
        Self {
            size: basis.len(),
            values: basis.tabulate(points).concat(),
        }
    }

    /// At a block.
    #[inline]
    fn at(&self, block: usize) -> &[T] {
        &self.values[block * self.size..][..self.size]
    }

    /// The coefficients of each B_α, `width` many, with its value at a block.
    #[inline]
    fn rows<'a, C>(
        &'a self,
        block: usize,
        c: &'a [C],
        width: usize,
    ) -> impl Iterator<Item = (&'a [C], T)> {
        c.chunks_exact(width).zip(self.at(block).iter().copied())
    }
}

/// Polynomials of one degree and their derivatives in the reference coordinates of an N-simplex at points, by blocks.
///
/// Polynomials are given by their coefficients and those of their derivatives, see [`Derivatives::follow`]: one, or the
/// components of a symmetric tensor.
#[derive(Clone, Debug)]
pub struct JetTable<T, const N: usize> {
    /// For the polynomial, its first and its second derivatives; the last are missing where these vanish.
    values: Values<T>,
    first: Option<Values<T>>,
    second: Option<Values<T>>,
}

impl<T: Real, const N: usize> JetTable<T, N> {
    /// For polynomials of degree r at points of the simplex.
    pub fn new(degree: usize, points: &Points) -> Self {
        let less = |k: usize| Some(Values::new(N + 1, degree.checked_sub(k)?, points));
        Self {
            values: Values::new(N + 1, degree, points),
            first: less(1),
            second: less(2),
        }
    }

    /// Of a polynomial, the value at a block; what follows its own coefficients may be missing.
    #[inline]
    pub fn value<C: Lift<T> + Copy>(&self, block: usize, c: &[C]) -> T {
        let mut sum = T::zero();
        for (c, b) in self.values.rows(block, c, 1) {
            sum.add_product(c[0].lift(), b);
        }
        sum
    }

    /// With first derivatives.
    #[inline]
    pub fn jet1<C: Lift<T> + Copy>(&self, block: usize, c: &[C]) -> Jet1<T, N> {
        let mut jet = Jet1::constant(self.value(block, c));
        if let Some(first) = &self.first {
            for (c, b) in first.rows(block, &c[self.values.size..], N) {
                for m in 0..N {
                    jet.d[m].add_product(c[m].lift(), b);
                }
            }
        }
        jet
    }

    /// With second derivatives.
    #[inline]
    pub fn jet2<C: Lift<T> + Copy>(&self, block: usize, c: &[C]) -> Jet2<T, N> {
        let lower = self.jet1(block, c);
        let mut jet = Jet2::constant(lower.value);
        jet.d = lower.d;
        if let (Some(first), Some(second)) = (&self.first, &self.second) {
            let c = &c[self.values.size + N * first.size..];
            for (c, b) in second.rows(block, c, pairs(N)) {
                each_pair::<N>(|k, m, n| jet.dd[m][n].add_product(c[k].lift(), b));
            }
            each_pair::<N>(|_, m, n| jet.dd[n][m] = jet.dd[m][n]);
        }
        jet
    }

    /// Of a symmetric tensor by its components, g_ii, then g_ij with i < j row by row: these at a block.
    #[inline]
    pub fn tensor<C: Lift<T> + Copy>(&self, block: usize, c: &[C]) -> Mat<T, N> {
        let mut sum: Mat<T, N> = zeros();
        for (c, b) in self.values.rows(block, c, pairs(N)) {
            each_component::<N>(|k, i, j| sum[(i, j)].add_product(c[k].lift(), b));
        }
        each_component::<N>(|_, i, j| sum[(j, i)] = sum[(i, j)]);
        sum
    }

    /// With first derivatives.
    #[inline]
    pub fn tensor1<C: Lift<T> + Copy>(&self, block: usize, c: &[C]) -> Mat<Jet1<T, N>, N> {
        let value = self.tensor(block, c);
        let mut jets = matrix(|i, j| Jet1::constant(value[(i, j)]));
        if let Some(first) = &self.first {
            let c = &c[pairs(N) * self.values.size..];
            for (c, b) in first.rows(block, c, pairs(N) * N) {
                each_component::<N>(|k, i, j| {
                    for m in 0..N {
                        jets[(i, j)].d[m].add_product(c[k * N + m].lift(), b);
                    }
                });
            }
        }
        each_component::<N>(|_, i, j| jets[(j, i)] = jets[(i, j)]);
        jets
    }

    /// With second derivatives.
    #[inline]
    pub fn tensor2<C: Lift<T> + Copy>(&self, block: usize, c: &[C]) -> Mat<Jet2<T, N>, N> {
        let lower = self.tensor1(block, c);
        let mut jets = matrix(|i, j| {
            let mut jet = Jet2::constant(lower[(i, j)].value);
            jet.d = lower[(i, j)].d;
            jet
        });
        if let (Some(first), Some(second)) = (&self.first, &self.second) {
            let c = &c[pairs(N) * (self.values.size + N * first.size)..];
            for (c, b) in second.rows(block, c, pairs(N) * pairs(N)) {
                each_component::<N>(|k, i, j| {
                    let c = &c[k * pairs(N)..][..pairs(N)];
                    each_pair::<N>(|k, m, n| jets[(i, j)].dd[m][n].add_product(c[k].lift(), b));
                });
            }
            each_component::<N>(|_, i, j| {
                let dd = &mut jets[(i, j)].dd;
                each_pair::<N>(|_, m, n| dd[n][m] = dd[m][n]);
                jets[(j, i)].dd = jets[(i, j)].dd;
            });
        }
        jets
    }
}

/// How many pairs i ≤ j < n there are.
#[inline(always)]
const fn pairs(n: usize) -> usize {
    n * (n + 1) / 2
}

/// All i ≤ j < N with their number, row by row. The bounds of both loops are constant, so that they can be unrolled.
#[inline(always)]
fn each_pair<const N: usize>(mut visit: impl FnMut(usize, usize, usize)) {
    let mut k = 0;
    for i in 0..N {
        for j in 0..N {
            if i <= j {
                visit(k, i, j);
                k += 1;
            }
        }
    }
}

/// All i, i, then all i < j < N row by row, with their number.
#[inline(always)]
fn each_component<const N: usize>(mut visit: impl FnMut(usize, usize, usize)) {
    for i in 0..N {
        visit(i, i, i);
    }
    let mut k = N;
    for i in 0..N {
        for j in 0..N {
            if i < j {
                visit(k, i, j);
                k += 1;
            }
        }
    }
}

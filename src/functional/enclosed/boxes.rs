//! A metric on a simplex as one of its cells sees it: bounds of its jets over all of it, and over either half.

use super::polynomial::{Exponents, derivatives, dot, places, range, tensor, turned};
use crate::jet::{Jet1, Jet2};
use crate::linalg::{Mat, Vector, apply, identity, ldlt};
use crate::scalar::Interval;
use crate::spaces::ReggeFunction;

/// Exponents of the degrees r, r − 1 and r − 2 (not below 0) on a simplex with this many vertices: for values and derivatives.
pub(super) fn exponents(vertices: usize, degree: usize) -> [Exponents; 3] {
    [0, 1, 2].map(|order| Exponents::new(vertices, degree.saturating_sub(order)))
}

/// The metric on a simplex, by its components and their derivatives in coordinates of the cell in which it is near δ.
///
/// Scalars do not depend on coordinates. But in these the bounds of a quotient are close to what they bound.
#[derive(Clone, Debug)]
pub(super) struct View<const N: usize> {
    /// By order of derivatives: polynomials, by Bernstein coefficients.
    polynomials: [Vec<Vec<Interval>>; 3],
    /// Covectors in these coordinates.
    pub nu: Vec<Vector<Interval, N>>,
}

/// What a cell shows of its metric.
#[derive(Clone, Debug)]
pub(super) struct OnCell<const N: usize> {
    pub whole: View<N>,
    /// Coordinates ξ = A η.
    pub a: Mat<Interval, N>,
}

impl<const N: usize> OnCell<N> {
    /// Of a metric whose coefficients are taken to be exact.
    pub fn new(g: &ReggeFunction<f64, N>, cell: usize, exponents: &[Exponents; 3]) -> Self {
        let flat = g.components(cell, Interval::exactly);
        let size = exponents[0].all.len();
        let components: Vec<Vec<Interval>> = flat.chunks_exact(size).map(<[_]>::to_vec).collect();
        let a = near_identity(&components);
        let values = turned(&components, &a);
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for component in &values {
            let d = along(&a, &derivatives(&exponents[0], &exponents[1], component));
            for (m, derivative) in d.iter().enumerate() {
                let dd = derivatives(&exponents[1], &exponents[2], derivative);
                second.extend_from_slice(&along(&a, &dd)[m..]);
            }
            first.extend(d);
        }
        let whole = View {
            polynomials: [values, first, second],
            nu: Vec::new(),
        };
        Self { whole, a }
    }

    /// On the simplex with these vertices of the cell, with the outward covectors of the faces around it.
    pub fn on(&self, vertices: &[usize], of: &[Exponents; 3], on: &[Exponents; 3]) -> View<N> {
        let trace = |order: usize| {
            let place = |beta: &Vec<usize>| {
                let mut alpha = vec![0; N + 1];
                for (v, e) in vertices.iter().zip(beta) {
                    alpha[*v] = *e;
                }
                of[order].place(&alpha)
            };
            let places: Vec<usize> = on[order].all.iter().map(place).collect();
            let polynomials = self.whole.polynomials[order].iter();
            let traced = |c: &Vec<Interval>| places.iter().map(|p| c[*p]).collect();
            polynomials.map(traced).collect()
        };
        let around = (0..=N).filter(|v| !vertices.contains(v));
        let nu = |v: usize| apply(&self.a.transpose(), &crate::density::outward(v));
        View {
            polynomials: [trace(0), trace(1), trace(2)],
            nu: around.map(nu).collect(),
        }
    }
}

/// A with Aᵀ g A near δ in the middle of the simplex. Any A will do, this one does best.
fn near_identity<const N: usize>(components: &[Vec<Interval>]) -> Mat<Interval, N> {
    let middle = |c: usize| {
        let sum: f64 = components[c].iter().map(|x| x.low()).sum();
        sum / components[c].len() as f64
    };
    let g = tensor::<N>(|c| Interval::exactly(middle(c))).map(Interval::low);
    let factors = ldlt(&g).factors;
    let mut a = identity::<f64, N>();
    // Lᵀ A = D^{−1/2}.
    for j in 0..N {
        for i in (0..=j).rev() {
            let start = if i == j { 1.0 } else { 0.0 };
            let sum: f64 = (i + 1..=j).map(|k| factors[(k, i)] * a[(k, j)]).sum();
            a[(i, j)] = start - sum;
        }
        let scale = factors[(j, j)].sqrt().recip();
        for i in 0..=j {
            a[(i, j)] *= scale;
        }
    }
    if a.iter().all(|x| x.is_finite()) {
        a.map(Interval::exactly)
    } else {
        identity()
    }
}

/// Derivatives in η from those in ξ = A η.
fn along<const N: usize>(a: &Mat<Interval, N>, d: &[Vec<Interval>; N]) -> [Vec<Interval>; N] {
    std::array::from_fn(|m| {
        let at = |beta: usize| dot(|k| a[(k, m)] * d[k][beta], N);
        (0..d[0].len()).map(at).collect()
    })
}

impl<const N: usize> View<N> {
    /// On the half in which a vertex is replaced by the middle of an edge.
    pub fn half(&self, exponents: &[Exponents; 3], kept: usize, gone: usize) -> Self {
        let mut half = self.clone();
        for (polynomials, exponents) in half.polynomials.iter_mut().zip(exponents) {
            for coefficients in polynomials {
                exponents.half(coefficients, kept, gone);
            }
        }
        half
    }

    /// g in all of its Bernstein coefficients.
    pub fn coefficients(&self) -> impl Iterator<Item = Mat<Interval, N>> {
        let values = &self.polynomials[0];
        (0..values[0].len()).map(|k| tensor(|c| values[c][k]))
    }

    /// g.
    pub fn value(&self) -> Mat<Interval, N> {
        tensor(|c| range(&self.polynomials[0][c]))
    }

    /// With first derivatives.
    pub fn jet1(&self) -> Mat<Jet1<Interval, N>, N> {
        let mut jets = self.value().map(Jet1::constant);
        for (c, (i, j)) in places::<N>().into_iter().enumerate() {
            let d = |m: usize| range(&self.polynomials[1][c * N + m]);
            jets[(i, j)].d = std::array::from_fn(d);
            jets[(j, i)] = jets[(i, j)];
        }
        jets
    }

    /// With second derivatives.
    pub fn jet2(&self) -> Mat<Jet2<Interval, N>, N> {
        let (first, pairs) = (self.jet1(), pairs::<N>());
        let mut jets = first.map(|x| {
            let mut jet = Jet2::constant(x.value);
            jet.d = x.d;
            jet
        });
        for (c, (i, j)) in places::<N>().into_iter().enumerate() {
            for (p, (m, n)) in pairs.iter().enumerate() {
                let x = range(&self.polynomials[2][c * pairs.len() + p]);
                jets[(i, j)].dd[*m][*n] = x;
                jets[(i, j)].dd[*n][*m] = x;
            }
            jets[(j, i)] = jets[(i, j)];
        }
        jets
    }
}

/// All m ≤ n, row by row.
fn pairs<const N: usize>() -> Vec<(usize, usize)> {
    (0..N).flat_map(|m| (m..N).map(move |n| (m, n))).collect()
}

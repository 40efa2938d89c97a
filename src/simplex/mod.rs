//! Floor 1. The combinatorics of a simplex: its faces, and polynomials in barycentric coordinates.
//!
//! The vertices of a simplex are always in ascending order of their global indices, so that a face looks the
//! same from both of its cells. The reference coordinates of a cell are ξ_i = λ_{i+1}, i = 0…N−1; vertex 0 is the
//! origin.

mod table;

pub use table::{Derivatives, JetTable};

use crate::jet::Jet2;
use crate::scalar::Real;

/// All subsets of {0, …, n−1} with `size` elements, ascending, in lexicographic order.
pub fn subsets(n: usize, size: usize) -> Vec<Vec<usize>> {
    fn extend(n: usize, size: usize, prefix: &mut Vec<usize>, all: &mut Vec<Vec<usize>>) {
        if prefix.len() == size {
            all.push(prefix.clone());
            return;
        }
        for v in prefix.last().map_or(0, |l| l + 1)..n {
            prefix.push(v);
            extend(n, size, prefix, all);
            prefix.pop();
        }
    }
    let mut all = Vec::new();
    extend(n, size, &mut Vec::new(), &mut all);
    all
}

/// The edges of the simplex with these vertices, in the order of [`subsets`].
pub(crate) fn edges_of(vertices: &[usize]) -> Vec<[usize; 2]> {
    subsets(vertices.len(), 2)
        .iter()
        .map(|edge| [vertices[edge[0]], vertices[edge[1]]])
        .collect()
}

/// Exponents α of length `variables` with |α| = `degree`, in descending lexicographic order.
pub fn multi_indices(variables: usize, degree: usize) -> Vec<Vec<usize>> {
    if variables == 1 {
        return vec![vec![degree]];
    }
    let mut all = Vec::new();
    for first in (0..=degree).rev() {
        for mut rest in multi_indices(variables - 1, degree - first) {
            rest.insert(0, first);
            all.push(rest);
        }
    }
    all
}

/// For each exponent β of degree r − 1 and each vertex v of an n-simplex, where β + e_v stands among the exponents of degree r;
/// nothing for r = 0.
pub(crate) fn raised(n: usize, degree: usize) -> Vec<Vec<usize>> {
    let Some(lower) = degree.checked_sub(1) else {
        return Vec::new();
    };
    let higher = multi_indices(n + 1, degree);
    let raise = |beta: &Vec<usize>, v: usize| {
        let mut alpha = beta.clone();
        alpha[v] += 1;
        let place = higher.iter().position(|a| *a == alpha);
        place.expect("raising an exponent of degree r − 1 gives one of degree r")
    };
    multi_indices(n + 1, lower)
        .iter()
        .map(|beta| (0..=n).map(|v| raise(beta, v)).collect())
        .collect()
}

/// n over k.
pub fn binomial(n: usize, k: usize) -> usize {
    if k > n {
        0
    } else {
        (0..k).fold(1, |b, i| b * (n - i) / (i + 1))
    }
}

/// n!.
pub fn factorial(n: usize) -> f64 {
    (1..=n).map(|i| i as f64).product()
}

/// Points in a simplex by barycentric coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    vertices: usize,
    lambda: Vec<f64>,
}

impl Points {
    /// Points of a simplex with this many `vertices`; `lambda` holds their coordinates point by point.
    ///
    /// # Panics
    /// If the length of `lambda` is not a multiple of `vertices`.
    pub fn new(vertices: usize, lambda: Vec<f64>) -> Self {
        assert!(vertices > 0 && lambda.len().is_multiple_of(vertices));
        Self { vertices, lambda }
    }

    /// How many points.
    pub fn len(&self) -> usize {
        self.lambda.len() / self.vertices
    }

    /// No point at all?
    pub fn is_empty(&self) -> bool {
        self.lambda.is_empty()
    }

    /// How many vertices the simplex has.
    pub fn vertices(&self) -> usize {
        self.vertices
    }

    /// The barycentric coordinates of point q.
    pub fn lambda(&self, q: usize) -> &[f64] {
        &self.lambda[q * self.vertices..(q + 1) * self.vertices]
    }

    /// The same points seen in a simplex with `n` vertices, of which `on` span the one that they lie in.
    pub fn embed(&self, on: &[usize], n: usize) -> Self {
        let mut lambda = vec![0.0; n * self.len()];
        for q in 0..self.len() {
            for (i, &v) in on.iter().enumerate() {
                lambda[q * n + v] = self.lambda(q)[i];
            }
        }
        Self {
            vertices: n,
            lambda,
        }
    }

    /// How many blocks of `T::LANES` points hold them all.
    pub fn blocks<T: Real>(&self) -> usize {
        self.len().div_ceil(T::LANES)
    }

    /// λ_v of the points of a block, one a lane; the last point fills lanes that are left over.
    pub fn block<T: Real>(&self, block: usize, v: usize) -> T {
        T::pack(|lane| self.lambda((block * T::LANES + lane).min(self.len() - 1))[v])
    }
}

/// Bernstein polynomials of one degree in the barycentric coordinates λ_0…λ_n: B_α = |α|!/α! λ^α.
///
/// They sum to one, and the trace of B_α on a face is the face's own Bernstein polynomial, or zero if α charges
/// a vertex outside the face.
#[derive(Clone, Debug)]
pub struct Bernstein {
    exponents: Vec<Vec<usize>>,
    scale: Vec<f64>,
}

impl Bernstein {
    /// The basis of P_degree on a simplex with this many vertices, in the order of [`multi_indices`].
    pub fn new(vertices: usize, degree: usize) -> Self {
        let exponents = multi_indices(vertices, degree);
        let scale = exponents
            .iter()
            .map(|a| factorial(degree) / a.iter().map(|&e| factorial(e)).product::<f64>())
            .collect();
        Self { exponents, scale }
    }

    /// The exponents α.
    pub fn exponents(&self) -> &[Vec<usize>] {
        &self.exponents
    }

    /// The dimension of the space.
    pub fn len(&self) -> usize {
        self.exponents.len()
    }

    /// Never: the constants are there.
    pub fn is_empty(&self) -> bool {
        self.exponents.is_empty()
    }

    /// B_α(λ), in any scalar: numbers, or jets of the coordinate functions.
    pub fn value<T: Real>(&self, alpha: usize, lambda: &[T]) -> T {
        let mut product = T::from_f64(self.scale[alpha]);
        for (v, &e) in self.exponents[alpha].iter().enumerate() {
            product *= crate::scalar::power(lambda[v], e as u32);
        }
        product
    }

    /// All B_α at the points, by blocks: `[block][α]`.
    pub fn tabulate<T: Real>(&self, points: &Points) -> Vec<Vec<T>> {
        (0..points.blocks::<T>())
            .map(|b| {
                let lambda: Vec<T> = (0..points.vertices()).map(|v| points.block(b, v)).collect();
                (0..self.len()).map(|a| self.value(a, &lambda)).collect()
            })
            .collect()
    }

    /// All B_α with their derivatives in the reference coordinates of an N-simplex: `[block][α]`.
    pub fn tabulate_jets<T: Real, const N: usize>(&self, points: &Points) -> Vec<Vec<Jet2<T, N>>> {
        (0..points.blocks::<T>())
            .map(|b| {
                let lambda = barycentric_jets::<T, N>(points, b);
                (0..self.len()).map(|a| self.value(a, &lambda)).collect()
            })
            .collect()
    }
}

/// λ_0…λ_N as jets in the reference coordinates, at the points of a block.
pub fn barycentric_jets<T: Real, const N: usize>(points: &Points, block: usize) -> Vec<Jet2<T, N>> {
    let mut origin = Jet2::constant(points.block::<T>(block, 0));
    origin.d = [-T::one(); N];
    let mut lambda = vec![origin];
    lambda.extend((0..N).map(|m| Jet2::coordinate(points.block::<T>(block, m + 1), m)));
    lambda
}

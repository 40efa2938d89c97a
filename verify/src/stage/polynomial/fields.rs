//! Domains, polynomial fields on them, and their jets at points.

use crate::harness::Ground;
use regge_curvature::density::outward;
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, apply, form, identity, inverse_and_det, symmetric};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::Field;

/// Where an identity is integrated.
pub(super) struct Domain<F: Ground, const N: usize> {
    /// The corners of each cell.
    pub cells: Vec<Vec<[F; N]>>,
    /// A covector normal to each face.
    normals: Vec<Vector<F, N>>,
    /// Is vertex 0 of all cells an interior one? Then v is to be a multiple of its hat function.
    pub inner_vertex: bool,
}

impl<F: Ground, const N: usize> Domain<F, N> {
    /// The reference simplex.
    pub(super) fn single() -> Self {
        let corner = |v: usize| std::array::from_fn(|k| F::from_int(i64::from(k + 1 == v)));
        Self {
            cells: vec![(0..=N).map(corner).collect()],
            normals: (0..=N).map(outward).collect(),
            inner_vertex: false,
        }
    }

    /// A simplex cut at an inner point.
    pub(super) fn cut() -> Self {
        let at = |c: i64| std::array::from_fn(|k| F::from_int(if k as i64 == c { 3 } else { 0 }));
        let corners: Vec<[F; N]> = (-1..N as i64).map(at).collect();
        let inner = [F::one(); N];
        let cell = |left_out: usize| {
            let kept = (0..=N).filter(|v| *v != left_out).map(|v| corners[v]);
            std::iter::once(inner).chain(kept).collect::<Vec<_>>()
        };
        let cells: Vec<Vec<[F; N]>> = (0..=N).map(cell).collect();
        let mut normals: Vec<Vector<F, N>> = Vec::new();
        for cell in &cells {
            normals.extend((0..=N).map(|f| barycentric(cell, f)));
        }
        // Each inner face is there from two cells, with normals that differ by a factor.
        let mut different: Vec<Vector<F, N>> = Vec::new();
        for nu in normals {
            if !different.iter().any(|other| parallel(other, &nu)) {
                different.push(nu);
            }
        }
        Self {
            cells,
            normals: different,
            inner_vertex: true,
        }
    }

    /// Degree of all integrands, which are products of v with the derivatives of 𝕊σ. Too low a number makes the claims
    /// fail.
    pub(super) fn degree(&self) -> usize {
        // v: 4 for each face, 1, and the hat function; 𝕊σ: 5; Γ: 3 for each of two derivatives; g⁻¹: 2 for each of two
        // contractions.
        4 * self.normals.len() + 1 + usize::from(self.inner_vertex) + 5 + 6 + 4
    }
}

/// dλ_v of the cell with these corners, as a global covector.
fn barycentric<F: Ground, const N: usize>(corners: &[[F; N]], v: usize) -> Vector<F, N> {
    let edges = Mat::<F, N>::from_fn(|a, m| corners[m + 1][a] - corners[0][a]);
    // Solves for J⁻¹ by the inverse of JᵀJ, which is symmetric.
    let gram =
        symmetric(|m, n| (0..N).fold(F::zero(), |sum, a| sum + edges[(a, m)] * edges[(a, n)]));
    let inverse = inverse_and_det(&gram).0;
    let local: Vector<F, N> = outward(v);
    let raised = apply(&inverse, &local);
    Vector::from_fn(|a, _| (0..N).fold(F::zero(), |sum, m| sum + edges[(a, m)] * raised[m]))
}

fn parallel<F: Ground, const N: usize>(a: &Vector<F, N>, b: &Vector<F, N>) -> bool {
    (0..N).all(|i| (0..i).all(|j| a[i] * b[j] == a[j] * b[i]))
}

/// Affine functions of x: L's entry, w, σ's components, and one for each cell.
pub(super) struct Fields<F: Ground, const N: usize> {
    pub numbers: Vec<F>,
}

/// g, σ and v with derivatives at a point of a cell, in the cell's coordinates.
pub(super) struct Point<F: Ground, const N: usize> {
    pub g: Mat<Jet2<F, N>, N>,
    pub inverse: Mat<Jet2<F, N>, N>,
    pub still: Connection<Jet1<F, N>, N>,
    pub sigma: Mat<Jet2<F, N>, N>,
    pub v: Jet2<F, N>,
}

impl<F: Ground, const N: usize> Fields<F, N> {
    const SIGMA: usize = 2;
    const CELLS: usize = Self::SIGMA + N * (N + 1) / 2;
    pub(super) const COUNT: usize = (Self::CELLS + N + 1) * (N + 1) + 1;

    /// The k-th affine function.
    fn affine(&self, k: usize, x: &[Jet2<F, N>; N]) -> Jet2<F, N> {
        let c = &self.numbers[k * (N + 1)..];
        let mut sum = Jet2::constant(c[N]);
        for i in 0..N {
            sum += Jet2::constant(c[i]) * x[i];
        }
        sum
    }

    /// g = L Lᵀ with an affine entry L_10 and, for N ≥ 3, a constant L_21.
    fn metric(&self, x: &[Jet2<F, N>; N]) -> Mat<Jet2<F, N>, N> {
        let mut l = identity::<Jet2<F, N>, N>();
        l[(1, 0)] = self.affine(0, x);
        if N > 2 {
            l[(2, 1)] = Jet2::constant(self.numbers[Self::COUNT - 1]);
        }
        symmetric(|i, j| {
            let mut sum = Jet2::zero();
            for k in 0..N {
                sum += l[(i, k)] * l[(j, k)];
            }
            sum
        })
    }

    fn sigma(&self, x: &[Jet2<F, N>; N]) -> Mat<Jet2<F, N>, N> {
        symmetric(|i, j| self.affine(Self::SIGMA + i * N - i * (i + 1) / 2 + j, x))
    }

    /// v, from its factor w, global g⁻¹ and the reference coordinates.
    fn v(
        &self,
        domain: &Domain<F, N>,
        x: &[Jet2<F, N>; N],
        xi: &[Jet2<F, N>; N],
        inverse: &Mat<Jet2<F, N>, N>,
    ) -> Jet2<F, N> {
        let mut v = self.affine(1, x);
        for nu in &domain.normals {
            let nu: Vector<Jet2<F, N>, N> = nu.map(Jet2::constant);
            let square = form(inverse, &nu, &nu);
            v *= square * square;
        }
        if domain.inner_vertex {
            let mut hat = Jet2::one();
            for x in xi {
                hat -= *x;
            }
            v *= hat;
        }
        v
    }

    /// All that is needed at the point of a cell with these barycentric coordinates of a subsimplex.
    pub(super) fn at(
        &self,
        domain: &Domain<F, N>,
        cell: usize,
        vertices: &[usize],
        lambda: &[F],
    ) -> Point<F, N> {
        let mut xi: [Jet2<F, N>; N] = std::array::from_fn(|i| Jet2::coordinate(F::zero(), i));
        for (v, l) in vertices.iter().zip(lambda) {
            if *v > 0 {
                xi[v - 1].value = *l;
            }
        }
        let corners = &domain.cells[cell];
        let x = position(corners, &xi);
        let global = self.metric(&x);
        let v = self.v(domain, &x, &xi, &inverse_and_det(&global).0);
        let mut sigma = pull_back(corners, &self.sigma(&x));
        if domain.inner_vertex && N == 2 {
            // Tangentially it is seen by the cell's edge on the boundary alone, so that σ(n,n) jumps.
            let [a, b] = [1, 2].map(outward::<Jet2<F, N>, N>);
            let c = self.affine(Self::CELLS + cell, &x);
            sigma = symmetric(|i, j| sigma[(i, j)] + c * (a[i] * b[j] + b[i] * a[j]));
        }
        let g = pull_back(corners, &global);
        Point {
            still: Connection::new(&g),
            inverse: inverse_and_det(&g).0,
            g,
            sigma,
            v,
        }
    }
}

/// J_am = ∂x_a/∂ξ_m.
fn edge<F: Ground, const N: usize>(corners: &[[F; N]], a: usize, m: usize) -> Jet2<F, N> {
    Jet2::constant(corners[m + 1][a] - corners[0][a])
}

/// x, from the reference coordinates ξ.
fn position<F: Ground, const N: usize>(
    corners: &[[F; N]],
    xi: &[Jet2<F, N>; N],
) -> [Jet2<F, N>; N] {
    std::array::from_fn(|a| {
        let start = Jet2::constant(corners[0][a]);
        (0..N).fold(start, |sum, m| sum + edge(corners, a, m) * xi[m])
    })
}

/// t(∂_m, ∂_n) = J_am J_bn t_ab.
fn pull_back<F: Ground, const N: usize>(
    corners: &[[F; N]],
    t: &Mat<Jet2<F, N>, N>,
) -> Mat<Jet2<F, N>, N> {
    symmetric(|m, n| {
        let mut sum = Jet2::zero();
        for a in 0..N {
            for b in 0..N {
                sum += edge(corners, a, m) * t[(a, b)] * edge(corners, b, n);
            }
        }
        sum
    })
}

//! Metrics given by a formula in the coordinates of ℝ^N, pulled back to the cells of a mesh.

use crate::Error;
use crate::field::{Ambient, Evaluate, TensorField};
use crate::jet::{Jet1, Jet2};
use crate::linalg::{Mat, Vector, symmetric, zeros};
use crate::mesh::Mesh;
use crate::scalar::{Number, Real};
use crate::simplex::Points;

/// A symmetric tensor by a formula. It is evaluated at jets of x, which makes its derivatives exact.
pub trait SmoothTensor<const N: usize>: Sync {
    /// g_ab at x, in the coordinates of ℝ^N.
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N>;

    /// Is the formula meant at this point?
    fn contains(&self, _x: &[f64; N]) -> bool {
        true
    }
}

impl<M: SmoothTensor<N>, const N: usize> Ambient<N> for M {
    fn jets_at(&self, x: &[f64; N]) -> Option<Mat<Jet2<f64, N>, N>> {
        let at = std::array::from_fn(|i| Jet2::coordinate(x[i], i));
        self.contains(x).then(|| self.at(&at))
    }
}

/// A formula on a mesh.
#[derive(Clone, Debug)]
pub struct Smooth<M, const N: usize> {
    mesh: Mesh<N>,
    formula: M,
}

impl<M: SmoothTensor<N>, const N: usize> Smooth<M, N> {
    /// The formula, pulled back to each cell of the mesh.
    ///
    /// # Errors
    /// If the mesh has no coordinates.
    pub fn new(mesh: &Mesh<N>, formula: M) -> Result<Self, Error> {
        if !mesh.has_coordinates() {
            return Err(Error::NoCoordinates("a formula"));
        }
        Ok(Self {
            mesh: mesh.clone(),
            formula,
        })
    }

    /// The formula.
    pub fn formula(&self) -> &M {
        &self.formula
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh<N> {
        &self.mesh
    }
}

/// The affine map x = origin + J ξ of a cell.
#[derive(Clone, Copy, Debug)]
pub struct AffineMap<const N: usize> {
    origin: Vector<f64, N>,
    jacobian: Mat<f64, N>,
}

impl<const N: usize> AffineMap<N> {
    /// x, from scalars or jets ξ.
    fn point<S: Real>(&self, xi: &[S; N]) -> [S; N] {
        std::array::from_fn(|a| {
            let mut x = S::from_f64(self.origin[a]);
            for m in 0..N {
                x += S::from_f64(self.jacobian[(a, m)]) * xi[m];
            }
            x
        })
    }

    /// g(∂_m, ∂_n) = J_am J_bn g_ab.
    fn pull_back<S: Real>(&self, g: &Mat<S, N>) -> Mat<S, N> {
        let jacobian = self.jacobian.map(S::from_f64);
        let mut g_j = zeros::<S, N>();
        for a in 0..N {
            for n in 0..N {
                for b in 0..N {
                    g_j[(a, n)] += g[(a, b)] * jacobian[(b, n)];
                }
            }
        }
        symmetric(|m, n| {
            let mut sum = S::zero();
            for a in 0..N {
                sum += jacobian[(a, m)] * g_j[(a, n)];
            }
            sum
        })
    }
}

impl<T: Real, M: SmoothTensor<N>, const N: usize> Evaluate<T, N> for Smooth<M, N> {
    /// Reference coordinates ξ by blocks.
    type Table = Vec<[T; N]>;
    type Local = AffineMap<N>;

    fn tabulate(&self, points: &Points) -> Self::Table {
        (0..points.blocks::<T>())
            .map(|b| std::array::from_fn(|m| points.block(b, m + 1)))
            .collect()
    }

    fn on_cell(&self, cell: usize) -> AffineMap<N> {
        let known = "the constructor saw to it that there are coordinates";
        AffineMap {
            origin: self.mesh.corner(cell, 0).expect(known),
            jacobian: self.mesh.jacobian(cell).expect(known),
        }
    }

    fn jet2(&self, map: &AffineMap<N>, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        let xi = std::array::from_fn(|m| Jet2::coordinate(table[block][m], m));
        map.pull_back(&self.formula.at(&map.point(&xi)))
    }

    fn jet1(&self, map: &AffineMap<N>, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        let xi = std::array::from_fn(|m| Jet1::coordinate(table[block][m], m));
        map.pull_back(&self.formula.at(&map.point(&xi)))
    }

    fn value(&self, map: &AffineMap<N>, table: &Self::Table, block: usize) -> Mat<T, N> {
        map.pull_back(&self.formula.at(&map.point(&table[block])))
    }

    fn ambient(&self) -> Option<&dyn Ambient<N>> {
        Some(&self.formula)
    }
}

impl<M: SmoothTensor<N>, const N: usize> TensorField<N> for Smooth<M, N> {
    type Scalar = f64;
    type Wide = <f64 as Number>::Wide;
}

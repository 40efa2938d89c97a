//! A formula on ℝ^D, seen on a surface or solid in it.

use super::Immersion;
use crate::Error;
use crate::field::{Evaluate, TensorField};
use crate::jet::{Jet1, Jet2};
use crate::linalg::{Mat, symmetric};
use crate::metrics::SmoothTensor;
use crate::scalar::{Number, Real};
use crate::simplex::{Derivatives, JetTable, Points};

/// F*g for a tensor g on ℝ^D by a formula: F*g(∂_i, ∂_j) = ∂_i F^a ∂_j F^b g_ab(F).
#[derive(Clone, Debug)]
pub struct Immersed<M, const N: usize, const D: usize> {
    immersion: Immersion<N>,
    formula: M,
    /// Of polynomials of degree k, and of degree k − 1.
    derivatives: [Derivatives<N>; 2],
}

impl<M: SmoothTensor<D>, const N: usize, const D: usize> Immersed<M, N, D> {
    /// The formula on what the immersion makes of its mesh.
    ///
    /// # Errors
    /// If F does not go to ℝ^D.
    pub fn new(immersion: Immersion<N>, formula: M) -> Result<Self, Error> {
        if immersion.width() != D {
            let m = immersion.width();
            let reason = format!("a formula in {D} coordinates on points with {m}");
            return Err(Error::Input(reason));
        }
        Ok(Self {
            derivatives: [0, 1].map(|less| Derivatives::new(immersion.degree() - less)),
            immersion,
            formula,
        })
    }

    /// F.
    pub fn immersion(&self) -> &Immersion<N> {
        &self.immersion
    }
}

/// What F is on a cell, component by component of ℝ^D; all coefficients are followed by those of derivatives.
pub struct LocalMap<const N: usize, const D: usize> {
    /// The control points of F.
    map: [Vec<f64>; D],
    /// Those of ∂_i F, polynomials of degree k − 1.
    first: [[Vec<f64>; N]; D],
}

impl<T: Real, M: SmoothTensor<D>, const N: usize, const D: usize> Evaluate<T, N>
    for Immersed<M, N, D>
{
    /// Polynomials of degree k, and of degree k − 1.
    type Table = [JetTable<T, N>; 2];
    type Local = LocalMap<N, D>;

    fn tabulate(&self, points: &Points) -> Self::Table {
        let degree = self.immersion.degree();
        [degree, degree - 1].map(|degree| JetTable::new(degree, points))
    }

    fn on_cell(&self, cell: usize) -> LocalMap<N, D> {
        let local = self.immersion.local(cell);
        let [all, less] = &self.derivatives;
        let map: [Vec<f64>; D] = std::array::from_fn(|c| {
            let component: Vec<f64> = local.iter().skip(c).step_by(D).copied().collect();
            all.follow(1, &component)
        });
        let first = std::array::from_fn(|c| {
            std::array::from_fn(|i| less.follow(1, &all.along(&map[c], i).collect::<Vec<f64>>()))
        });
        LocalMap { map, first }
    }

    fn jet2(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet2<T, N>, N> {
        let x = std::array::from_fn(|c| table[0].jet2(block, &local.map[c]));
        let g = self.formula.at::<Jet2<T, N>>(&x);
        pulled_back(&g, |c, i| table[1].jet2(block, &local.first[c][i]))
    }

    fn jet1(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<Jet1<T, N>, N> {
        let x = std::array::from_fn(|c| table[0].jet1(block, &local.map[c]));
        let g = self.formula.at::<Jet1<T, N>>(&x);
        pulled_back(&g, |c, i| table[1].jet1(block, &local.first[c][i]))
    }

    fn value(&self, local: &Self::Local, table: &Self::Table, block: usize) -> Mat<T, N> {
        let x = std::array::from_fn(|c| table[0].value(block, &local.map[c]));
        let g = self.formula.at::<T>(&x);
        pulled_back(&g, |c, i| table[1].value(block, &local.first[c][i]))
    }
}

/// ∂_i F^a ∂_j F^b g_ab.
fn pulled_back<S: Real, const N: usize, const D: usize>(
    g: &Mat<S, D>,
    first: impl Fn(usize, usize) -> S,
) -> Mat<S, N> {
    let d: [[S; N]; D] = std::array::from_fn(|a| std::array::from_fn(|i| first(a, i)));
    symmetric(|i, j| {
        let mut sum = S::zero();
        for a in 0..D {
            for b in 0..D {
                sum += d[a][i] * d[b][j] * g[(a, b)];
            }
        }
        sum
    })
}

impl<M: SmoothTensor<D>, const N: usize, const D: usize> TensorField<N> for Immersed<M, N, D> {
    type Scalar = f64;
    type Wide = <f64 as Number>::Wide;
}

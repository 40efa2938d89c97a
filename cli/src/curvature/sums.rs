//! The sums for all test functions of a degree, by an order of quadrature that is high enough.

use super::report::Parts;
use super::settle::{Entries, Settled, settle_sums};
use super::{Boundary, CurvatureError};
use regge_curvature::functional::{Rules, Sums, boundary_curvature, distributional_curvature};
use regge_curvature::scalar::Lanes;
use regge_curvature::spaces::Lagrange;
use regge_curvature::spaces::ReggeFunction;

/// The sums of def:distcurv and, if asked for, the boundary's.
#[derive(Clone, Debug)]
pub struct AllSums {
    /// Cells, interior faces, interior hinges.
    pub inner: Sums<f64>,
    /// The boundary terms, by test function; none for the paper's functional.
    pub boundary: Option<Vec<f64>>,
}

impl Entries for AllSums {
    fn entries(&self) -> impl Iterator<Item = &f64> {
        let outer = self.boundary.iter().flatten();
        self.inner.entries().chain(outer)
    }
}

impl AllSums {
    /// By test function.
    pub fn parts(&self) -> Vec<Parts> {
        Parts::of(&self.inner, self.boundary.as_deref())
    }

    /// The whole functional, by test function.
    pub fn total(&self) -> Vec<f64> {
        self.parts().iter().map(|parts| parts.total).collect()
    }
}

/// The sums by the order asked for, or by one that is high enough.
pub fn sums<const N: usize>(
    g_h: &ReggeFunction<f64, N>,
    space: &Lagrange<N>,
    quadrature: Option<usize>,
    boundary: Boundary,
) -> Result<Settled<AllSums>, CurvatureError> {
    // Θ_S ω_S of a constant metric is constant on hinges: what is integrated is the test function.
    settle_sums(g_h, quadrature, space.degree(), |rules: &Rules| AllSums {
        inner: distributional_curvature::<Lanes, N, _>(g_h, space, rules),
        boundary: (boundary == Boundary::GaussBonnet)
            .then(|| boundary_curvature::<Lanes, N, _>(g_h, space, rules).total()),
    })
}

//! The sums for all test functions of a degree, by an order of quadrature that is high enough.

use super::settle::{SUMS_SETTLE, Settled, relative_change, settle};
use super::{Boundary, CurvatureError, failed};
use regge::field::TensorField;
use regge::functional::{Rules, Sums, boundary_curvature, distributional_curvature};
use regge::lagrange::Lagrange;
use regge::quadrature::Rule;
use regge::regge::ReggeFunction;
use regge::scalar::Lanes;

/// The sums of def:distcurv and, if asked for, the boundary's.
#[derive(Clone, Debug)]
pub struct AllSums {
    /// Cells, interior faces, interior hinges.
    pub inner: Sums<f64>,
    /// The boundary terms, by test function; none for the paper's functional.
    pub boundary: Option<Vec<f64>>,
}

impl AllSums {
    fn entries(&self) -> impl Iterator<Item = &f64> {
        let Sums {
            element,
            face,
            hinge,
        } = &self.inner;
        let all = element.iter().chain(face).chain(hinge);
        all.chain(self.boundary.iter().flatten())
    }

    /// The whole functional, by test function.
    pub fn total(&self) -> Vec<f64> {
        let mut total = self.inner.total();
        if let Some(boundary) = &self.boundary {
            for (sum, b) in total.iter_mut().zip(boundary) {
                *sum += b;
            }
        }
        total
    }
}

/// The sums by the order asked for, or by one that is high enough.
pub fn sums<const N: usize>(
    g_h: &ReggeFunction<'_, f64, N>,
    space: &Lagrange<'_, N>,
    quadrature: Option<usize>,
    boundary: Boundary,
) -> Result<Settled<AllSums>, CurvatureError> {
    let compute = |order| {
        let rules = Rules::new::<N>(order);
        let outer = || {
            let sums = boundary_curvature::<Lanes, N, _>(g_h, space, &rules);
            sums.total()
        };
        Ok(AllSums {
            inner: distributional_curvature::<Lanes, N, _>(g_h, space, &rules),
            boundary: (boundary == Boundary::GaussBonnet).then(outer),
        })
    };
    let settled = match (quadrature, TensorField::<f64, N>::is_constant(g_h)) {
        (Some(order), _) => Settled::given(compute(order).map_err(failed)?, order),
        // Θ_S ω_S is constant on hinges: what is integrated is the test function.
        (None, true) => Settled::exact(compute(space.degree()).map_err(failed)?, space.degree()),
        (None, false) => {
            let first = Rules::default_order(g_h.space().degree());
            let change = |a: &AllSums, b: &AllSums| relative_change(a.entries(), b.entries());
            settle(first, SUMS_SETTLE, compute, change).map_err(failed)?
        }
    };
    g_h.check_positive(Rule::new(N, settled.order).points())
        .map_err(failed)?;
    let finite = settled.value.entries().all(|x| x.is_finite());
    match finite {
        true => Ok(settled),
        false => Err(CurvatureError::Failed(
            "a sum is not finite: the metric may be all but degenerate".into(),
        )),
    }
}

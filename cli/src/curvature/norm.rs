//! ‖(Rω)_dist(g_h) − (Rω)(g)‖ in a norm of the library's table.

use super::given::{Given, Origin};
use super::report::{NormError, QuadratureUsed};
use super::settle::{NORM_SETTLES, Settled, relative_change, settle};
use super::smooth::{check_formula, stated_curvature};
use super::{CurvatureError, Request, failed, input};
use regge_curvature::Error;
use regge_curvature::functional::{Rules, distributional_curvature, smooth_curvature};
use regge_curvature::norm::{DualNorm, Kind, Setting, metric_values};
use regge_curvature::quadrature::Rule;
use regge_curvature::scalar::Lanes;

/// The error against the smooth metric that was interpolated.
pub fn norm_error<const N: usize>(
    given: &Given<'_, N>,
    request: &Request,
    name: &str,
) -> Result<NormError, CurvatureError> {
    let Some(origin) = given.origin else {
        let reason = "the error needs a smooth metric to compare with: give --metric";
        return Err(CurvatureError::Input(reason.into()));
    };
    let kind = Kind::<N>::named(name).expect("--norm takes names of the table");
    let (degree, metric) = ((kind.degree)(request.degree), metric_values(origin.0));
    let setting = Setting::new(given.g_h.space().mesh(), degree).with_metric(&metric);
    let norm = (kind.new)(&setting).map_err(failed)?;
    let compute = |order| {
        let load = load(given, origin, &*norm, order);
        if load.iter().any(|f| !f.is_finite()) {
            check_formula(origin.0, &Rule::new(N, order))?;
        }
        norm.of(&load, None).map(|norm| norm.total)
    };
    let settled = match request.quadrature {
        Some(order) => compute(order).map(|error| Settled::given(error, order)),
        None => settle(
            Rules::default_order(request.degree),
            NORM_SETTLES,
            compute,
            |a, b| relative_change([*a].iter(), [*b].iter()),
        ),
    };
    let settled = settled.map_err(|error| match error {
        Error::Cell { .. } => input(error),
        error => failed(error),
    })?;
    Ok(NormError {
        symbol: kind.symbol,
        error: settled.value,
        degree,
        quadrature: QuadratureUsed::of(&settled, NORM_SETTLES),
    })
}

/// ⟨(Rω)_dist(g_h) − (Rω)(g), v⟩ for the test functions of the norm.
fn load<const N: usize>(
    given: &Given<'_, N>,
    (g, exact): Origin<'_, N>,
    norm: &dyn DualNorm<N>,
    order: usize,
) -> Vec<f64> {
    let rules = Rules::new::<N>(order);
    let sums = distributional_curvature::<Lanes, N, _>(given.g_h, norm.space(), &rules);
    let smooth = match exact {
        Some(exact) => stated_curvature(g, exact, norm.space(), &rules.cells),
        None => smooth_curvature::<Lanes, N, _>(g, norm.space(), &rules.cells),
    };
    let pairs = sums.total().into_iter().zip(smooth);
    pairs.map(|(ours, smooth)| ours - smooth).collect()
}

//! The order of quadrature is raised until nothing changes.

use super::{CurvatureError, failed};
use regge_curvature::Error;
use regge_curvature::field::TensorField;
use regge_curvature::functional::{Rules, Sums};
use regge_curvature::quadrature::Rule;
use regge_curvature::spaces::ReggeFunction;

/// By how much the sums may still change, relative to the largest.
pub const SUMS_SETTLE: f64 = 1e-8;
/// By how much the norm may still change, relative to itself.
pub const NORM_SETTLES: f64 = 1e-7;
/// The highest order that is tried.
pub const LARGEST_ORDER: usize = 48;
/// The order is raised by this much at a time.
const STEP: usize = 4;

/// What was computed, and by which order.
#[derive(Clone, Debug)]
pub struct Settled<T> {
    /// What was computed.
    pub value: T,
    /// The order of the rules.
    pub order: usize,
    /// How much the last raise changed it, relatively; None if the order was given.
    pub change: Option<f64>,
}

impl<T> Settled<T> {
    /// By an order that was asked for.
    pub fn given(value: T, order: usize) -> Self {
        Self {
            value,
            order,
            change: None,
        }
    }

    /// By an order that is exact for what is integrated.
    pub fn exact(value: T, order: usize) -> Self {
        Self {
            value,
            order,
            change: Some(0.0),
        }
    }
}

/// Computes by rising orders from `first` on until `change` is at most `limit`, or the orders are exhausted.
///
/// # Errors
/// Those of `compute`.
pub fn settle<T>(
    first: usize,
    limit: f64,
    mut compute: impl FnMut(usize) -> Result<T, Error>,
    change: impl Fn(&T, &T) -> f64,
) -> Result<Settled<T>, Error> {
    let mut value = compute(first)?;
    let (mut order, mut last) = (first, f64::INFINITY);
    // NaN never settles: it is for the caller to see.
    while order + STEP <= LARGEST_ORDER && last > limit {
        let next = compute(order + STEP)?;
        last = change(&value, &next);
        (value, order) = (next, order + STEP);
    }
    Ok(Settled {
        value,
        order,
        change: last.is_finite().then_some(last),
    })
}

/// Numbers that settle together.
pub trait Entries {
    /// All of them.
    fn entries(&self) -> impl Iterator<Item = &f64>;
}

impl Entries for Sums<f64> {
    fn entries(&self) -> impl Iterator<Item = &f64> {
        self.cells.iter().chain(&self.faces).chain(&self.hinges)
    }
}

impl<const M: usize> Entries for [f64; M] {
    fn entries(&self) -> impl Iterator<Item = &f64> {
        self.iter()
    }
}

/// Sums over a Regge metric by the order asked for, or by one that is high enough: if the metric is constant in every
/// cell, by the order `exact`.
///
/// # Errors
/// The metric is not positive definite where it was looked at, or a sum is not finite.
pub fn settle_sums<const N: usize, T: Entries>(
    g_h: &ReggeFunction<f64, N>,
    quadrature: Option<usize>,
    exact: usize,
    compute: impl Fn(&Rules) -> T,
) -> Result<Settled<T>, CurvatureError> {
    let compute = |order| compute(&Rules::new::<N>(order));
    let settled = match (quadrature, TensorField::<f64, N>::is_constant(g_h)) {
        (Some(order), _) => Settled::given(compute(order), order),
        (None, true) => Settled::exact(compute(exact), exact),
        (None, false) => {
            let first = Rules::default_order(g_h.space().degree());
            let change = |a: &T, b: &T| relative_change(a.entries(), b.entries());
            settle(first, SUMS_SETTLE, |order| Ok(compute(order)), change).map_err(failed)?
        }
    };
    let points = Rule::new(N, settled.order);
    g_h.check_positive(points.points()).map_err(failed)?;
    let finite = settled.value.entries().all(|x| x.is_finite());
    match finite {
        true => Ok(settled),
        false => Err(CurvatureError::Failed(
            "a sum is not finite: the metric may be all but degenerate".into(),
        )),
    }
}

/// The largest difference of two lists, relative to the largest entry of the second.
pub fn relative_change<'a>(
    before: impl Iterator<Item = &'a f64>,
    after: impl Iterator<Item = &'a f64>,
) -> f64 {
    let (mut difference, mut scale) = (0.0f64, 0.0f64);
    for (a, b) in before.zip(after) {
        difference = difference.max((a - b).abs());
        scale = scale.max(b.abs());
    }
    // The scale of a flat metric is rounding: below 1e-5 it is held, so that changes of 1e-13 settle.
    difference / scale.max(1e-5)
}

//! The order of quadrature is raised until nothing changes.

use super::{CurvatureError, failed, input};
use regge_curvature::Error;
use regge_curvature::functional::{Rules, Sums};
use regge_curvature::quadrature::Rule;
use regge_curvature::spaces::ReggeFunction;

/// By how much the sums may still change, relative to the largest.
pub const SUMS_SETTLE: f64 = 1e-8;
/// By how much the load of a norm may still change, relative to its largest entry: the norm is about as accurate. A load is a
/// small difference of sums, and settles less far than they do.
pub const LOAD_SETTLES: f64 = 1e-7;
/// The highest order that is tried.
pub const LARGEST_ORDER: usize = 48;
/// The order is raised by this much at first: where the first order is good already, this says so at the least cost.
const FIRST_STEP: usize = 2;
/// And by this much from then on.
const STEP: usize = 4;

/// Which orders to try where none is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orders {
    /// One, which is exact.
    Exact(usize),
    /// Rising ones from this on.
    From(usize),
}

impl Orders {
    /// For the curvature of g_h against test functions of a degree.
    ///
    /// Θ_S ω_S of a constant metric is constant on hinges, so that what is integrated is the test function. Otherwise the order
    /// begins where it suffices for functions of degree r + 2, less what the test functions have less.
    pub fn of<const N: usize>(g_h: &ReggeFunction<f64, N>, tested: usize) -> Self {
        match g_h.space().degree() {
            0 => Self::Exact(tested),
            r => Self::From((Rules::default_order(r) + tested).saturating_sub(r + 2)),
        }
    }
}

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

/// Numbers that settle together.
pub trait Settles {
    /// How much they differ from those before, relatively, as a multiple of what counts for sums.
    fn change_since(&self, before: &Self) -> f64;
    /// Are they all finite?
    fn is_finite(&self) -> bool;
}

impl Settles for Sums<f64> {
    fn change_since(&self, before: &Self) -> f64 {
        relative_change(&lists(before), &lists(self))
    }

    fn is_finite(&self) -> bool {
        all_finite(&lists(self))
    }
}

impl<const M: usize> Settles for [f64; M] {
    fn change_since(&self, before: &Self) -> f64 {
        relative_change(&[before], &[self])
    }

    fn is_finite(&self) -> bool {
        all_finite(&[self])
    }
}

/// The three lists of sums.
pub fn lists(sums: &Sums<f64>) -> [&[f64]; 3] {
    [&sums.cells, &sums.faces, &sums.hinges]
}

/// Are all entries finite?
pub fn all_finite(lists: &[&[f64]]) -> bool {
    lists.iter().all(|list| list.iter().all(|x| x.is_finite()))
}

/// The largest difference of lists, relative to the largest entry of the second.
pub fn relative_change(before: &[&[f64]], after: &[&[f64]]) -> f64 {
    let (mut difference, mut scale) = (0.0f64, 0.0f64);
    for (before, after) in before.iter().zip(after) {
        for (a, b) in before.iter().zip(*after) {
            difference = difference.max((a - b).abs());
            scale = scale.max(b.abs());
        }
    }
    // The scale of a flat metric is rounding: below 1e-5 it is held, so that changes of 1e-13 settle.
    difference / scale.max(1e-5)
}

/// Sums by the order asked for, or by these orders until they settle.
///
/// # Errors
/// The metric is not positive definite where it was looked at, or a sum is not finite, and those of `compute`.
pub fn settle_sums<const N: usize, T: Settles>(
    g_h: &ReggeFunction<f64, N>,
    quadrature: Option<usize>,
    orders: Orders,
    compute: &mut dyn FnMut(usize) -> Result<T, Error>,
) -> Result<Settled<T>, CurvatureError> {
    let settled = match (quadrature, orders) {
        (Some(order), _) => compute(order).map(|value| Settled::given(value, order)),
        (None, Orders::Exact(order)) => compute(order).map(|value| Settled::exact(value, order)),
        (None, Orders::From(first)) => settle(first, compute),
    };
    let settled = settled.map_err(|error| match error {
        // A formula that is no metric in a cell.
        Error::Cell { .. } => input(error),
        error => failed(error),
    })?;
    let points = Rule::new(N, settled.order);
    g_h.check_positive(points.points()).map_err(failed)?;
    match settled.value.is_finite() {
        true => Ok(settled),
        false => Err(CurvatureError::Failed(
            "a sum is not finite: the metric may be all but degenerate".into(),
        )),
    }
}

/// Computes by rising orders from `first` on until nothing changes, or the orders are exhausted.
fn settle<T: Settles>(
    first: usize,
    compute: &mut dyn FnMut(usize) -> Result<T, Error>,
) -> Result<Settled<T>, Error> {
    let mut value = compute(first)?;
    let (mut order, mut step, mut last) = (first, FIRST_STEP, f64::INFINITY);
    // NaN never settles: it is for the caller to see.
    while order + step <= LARGEST_ORDER && last > SUMS_SETTLE {
        let next = compute(order + step)?;
        last = next.change_since(&value);
        (value, order, step) = (next, order + step, STEP);
    }
    Ok(Settled {
        value,
        order,
        change: last.is_finite().then_some(last),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No order is computed twice, and the last one is that of the value.
    #[test]
    fn each_order_is_computed_once() {
        let mut orders = Vec::new();
        let settled = settle(6, &mut |order| {
            orders.push(order);
            Ok([1.0 + 0.1f64.powi(order as i32)])
        });
        let settled = settled.expect("nothing fails");
        assert!(
            orders.windows(2).all(|pair| pair[0] < pair[1]),
            "{orders:?}"
        );
        assert_eq!(settled.order, *orders.last().expect("one at least"));
        assert!(settled.change.expect("several orders") <= SUMS_SETTLE);
    }
}

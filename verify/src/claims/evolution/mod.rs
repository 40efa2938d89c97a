//! Section 2: how geometry changes with the metric, at a point.

mod angle;
mod connection;
mod density;
mod frames;
mod mean_curvature;
mod normal;
mod scalar_curvature;
mod volume;

use crate::harness::Catalogue;
use crate::stage::point;
use regge_curvature::formulas::Formulas;

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<K: Formulas, const N: usize>(all: &mut Catalogue) {
    point::add::<scalar_curvature::P01, K, N>(all);
    point::add::<scalar_curvature::P03, K, N>(all);
    point::add::<volume::P02, K, N>(all);
    point::add::<connection::P05, K, N>(all);
    point::add::<connection::P06, K, N>(all);
    point::add::<connection::I12, K, N>(all);
    point::add::<normal::P07, K, N>(all);
    point::add::<normal::P08, K, N>(all);
    point::add::<normal::P09, K, N>(all);
    point::add::<normal::D12, K, N>(all);
    point::add::<frames::P10, K, N>(all);
    point::add::<frames::P11, K, N>(all);
    point::add::<frames::P12, K, N>(all);
    point::add::<frames::P13, K, N>(all);
    point::add::<mean_curvature::P14, K, N>(all);
    point::add::<mean_curvature::P15, K, N>(all);
    point::add::<mean_curvature::P16, K, N>(all);
    point::add::<mean_curvature::P17, K, N>(all);
    point::add::<mean_curvature::P18, K, N>(all);
    point::add::<mean_curvature::P19, K, N>(all);
    point::add::<density::P20, K, N>(all);
    point::add::<density::P21, K, N>(all);
    point::add::<angle::P22, K, N>(all);
    point::add::<angle::P23, K, N>(all);
    point::add::<angle::P24, K, N>(all);
}

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

/// Adds those that hold at a point, in dimension N.
pub(super) fn at_a_point<const N: usize>(all: &mut Catalogue) {
    point::add::<scalar_curvature::P01, N>(all);
    point::add::<scalar_curvature::P03, N>(all);
    point::add::<volume::P02, N>(all);
    point::add::<connection::P05, N>(all);
    point::add::<connection::P06, N>(all);
    point::add::<connection::I12, N>(all);
    point::add::<normal::P07, N>(all);
    point::add::<normal::P08, N>(all);
    point::add::<normal::P09, N>(all);
    point::add::<normal::D12, N>(all);
    point::add::<frames::P10, N>(all);
    point::add::<frames::P11, N>(all);
    point::add::<frames::P12, N>(all);
    point::add::<frames::P13, N>(all);
    point::add::<mean_curvature::P14, N>(all);
    point::add::<mean_curvature::P15, N>(all);
    point::add::<mean_curvature::P16, N>(all);
    point::add::<mean_curvature::P17, N>(all);
    point::add::<mean_curvature::P18, N>(all);
    point::add::<mean_curvature::P19, N>(all);
    point::add::<density::P20, N>(all);
    point::add::<density::P21, N>(all);
    point::add::<angle::P22, N>(all);
    point::add::<angle::P23, N>(all);
    point::add::<angle::P24, N>(all);
}

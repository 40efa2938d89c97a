//! What the paper prints: its tables and the coordinates of its plots.
//!
//! The errors are the plotted coordinates, of which the tables are the first four digits; mesh sizes are those of the
//! tables. Source: scalar-curvature.tex, section 5, figures `fig:conv_plot`, `fig:conv_plot_crit_term` and tables
//! `tab:error_N2`, `tab:error_N3`.

mod curves;
mod series;

pub use curves::SERIES;
pub use series::{MESH_SIZE_2, MESH_SIZE_3, Series};

use crate::quantity::Quantity;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Metric;

/// The curve to which a computation is to be compared, if the paper has one: of both averages that of "the"
/// optimal-order interpolant.
pub fn series(
    metric: Metric,
    dimension: usize,
    quantity: Quantity,
    degree: usize,
    interpolant: &Interpolant,
) -> Option<&'static Series> {
    let canonical = interpolant.is(&Interpolant::canonical());
    let averages = [Interpolant::average(), Interpolant::average_hierarchical()];
    let averaged = averages.iter().any(|average| average.is(interpolant));
    if metric != Metric::GraphQuartic || !(canonical || averaged) {
        return None;
    }
    SERIES.iter().find(|s| {
        (s.dimension, s.degree, s.quantity, s.canonical) == (dimension, degree, quantity, canonical)
    })
}

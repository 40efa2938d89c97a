//! What the paper prints: its tables and the coordinates of its plots.
//!
//! The errors are the plotted coordinates, of which the tables are the first four digits; mesh sizes are those of the
//! tables. Source: scalar-curvature.tex, section 5, figures `fig:conv_plot`, `fig:conv_plot_crit_term` and tables
//! `tab:error_N2`, `tab:error_N3`.

use crate::{Interpolation, Quantity, observed_order};
use regge_curvature::metrics::Metric;

/// One curve of a figure of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Series {
    /// The figure's label in the paper's source.
    pub label: &'static str,
    /// Its entry in the legend.
    pub legend: &'static str,
    /// N.
    pub dimension: usize,
    /// r.
    pub degree: usize,
    /// What is plotted.
    pub quantity: Quantity,
    /// Is it the curve of the canonical interpolant?
    pub canonical: bool,
    /// The level of the first point.
    pub first_level: u32,
    /// (ndof, H⁻² norm) by level.
    pub points: &'static [(usize, f64)],
}

/// h by level. Source: tab:error_N2.
pub const MESH_SIZE_2: [f64; 8] = [
    2.828, 1.534, 8.584e-1, 4.609e-1, 2.417e-1, 1.251e-1, 6.260e-2, 3.198e-2,
];

/// h by level. Source: tab:error_N3.
pub const MESH_SIZE_3: [f64; 7] = [
    3.464, 1.850, 9.709e-1, 4.999e-1, 2.753e-1, 1.358e-1, 6.878e-2,
];

impl Series {
    /// The printed norm of a level.
    pub fn error(&self, level: u32) -> Option<f64> {
        let index = level.checked_sub(self.first_level)? as usize;
        self.points.get(index).map(|point| point.1)
    }

    /// The printed order of a level: the tables have orders, made with the printed mesh sizes; the plots have none.
    pub fn order(&self, level: u32) -> Option<f64> {
        if self.quantity != Quantity::CurvatureError {
            return None;
        }
        observed_order(self.point(level.checked_sub(1)?)?, self.point(level)?)
    }

    /// The mesh size of the tables and the printed norm.
    pub fn point(&self, level: u32) -> Option<(f64, f64)> {
        let h: &[f64] = if self.dimension == 2 {
            &MESH_SIZE_2
        } else {
            &MESH_SIZE_3
        };
        Some((*h.get(level as usize)?, self.error(level)?))
    }
}

/// The curve to which a computation is to be compared, if the paper has one: of both averages that of "the"
/// optimal-order interpolant.
pub fn series(
    metric: Metric,
    dimension: usize,
    quantity: Quantity,
    degree: usize,
    interpolant: Interpolation,
) -> Option<&'static Series> {
    let canonical = interpolant == Interpolation::Canonical;
    if metric != Metric::GraphQuartic || !(canonical || interpolant.is_average()) {
        return None;
    }
    SERIES.iter().find(|s| {
        (s.dimension, s.degree, s.quantity, s.canonical) == (dimension, degree, quantity, canonical)
    })
}

/// All curves.
pub const SERIES: [Series; 12] = [
    Series {
        label: "fig:conv_plot (left)",
        legend: "r=0",
        dimension: 2,
        degree: 0,
        quantity: Quantity::CurvatureError,
        canonical: false,
        first_level: 0,
        points: &[
            (5, 0.223745609409278),
            (16, 0.194462134504585),
            (56, 0.0621977870431615),
            (208, 0.0233638487874428),
            (800, 0.0094339284346834),
            (3136, 0.0044568730457745),
            (12_416, 0.0021810609037358),
            (49_408, 0.0010666783169232),
        ],
    },
    Series {
        label: "fig:conv_plot (left)",
        legend: "r=1",
        dimension: 2,
        degree: 1,
        quantity: Quantity::CurvatureError,
        canonical: false,
        first_level: 0,
        points: &[
            (16, 0.0861267946606119),
            (56, 0.084479618514948),
            (208, 0.0456470361522919),
            (800, 0.0133457830026765),
            (3136, 0.0036888789020029),
            (12_416, 0.0009204557403272),
            (49_408, 0.0002279974531332),
            (197_120, 5.777307258843193e-05),
        ],
    },
    Series {
        label: "fig:conv_plot (left)",
        legend: "r=2",
        dimension: 2,
        degree: 2,
        quantity: Quantity::CurvatureError,
        canonical: false,
        first_level: 0,
        points: &[
            (33, 0.0271990483397802),
            (120, 0.0136406434789509),
            (456, 0.0022130473620008),
            (1776, 0.000361512807993),
            (7008, 4.188545674354635e-05),
            (27_840, 5.503884594546939e-06),
            (110_976, 7.027906861115703e-07),
            (443_136, 8.784421232101793e-08),
        ],
    },
    Series {
        label: "fig:conv_plot (right)",
        legend: "r=0",
        dimension: 3,
        degree: 0,
        quantity: Quantity::CurvatureError,
        canonical: false,
        first_level: 0,
        points: &[
            (19, 0.078689467681022),
            (98, 0.3215206552300362),
            (604, 0.1131756821590536),
            (4184, 0.0415165494783523),
            (31_024, 0.018378173088411),
            (238_688, 0.0087333143327151),
            (1_872_064, 0.0042962474180309),
        ],
    },
    Series {
        label: "fig:conv_plot (right)",
        legend: "r=1",
        dimension: 3,
        degree: 1,
        quantity: Quantity::CurvatureError,
        canonical: false,
        first_level: 0,
        points: &[
            (92, 0.1358695203463132),
            (556, 0.0661338606992382),
            (3800, 0.0291152964208913),
            (27_952, 0.0086328797972605),
            (214_112, 0.0023913193646172),
            (1_675_456, 0.0006194122507064),
            (13_255_040, 0.000157885729318),
        ],
    },
    Series {
        label: "fig:conv_plot (right)",
        legend: "r=2",
        dimension: 3,
        degree: 2,
        quantity: Quantity::CurvatureError,
        canonical: false,
        first_level: 0,
        points: &[
            (255, 0.018711639691359),
            (1662, 0.0413278709438671),
            (11_892, 0.0052855822502922),
            (89_736, 0.0007341956477066),
            (696_720, 9.752865630809082e-05),
            (5_489_952, 1.2610044493205028e-05),
            (43_586_112, 1.6039007874768194e-06),
        ],
    },
    Series {
        label: "fig:conv_plot_crit_term",
        legend: "r=0",
        dimension: 3,
        degree: 0,
        quantity: Quantity::CriticalTerm,
        canonical: false,
        first_level: 0,
        points: &[
            (19, 0.0333352303853497),
            (98, 0.0151071647590974),
            (604, 0.0016606255389163),
            (4184, 0.0004320600792596),
            (31_024, 0.0002777136715641),
            (238_688, 0.0003064128874271),
            (1_872_064, 0.0003318183264289),
        ],
    },
    Series {
        label: "fig:conv_plot_crit_term",
        legend: "r=1",
        dimension: 3,
        degree: 1,
        quantity: Quantity::CriticalTerm,
        canonical: false,
        first_level: 0,
        points: &[
            (92, 0.0253751525541026),
            (556, 0.000919730328497),
            (3800, 0.0005292047655846),
            (27_952, 0.0001530060324196),
            (214_112, 4.081533978686004e-05),
            (1_675_456, 1.048173633509593e-05),
            (13_255_040, 2.635676015094756e-06),
        ],
    },
    Series {
        label: "fig:conv_plot_crit_term",
        legend: "r=2",
        dimension: 3,
        degree: 2,
        quantity: Quantity::CriticalTerm,
        canonical: false,
        first_level: 0,
        points: &[
            (255, 0.0007779423425818),
            (1662, 0.0008620305429432),
            (11_892, 6.760475031527034e-06),
            (89_736, 2.2108635825020797e-07),
            (696_720, 1.8613374747783105e-08),
            (5_489_952, 1.2087696116457698e-09),
        ],
    },
    Series {
        label: "fig:conv_plot_crit_term",
        legend: "r=0 c.i.",
        dimension: 3,
        degree: 0,
        quantity: Quantity::CriticalTerm,
        canonical: true,
        first_level: 0,
        points: &[
            (19, 0.0002362591917287),
            (98, 0.0098556091258469),
            (604, 0.0021242374115492),
            (4184, 0.0005069524972355),
            (31_024, 0.000131172995997),
            (238_688, 3.2987363048662945e-05),
            (1_872_064, 8.247188370376352e-06),
        ],
    },
    Series {
        label: "fig:conv_plot_crit_term",
        legend: "r=1 c.i.",
        dimension: 3,
        degree: 1,
        quantity: Quantity::CriticalTerm,
        canonical: true,
        first_level: 0,
        points: &[
            (92, 0.000358229935323),
            (556, 0.0002899642860931),
            (3800, 9.023880253405389e-05),
            (27_952, 6.891132744464625e-06),
            (214_112, 4.68078580597443e-07),
            (1_675_456, 3.0358400843173734e-08),
            (13_255_040, 1.925729420114136e-09),
        ],
    },
    Series {
        label: "fig:conv_plot_crit_term",
        legend: "r=2 c.i.",
        dimension: 3,
        degree: 2,
        quantity: Quantity::CriticalTerm,
        canonical: true,
        first_level: 1,
        points: &[
            (1662, 9.838993561202204e-05),
            (11_892, 8.086946075405945e-07),
            (89_736, 1.3912756614505817e-08),
            (696_720, 2.4394797955317406e-10),
            (5_489_952, 4.019135797521764e-12),
        ],
    },
];

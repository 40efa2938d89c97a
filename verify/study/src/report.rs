//! A study as one JSON object.

use crate::case::Case;
use crate::fit::{Fit, fits};
use crate::named::Named;
use crate::row::Row;
use crate::rules::{LoadQuadrature, QuadratureReport};
use crate::study::Study;
use serde::{Deserialize, Serialize};

/// What a study was and what came out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// The version of the program.
    pub version: String,
    /// The command that makes this report.
    pub command: String,
    /// The smooth metric's name.
    pub metric: String,
    /// The name of what was measured in H⁻².
    pub quantity: String,
    /// How it was integrated.
    pub quadrature: QuadratureReport,
    /// Where the meshes' seeds come from.
    pub seed: u64,
    /// Line by line.
    pub rows: Vec<Row>,
    /// The orders over the finest levels.
    #[serde(default)]
    pub fits: Vec<Fit>,
}

/// What a row depends on besides its degree, level and interpolant: rows of the same make belong together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Make {
    /// The smooth metric's name.
    pub metric: String,
    /// N.
    pub dimension: usize,
    /// The name of what was measured in H⁻².
    pub quantity: String,
    /// The local projection inside the averages.
    pub projection: String,
    /// `converged`, `as-printed` or `order` with the number, and the order of the norm's rule if one was asked for.
    pub quadrature: String,
    /// Where the meshes' seeds come from.
    pub seed: u64,
}

impl Make {
    /// Of a study.
    pub fn of(study: &Study) -> Self {
        let load = match study.quadrature.load {
            LoadQuadrature::Order(order) => format!("order {order}"),
            _ => study.quadrature.kind().into(),
        };
        Self {
            metric: study.metric.name_of().into(),
            dimension: study.dimension,
            quantity: study.quantity.name_of().into(),
            projection: study.projection.name_of().into(),
            quadrature: match study.quadrature.norm {
                Some(norm) => format!("{load}, norm {norm}"),
                None => load,
            },
            seed: study.seed,
        }
    }
}

impl Report {
    /// Of a study with its rows.
    pub fn new(study: &Study, rows: Vec<Row>, command: String) -> Self {
        let orders = |&case: &Case| study.quadrature.orders(study.dimension, case);
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            command,
            metric: study.metric.name_of().into(),
            quantity: study.quantity.name_of().into(),
            quadrature: QuadratureReport {
                kind: study.quadrature.kind().into(),
                projection: study.projection.name_of().into(),
                orders: study.cases.iter().map(orders).collect(),
            },
            seed: study.seed,
            fits: fits(study, &rows),
            rows,
        }
    }
}

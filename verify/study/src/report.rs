//! A study as one JSON object.

use super::rules::QuadratureReport;
use super::{Case, Named, Row, Study};
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
            rows,
        }
    }
}

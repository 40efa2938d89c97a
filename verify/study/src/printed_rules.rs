//! The quadrature rules behind the printed tables.

use regge_curvature::Error;
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::Points;
use serde::Deserialize;
use std::collections::BTreeMap;

/// Rules as the original program (NGSolve) had them: reference points and weights on the simplex with vertices
/// e_1, …, e_N, 0, keyed by shape and order.
const PRINTED: &str = include_str!("../data/printed-quadrature.json");

#[derive(Deserialize)]
struct Table {
    points: Vec<Vec<f64>>,
    weights: Vec<f64>,
}

/// The rule of this order behind the printed tables, or any positive one where it is not known.
///
/// # Errors
/// If the embedded table is damaged.
pub fn printed_rule(dimension: usize, order: usize) -> Result<Rule, Error> {
    let damaged = |e: serde_json::Error| Error::Input(format!("printed-quadrature.json: {e}"));
    let mut all: BTreeMap<String, Table> = serde_json::from_str(PRINTED).map_err(damaged)?;
    let shape = ["point", "segment", "triangle", "tetrahedron"]
        .get(dimension)
        .unwrap_or(&"simplex");
    match (all.remove(&format!("{shape}-{order}")), dimension, order) {
        (Some(table), _, _) => from_table(dimension, table),
        (None, 2, 8) => triangle_of_order_eight(),
        _ => Ok(Rule::new(dimension, order)),
    }
}

fn from_table(dimension: usize, table: Table) -> Result<Rule, Error> {
    let mut lambda = Vec::new();
    for point in &table.points {
        lambda.extend(point);
        lambda.push(1.0 - point.iter().sum::<f64>());
    }
    Rule::from_parts(Points::new(dimension + 1, lambda), table.weights)
}

/// The original has 25 points, a conical product, which is collapsed at one vertex: which one depends on the
/// numbering inside that program. Here one half is collapsed at the second vertex, one half at the last: the two
/// cells of the mesh of level 0 are then seen as in the original, to 3·10⁻⁵ of the norm.
fn triangle_of_order_eight() -> Result<Rule, Error> {
    let half = Rule::conical(2, 8);
    let (mut lambda, mut weights) = (Vec::new(), Vec::new());
    for q in 0..half.len() {
        // The point's own apex comes first.
        let [apex, b, c] = std::array::from_fn(|i| half.points().lambda(q)[i]);
        lambda.extend([c, apex, b, b, c, apex]);
        weights.extend([0.5 * half.weights()[q]; 2]);
    }
    Rule::from_parts(Points::new(3, lambda), weights)
}

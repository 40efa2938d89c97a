//! The quadrature of a study: converged, of a given order, or that of the printed tables.

use regge::Error;
use regge::functional::Rules;
use regge::quadrature::Rule;
use regge::simplex::Points;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The rules behind the printed tables, as the original program had them: reference points and weights on the simplex
/// with vertices e_1, …, e_N, 0, keyed by shape and order.
const PRINTED: &str = include_str!("../../data/printed-quadrature.json");

/// By which rules a study integrates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quadrature {
    /// Of an order at which raising it changes the errors by less than 10⁻³ of themselves.
    Converged,
    /// The functionals by rules of this order, the norm exactly.
    Order(usize),
    /// As the paper's tables: the functionals by rules of order 2(r+2), the norm by one of order 5.
    AsPrinted,
}

/// The rules for one degree.
#[derive(Clone, Debug)]
pub struct StudyRules {
    /// Of the functionals.
    pub load: Rules,
    /// Of the three L² norms; None: exact.
    pub norm: Option<Rule>,
}

/// What a report says of the quadrature.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct QuadratureReport {
    /// `converged`, `order` or `as-printed`.
    pub kind: String,
    /// The order of the functionals' rules, by degree.
    pub load_order: BTreeMap<usize, usize>,
    /// The order of the rule of the L² norms; null: exact.
    pub norm_order: Option<usize>,
    /// The local projection inside the averages.
    pub projection: String,
}

impl Quadrature {
    /// The order at which the functionals are integrated for a metric of degree r.
    pub fn load_order(self, degree: usize) -> usize {
        match self {
            Self::Converged => Rules::default_order(degree),
            Self::Order(order) => order,
            Self::AsPrinted => 2 * (degree + 2),
        }
    }

    /// The order of the rule of the norm; None: exact.
    pub fn norm_order(self) -> Option<usize> {
        (self == Self::AsPrinted).then_some(5)
    }

    /// Its name in a report.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Order(_) => "order",
            Self::AsPrinted => "as-printed",
        }
    }

    /// The rules for a degree.
    ///
    /// # Errors
    /// If the embedded table is damaged.
    pub fn rules<const N: usize>(self, degree: usize) -> Result<StudyRules, Error> {
        let order = self.load_order(degree);
        Ok(match self {
            Self::Converged | Self::Order(_) => StudyRules { load: Rules::new::<N>(order), norm: std::env::var("NQ").ok().map(|q| printed_rule(N, q.parse().unwrap()).unwrap()) },
            Self::AsPrinted => StudyRules {
                load: Rules {
                    element: printed_rule(N, order)?,
                    face: printed_rule(N - 1, order)?,
                    hinge: printed_rule(N - 2, order)?,
                },
                norm: Some(printed_rule(N, 5)?),
            },
        })
    }
}

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
    let shape = ["point", "segment", "triangle", "tetrahedron"].get(dimension).unwrap_or(&"simplex");
    let Some(table) = all.remove(&format!("{shape}-{order}")) else {
        return Ok(Rule::new(dimension, order));
    };
    let mut lambda = Vec::new();
    for point in &table.points {
        lambda.extend(point);
        lambda.push(1.0 - point.iter().sum::<f64>());
    }
    Rule::from_parts(Points::new(dimension + 1, lambda), table.weights)
}

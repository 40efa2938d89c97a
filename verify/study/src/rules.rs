//! The quadrature of a study: converged, of a given order, or that of the printed tables.

use crate::case::Case;
use crate::printed_rules::printed_rule;
use regge_curvature::Error;
use regge_curvature::functional::Rules;
use regge_curvature::quadrature::Rule;
use serde::{Deserialize, Serialize};

/// By which rules a study integrates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quadrature {
    /// Of the functionals.
    pub load: LoadQuadrature,
    /// The order for the three L² norms; None: [`Quadrature::norm_order`] chooses.
    pub norm: Option<usize>,
}

/// By which rules a study integrates its functionals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadQuadrature {
    /// Of [`converged_order`].
    Converged,
    /// Of this order.
    Order(usize),
    /// As the paper's tables: order 2(r+2) by the rules of the original program, as far as they are known.
    AsPrinted,
}

/// The rules for one case.
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
    /// The local projection inside the averages: `exact` or `discrete`.
    pub projection: String,
    /// The orders, case by case.
    pub orders: Vec<Orders>,
}

/// The orders of one case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Orders {
    /// r.
    pub degree: usize,
    /// k.
    pub level: u32,
    /// Of the rules of the functionals, on cells, faces and hinges.
    pub load: usize,
    /// Of the rule of the L² norms; null: exact.
    pub norm: Option<usize>,
}

/// The order at which the norm is integrated in the paper's program: NGSolve's default.
const NORM_ORDER_OF_THE_PAPER: usize = 5;

/// The order from which on raising it changes the H⁻² norms by less than 10⁻³ of themselves.
///
/// That of [`Rules::default_order`], and more on the coarsest meshes, whose cells do not resolve the metric. Measured
/// for the built-in metrics, r ≤ 2, the curvature's error and the critical term with every interpolant: the change is
/// below 10⁻⁶ at k = 0, where this is wanted for comparison with other programs, and below 5·10⁻⁴ elsewhere.
pub fn converged_order(case: Case) -> usize {
    let least = [30, 16, 12].get(case.level as usize).copied().unwrap_or(0);
    Rules::default_order(case.degree).max(least)
}

impl Quadrature {
    /// Converged throughout.
    pub const CONVERGED: Self = Self {
        load: LoadQuadrature::Converged,
        norm: None,
    };
    /// As in the paper's tables.
    pub const AS_PRINTED: Self = Self {
        load: LoadQuadrature::AsPrinted,
        norm: None,
    };

    /// The order at which the functionals are integrated.
    pub fn load_order(self, case: Case) -> usize {
        match self.load {
            LoadQuadrature::Converged => converged_order(case),
            LoadQuadrature::Order(order) => order,
            LoadQuadrature::AsPrinted => 2 * (case.degree + 2),
        }
    }

    /// The order of the rule of the L² norms; None: exact.
    ///
    /// The paper's order 5 where it integrates |σ|² exactly (N = 2, r ≤ 2 and N = 3, r ≤ 1): the norm then differs
    /// from the exact one by less than 3·10⁻⁴ of itself (measured at k = 0; less on finer meshes), and is the paper's
    /// to all digits. Elsewhere order 5 would be wrong by up to a quarter, and integration is exact.
    pub fn norm_order(self, dimension: usize, degree: usize) -> Option<usize> {
        let suffices = degree + dimension <= 4;
        let paper = self.load == LoadQuadrature::AsPrinted || suffices;
        self.norm.or(paper.then_some(NORM_ORDER_OF_THE_PAPER))
    }

    /// Its name in a report.
    pub fn kind(self) -> &'static str {
        match self.load {
            LoadQuadrature::Converged => "converged",
            LoadQuadrature::Order(_) => "order",
            LoadQuadrature::AsPrinted => "as-printed",
        }
    }

    /// Its name in a headline.
    pub fn words(self) -> String {
        match self.load {
            LoadQuadrature::Converged => "converged".into(),
            LoadQuadrature::Order(order) => format!("order {order}"),
            LoadQuadrature::AsPrinted => "the paper's".into(),
        }
    }

    /// All orders of a case.
    pub fn orders(self, dimension: usize, case: Case) -> Orders {
        let Case { degree, level } = case;
        Orders {
            degree,
            level,
            load: self.load_order(case),
            norm: self.norm_order(dimension, degree),
        }
    }

    /// The rules of a case on a mesh of dimension n.
    ///
    /// # Errors
    /// If the embedded table is damaged.
    pub fn rules(self, n: usize, case: Case) -> Result<StudyRules, Error> {
        let order = self.load_order(case);
        let rule = |dimension: usize| match self.load {
            LoadQuadrature::Converged | LoadQuadrature::Order(_) => Ok(Rule::new(dimension, order)),
            LoadQuadrature::AsPrinted => printed_rule(dimension, order),
        };
        let norm = self.norm_order(n, case.degree);
        Ok(StudyRules {
            load: Rules::of(rule(n)?, rule(n - 1)?, rule(n - 2)?),
            norm: norm.map(|order| printed_rule(n, order)).transpose()?,
        })
    }
}

//! One line of a study.

use serde::{Deserialize, Serialize};

/// One line of a study: one mesh, one degree, one interpolant.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// N.
    pub dimension: usize,
    /// r.
    pub degree: usize,
    /// k.
    pub level: u32,
    /// Its name.
    pub interpolant: String,
    /// The seed of this mesh's perturbation, for `Mesh::perturbed_as_in_paper`; level 0 has nothing to perturb.
    pub seed: u64,
    /// How many cells.
    pub cells: usize,
    /// The dimension of the Regge space.
    pub ndof: usize,
    /// h: the longest edge in ℝ^N.
    pub mesh_size: f64,
    /// The H⁻² norm of the quantity.
    pub error: f64,
    /// log(e'/e)/log(h'/h) against the row before of the same degree and interpolant; null on the first.
    pub order: Option<f64>,
    /// What the paper has for this row; null where it has nothing.
    pub printed: Option<f64>,
    /// Wall-clock time. What several interpolants share counts for the first of them. Where two cases are computed at once, each beside the other.
    pub seconds: f64,
    /// What solved the biharmonic problem: `cholesky` or `cg`; empty in reports of before there was a choice.
    #[serde(default)]
    pub solver: String,
    /// How many steps it took, if it is iterative.
    #[serde(default)]
    pub steps: Option<usize>,
}

/// Below this a norm is rounding, for the metrics here are of size one: it has no order.
pub const ROUNDING: f64 = 1e-14;

/// log(e'/e)/log(h'/h) between (h', e') and (h, e), if these have an order.
pub fn observed_order(before: (f64, f64), now: (f64, f64)) -> Option<f64> {
    let order = (before.1 / now.1).ln() / (before.0 / now.0).ln();
    (before.1 > ROUNDING && now.1 > ROUNDING && order.is_finite()).then_some(order)
}

impl Row {
    /// Is it of the same degree, level and interpolant?
    pub fn same_case(&self, other: &Self) -> bool {
        (self.degree, self.level) == (other.degree, other.level)
            && self.interpolant == other.interpolant
    }

    /// The order against the last of the rows before that belongs to the same sequence.
    pub(super) fn set_order(&mut self, before: &[Self]) {
        let same = |row: &&Self| row.degree == self.degree && row.interpolant == self.interpolant;
        self.order = before.iter().rev().find(same).and_then(|row| {
            observed_order((row.mesh_size, row.error), (self.mesh_size, self.error))
        });
    }
}

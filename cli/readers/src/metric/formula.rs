//! The four ways to state a metric, as one smooth tensor.

use super::super::expression::{Expression, Expressions, Gradients};
use super::MetricFile;
use regge_curvature::linalg::{Mat, symmetric, zeros};
use regge_curvature::mesh::SplitMix64;
use regge_curvature::metrics::SmoothTensor;
use regge_curvature::scalar::Real;

/// How a metric is stated.
#[derive(Clone, Debug)]
pub enum Formula {
    /// g_ij with i ≤ j, row by row.
    Components(Expressions),
    /// c δ.
    Conformal(Expression),
    /// The metric that a map X into ℝ^M induces: ∂_i X · ∂_j X.
    Induced {
        /// X; of a graph its last component alone, those before are the coordinates.
        map: Expressions,
        /// ∂_m of it.
        gradients: Gradients,
        /// Is it a graph?
        graph: bool,
    },
}

impl Formula {
    /// The metric with these components, of which those with i ≤ j are taken.
    pub(super) fn of_components(g: &[Vec<Expression>]) -> Self {
        let upper = g.iter().enumerate().flat_map(|(i, row)| &row[i..]);
        Self::Components(Expressions::new(upper.cloned().collect()))
    }

    /// The metric of the graph of f: I + ∇f ⊗ ∇f.
    pub(super) fn of_graph(f: Expression, n: usize) -> Self {
        Self::induced(vec![f], n, true)
    }

    /// The metric that a map with these components induces on the n coordinates.
    pub(super) fn of_embedding(map: Vec<Expression>, n: usize) -> Self {
        Self::induced(map, n, false)
    }

    fn induced(map: Vec<Expression>, n: usize, graph: bool) -> Self {
        let map = Expressions::new(map);
        Self::Induced {
            gradients: map.gradients(n),
            map,
            graph,
        }
    }

    /// All formulas in it.
    pub(super) fn expressions(&self) -> Vec<&Expression> {
        match self {
            Self::Components(all) | Self::Induced { map: all, .. } => {
                all.formulas().iter().collect()
            }
            Self::Conformal(f) => vec![f],
        }
    }
}

/// The first pair of entries that are not the same function, as far as random points can tell, with a reason.
pub(super) fn asymmetry(g: &[Vec<Expression>]) -> Option<(usize, usize, String)> {
    for i in 0..g.len() {
        for j in 0..i {
            if g[i][j] != g[j][i] && differ(&g[i][j], &g[j][i], g.len()) {
                let (row, column) = (i + 1, j + 1);
                let reason = format!(
                    "g is not symmetric: entries ({row}, {column}) and ({column}, {row}) differ"
                );
                return Some((i, j, reason));
            }
        }
    }
    None
}

/// Do two formulas differ by more than rounding at one of eight points of the cube (−1, 1)^N?
fn differ(a: &Expression, b: &Expression, n: usize) -> bool {
    let mut random = SplitMix64::new(1);
    (0..8).any(|_| {
        let x: Vec<f64> = (0..n).map(|_| random.symmetric()).collect();
        let (a, b) = (a.at(&x), b.at(&x));
        // Two ways to write one function agree to a few units in the last place, times its condition.
        a.is_finite() && b.is_finite() && (a - b).abs() > 1e-9 * a.abs().max(b.abs()).max(1e-300)
    })
}

/// A metric file seen in its dimension.
#[derive(Clone, Copy, Debug)]
pub struct FormulaMetric<'f> {
    formula: &'f Formula,
}

impl MetricFile {
    /// The metric; N must be the file's dimension.
    pub fn metric(&self) -> FormulaMetric<'_> {
        FormulaMetric {
            formula: &self.formula,
        }
    }
}

/// A metric file in two or three coordinates, seen in space: a formula in x and y knows nothing of z.
#[derive(Clone, Copy, Debug)]
pub struct InSpace<'f> {
    formula: FormulaMetric<'f>,
    /// In x and y alone.
    plane: bool,
}

impl MetricFile {
    /// The tensor on ℝ³ that surfaces and curved cells inherit; the file's dimension must be 2 or 3.
    pub fn in_space(&self) -> InSpace<'_> {
        InSpace {
            formula: self.metric(),
            plane: self.dimension == 2,
        }
    }
}

impl SmoothTensor<3> for InSpace<'_> {
    fn at<S: Real>(&self, x: &[S; 3]) -> Mat<S, 3> {
        if !self.plane {
            return self.formula.at(x);
        }
        let g: Mat<S, 2> = self.formula.at(&[x[0], x[1]]);
        symmetric(|i, j| match (i, j) {
            (0 | 1, 0 | 1) => g[(i, j)],
            _ => S::zero(),
        })
    }
}

impl<const N: usize> SmoothTensor<N> for FormulaMetric<'_> {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        match self.formula {
            Formula::Components(g) => components(g, x),
            Formula::Conformal(factor) => {
                let factor = factor.at(x);
                symmetric(|i, j| if i == j { factor } else { S::zero() })
            }
            Formula::Induced {
                gradients, graph, ..
            } => induced(gradients, *graph, x),
        }
    }
}

fn components<S: Real, const N: usize>(upper: &Expressions, x: &[S; N]) -> Mat<S, N> {
    let mut g = zeros();
    let mut next = (0, 0);
    upper.at(x, |_, value| {
        let (i, j) = next;
        (g[(i, j)], g[(j, i)]) = (value, value);
        next = match j + 1 < N {
            true => (i, j + 1),
            false => (i + 1, i + 1),
        };
    });
    g
}

/// ∂_i X · ∂_j X, and δ_ij to it if X is the last component of a graph.
fn induced<S: Real, const N: usize>(map: &Gradients, graph: bool, x: &[S; N]) -> Mat<S, N> {
    let mut g = symmetric(|i, j| S::from_int(i64::from(graph && i == j)));
    let mut d = [S::zero(); N];
    map.at(x, |m, value| {
        d[m] = value;
        if m + 1 < N {
            return;
        }
        for i in 0..N {
            for j in 0..N {
                g[(i, j)] += d[i] * d[j];
            }
        }
    });
    g
}

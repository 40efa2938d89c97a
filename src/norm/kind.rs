//! Norms by name: what an entry of their table says.

use super::census::Census;
use super::dual::DualNorm;
use crate::Error;
use crate::field::Evaluate;
use crate::linalg::Mat;
use crate::mesh::Mesh;
use crate::simplex::Points;

/// A norm that can be asked for by name. All of them are in [`Kind::all`], over which the studies and the command line
/// iterate.
#[derive(Clone, Copy, Debug)]
pub struct Kind<const N: usize> {
    /// What it is asked for by: `hm2`.
    pub name: &'static str,
    /// How it is written in a report of plain text: `H^-2`.
    pub symbol: &'static str,
    /// What it is and how it is computed, in a few words.
    pub about: &'static str,
    /// The degree of the test functions that suits the curvature of a Regge metric of degree r.
    pub degree: fn(usize) -> usize,
    /// The memory in bytes that it takes at its height on a mesh with this census, by test functions of this degree ≥ 1;
    /// the mesh itself is not counted.
    pub memory: fn(&Census, usize) -> f64,
    /// Sets it up.
    pub new: fn(&Setting<'_, N>) -> Result<Box<dyn DualNorm<N>>, Error>,
}

/// What a norm is set up from.
#[derive(Clone, Copy)]
pub struct Setting<'a, const N: usize> {
    /// The mesh.
    pub mesh: &'a Mesh<N>,
    /// The degree of the test functions.
    pub degree: usize,
    /// The metric of the norm, for those that depend on one (H⁻¹(Ω, g)); without it they are Euclidean. H⁻² always is.
    pub metric: Option<&'a MetricValues<'a, N>>,
}

/// g at points of a cell, in the cell's reference coordinates: `(cell, points)` to one matrix `[(i, j)]` a point.
pub type MetricValues<'a, const N: usize> = dyn Fn(usize, &Points) -> Vec<Mat<f64, N>> + Sync + 'a;

/// The values of a field, as a [`Setting`] takes them.
pub fn metric_values<const N: usize, G: Evaluate<f64, N>>(
    g: &G,
) -> impl Fn(usize, &Points) -> Vec<Mat<f64, N>> + Sync {
    |cell, points| {
        let (local, table) = (g.on_cell(cell), g.tabulate(points));
        (0..points.len())
            .map(|point| g.value(&local, &table, point))
            .collect()
    }
}

impl<'a, const N: usize> Setting<'a, N> {
    /// With the Euclidean metric.
    pub fn new(mesh: &'a Mesh<N>, degree: usize) -> Self {
        Self {
            mesh,
            degree,
            metric: None,
        }
    }

    /// With a metric, see [`metric_values`].
    pub fn with_metric(self, metric: &'a MetricValues<'a, N>) -> Self {
        Self {
            metric: Some(metric),
            ..self
        }
    }
}

impl<const N: usize> std::fmt::Debug for Setting<'_, N> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Setting")
            .field("cells", &self.mesh.cell_count())
            .field("degree", &self.degree)
            .field("has_metric", &self.metric.is_some())
            .finish()
    }
}

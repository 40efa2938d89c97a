//! Regge's action and its gradient in the edge lengths.

use super::given::{Given, Phase, Source, Task, on_metric};
use super::report::QuadratureUsed;
use super::settle::{SUMS_SETTLE, Settled, relative_change, settle};
use super::{CurvatureError, failed};
use crate::input::mesh::MeshFile;
use regge::field::TensorField;
use regge::functional::{Rules, action_gradient, regge_action};
use regge::scalar::Lanes;
use serde::Serialize;

/// What `regge action` writes.
#[derive(Clone, Debug, Serialize)]
pub struct ActionReport {
    /// The version of the program.
    pub version: &'static str,
    /// The mesh file.
    pub mesh: String,
    /// N.
    pub dimension: usize,
    /// r.
    pub degree: usize,
    /// How the Regge metric was made.
    pub interpolant: String,
    /// The quadrature of the action.
    pub quadrature: QuadratureUsed,
    /// Interior and boundary together.
    pub action: f64,
    /// ½⟨(Rω)_dist, 1⟩; for r = 0 Σ̊_S Θ_S |S|.
    pub interior: f64,
    /// The boundary's part; for r = 0 Σ_{S⊂∂Ω} (π − Σθ) |S|.
    pub boundary: f64,
    /// For r = 0 the derivatives in the lengths of the interior edges, those of the boundary being held.
    pub gradient: Option<Vec<EdgeDerivative>>,
    /// The largest of them.
    pub largest: Option<f64>,
    /// The largest |Σ_S |S| ∂θ_S/∂ℓ| over cells and edges: 0 by Schläfli's identity, up to rounding.
    pub schlaefli: Option<f64>,
}

/// What an edge does to the action.
#[derive(Clone, Debug, Serialize)]
pub struct EdgeDerivative {
    /// Its vertices.
    pub vertices: Vec<u32>,
    /// ℓ.
    pub length: f64,
    /// Σ_S Θ_S ∂|S|/∂ℓ.
    pub derivative: f64,
}

/// The action of the Regge metric on the mesh.
///
/// # Errors
/// Whether the input is to blame or the computation, and what is wrong where.
pub fn action(
    mesh: &MeshFile,
    source: &Source,
    degree: usize,
    quadrature: Option<usize>,
    phase: Phase<'_>,
) -> Result<ActionReport, CurvatureError> {
    on_metric(mesh, source, degree, phase, &Action { quadrature, phase })
}

struct Action<'a> {
    quadrature: Option<usize>,
    phase: Phase<'a>,
}

impl Task for Action<'_> {
    type Output = ActionReport;

    fn run<const N: usize>(&self, given: &Given<'_, N>) -> Result<ActionReport, CurvatureError> {
        (self.phase)("summing the action");
        let settled = self.parts(given)?;
        let [interior, boundary] = settled.value;
        let mut report = ActionReport {
            version: env!("CARGO_PKG_VERSION"),
            mesh: given.file.file.display().to_string(),
            dimension: N,
            degree: given.g_h.space().degree(),
            interpolant: given.interpolant.into(),
            quadrature: QuadratureUsed::of(&settled, SUMS_SETTLE),
            action: interior + boundary,
            interior,
            boundary,
            gradient: None,
            largest: None,
            schlaefli: None,
        };
        if report.degree == 0 {
            (self.phase)("differentiating the action");
            self.gradient(given, &mut report)?;
        }
        Ok(report)
    }
}

impl Action<'_> {
    fn parts<const N: usize>(
        &self,
        given: &Given<'_, N>,
    ) -> Result<Settled<[f64; 2]>, CurvatureError> {
        let (g_h, mesh) = (given.g_h, given.g_h.space().mesh());
        let compute = |order| {
            let rules = Rules::new::<N>(order);
            Ok(regge_action::<Lanes, N, _>(g_h, mesh, &rules))
        };
        let settled = match (self.quadrature, TensorField::<f64, N>::is_constant(g_h)) {
            (Some(order), _) => compute(order).map(|parts| Settled::given(parts, order)),
            (None, true) => compute(1).map(|parts| Settled::exact(parts, 1)),
            (None, false) => {
                let first = Rules::default_order(g_h.space().degree());
                settle(first, SUMS_SETTLE, compute, |a, b| {
                    relative_change(a.iter(), b.iter())
                })
            }
        };
        let settled = settled.map_err(failed)?;
        match settled.value.iter().all(|x| x.is_finite()) {
            true => Ok(settled),
            false => Err(CurvatureError::Failed(
                "the action is not finite: the metric may be all but degenerate".into(),
            )),
        }
    }

    fn gradient<const N: usize>(
        &self,
        given: &Given<'_, N>,
        report: &mut ActionReport,
    ) -> Result<(), CurvatureError> {
        let mesh = given.g_h.space().mesh();
        let all = action_gradient(given.g_h).map_err(failed)?;
        let edges: Vec<EdgeDerivative> = mesh
            .interior(1)
            .map(|edge| EdgeDerivative {
                vertices: mesh.vertices(1, edge).to_vec(),
                length: given.g_h.coefficients()[edge].sqrt(),
                derivative: all.gradient[edge],
            })
            .collect();
        let sizes = edges.iter().map(|e| e.derivative.abs());
        report.largest = Some(sizes.fold(0.0, f64::max));
        report.gradient = Some(edges);
        report.schlaefli = Some(all.schlaefli);
        Ok(())
    }
}

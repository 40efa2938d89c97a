//! Regge's action and its gradient in the edge lengths.

use super::enclosed::{Enclosures, enclosures};
use super::given::{Given, Phase, Source, by_dimension};
use super::report::About;
use super::settle::{Orders, settle_sums};
use super::{CurvatureError, failed};
use regge_curvature::functional::{Rules, action_gradient, regge_action};
use regge_readers::mesh::MeshFile;
use serde::Serialize;

/// What `regge action` writes.
#[derive(Clone, Debug, Serialize)]
pub struct ActionReport {
    /// Of what metric.
    #[serde(flatten)]
    pub about: About,
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
    /// What is proven of the numbers, if that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosures: Option<Enclosures>,
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
    certified: bool,
    phase: Phase<'_>,
) -> Result<ActionReport, CurvatureError> {
    by_dimension!(mesh, N => {
        let given = Given::<N>::new(mesh, source, degree, phase)?;
        let mut report = report(&given, quadrature, phase)?;
        if certified {
            report.enclosures = Some(enclosures(&given, phase)?);
        }
        Ok(report)
    })
}

fn report<const N: usize>(
    given: &Given<'_, N>,
    quadrature: Option<usize>,
    phase: Phase<'_>,
) -> Result<ActionReport, CurvatureError> {
    let (g_h, mesh) = (&given.g_h, given.g_h.space().mesh());
    let parts = settle_sums(g_h, quadrature, Orders::of(g_h, 1), &mut |order| {
        phase(&format!("summing the action by rules of order {order}"));
        let action = regge_action(g_h, mesh, &Rules::new(N, order));
        Ok([action.interior, action.boundary])
    })?;
    let [interior, boundary] = parts.value;
    let mut report = ActionReport {
        about: About::of(given, &parts),
        action: interior + boundary,
        interior,
        boundary,
        gradient: None,
        largest: None,
        schlaefli: None,
        enclosures: None,
    };
    if report.about.degree == 0 {
        phase("differentiating the action");
        gradient(given, &mut report)?;
    }
    Ok(report)
}

/// Adds the gradient to the report.
fn gradient<const N: usize>(
    given: &Given<'_, N>,
    report: &mut ActionReport,
) -> Result<(), CurvatureError> {
    let mesh = given.g_h.space().mesh();
    let all = action_gradient(&given.g_h).map_err(failed)?;
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

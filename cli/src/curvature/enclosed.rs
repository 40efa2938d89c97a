//! What `--certified` adds to a metric of degree 0: numbers that are proven to lie between two others.

use super::given::Given;
use super::{CurvatureError, Phase, failed};
use regge_curvature::functional::{Enclosed, enclosed};
use regge_curvature::mesh::Mesh;
use regge_curvature::scalar::Interval;
use serde::Serialize;

/// The least and the largest number that it may be.
pub type Bounds = [f64; 2];

/// Enclosures of the numbers of classical Regge calculus, the squared lengths being exact.
#[derive(Clone, Debug, Serialize)]
pub struct Enclosures {
    /// Interior and boundary together.
    pub action: Bounds,
    /// Σ̊_S Θ_S |S|.
    pub interior: Bounds,
    /// Σ_{S⊂∂Ω} (π − Σ_T θ_ST) |S|.
    pub boundary: Bounds,
    /// For surfaces the action over 2π, which is the Euler characteristic.
    pub over_two_pi: Option<Bounds>,
    /// The only integer in it.
    pub euler_characteristic: Option<i64>,
    /// All hinges of the mesh.
    pub hinges: Vec<HingeEnclosure>,
    /// The derivatives of the action in the lengths of all edges.
    pub gradient: Vec<EdgeEnclosure>,
    /// The widest enclosure of an angle.
    pub widest_angle: f64,
}

/// Θ_S and |S|.
#[derive(Clone, Debug, Serialize)]
pub struct HingeEnclosure {
    /// Its vertices.
    pub vertices: Vec<u32>,
    /// Is it inside? On the boundary the angle is π − Σθ.
    pub interior: bool,
    /// Θ_S.
    pub defect: Bounds,
    /// |S|.
    pub size: Bounds,
}

/// Σ_S Θ_S ∂|S|/∂ℓ.
#[derive(Clone, Debug, Serialize)]
pub struct EdgeEnclosure {
    /// The edge.
    pub vertices: Vec<u32>,
    /// The derivative.
    pub derivative: Bounds,
}

pub(super) fn bounds(x: Interval) -> Bounds {
    [x.low(), x.high()]
}

/// Of the metric that is given.
pub(super) fn enclosures<const N: usize>(
    given: &Given<'_, N>,
    phase: Phase<'_>,
) -> Result<Enclosures, CurvatureError> {
    phase("enclosing angles and sizes");
    let mesh = given.g_h.space().mesh();
    let all = enclosed(&given.g_h).map_err(failed)?;
    let over = (N == 2).then(|| all.action() / (Interval::pi() + Interval::pi()));
    let widths = all.defects.iter().map(|x| x.width());
    Ok(Enclosures {
        action: bounds(all.action()),
        interior: bounds(all.interior),
        boundary: bounds(all.boundary),
        over_two_pi: over.map(bounds),
        euler_characteristic: over.and_then(Interval::integer),
        hinges: hinges(mesh, &all),
        gradient: gradient(mesh, &all),
        widest_angle: widths.fold(0.0, f64::max),
    })
}

fn hinges<const N: usize>(mesh: &Mesh<N>, all: &Enclosed) -> Vec<HingeEnclosure> {
    let mut listed: Vec<HingeEnclosure> = (0..mesh.count(N - 2))
        .map(|hinge| HingeEnclosure {
            vertices: mesh.vertices(N - 2, hinge).to_vec(),
            interior: false,
            defect: bounds(all.defects[hinge]),
            size: bounds(all.sizes[hinge]),
        })
        .collect();
    for hinge in mesh.interior_hinges() {
        listed[hinge].interior = true;
    }
    listed
}

fn gradient<const N: usize>(mesh: &Mesh<N>, all: &Enclosed) -> Vec<EdgeEnclosure> {
    let of = |(edge, derivative): (usize, &Interval)| EdgeEnclosure {
        vertices: mesh.vertices(1, edge).to_vec(),
        derivative: bounds(*derivative),
    };
    all.gradient.iter().enumerate().map(of).collect()
}

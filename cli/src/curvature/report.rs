//! What `regge curvature` writes.

use super::drawn::Fields;
use super::enclosed::Enclosures;
use super::everywhere::Everywhere;
use super::given::Given;
use super::settle::{SUMS_SETTLE, Settled};
use super::topology::Piece;
use regge_curvature::functional::Sums;
use regge_readers::mesh::Group;
use serde::Serialize;
use std::collections::BTreeMap;

/// The version of the form of JSON and NumPy files. A field more does not change it, a field less or another meaning does.
pub const FORMAT: u32 = 1;

/// The curvature of a Regge metric on a mesh from a file.
#[derive(Clone, Debug, Default, Serialize)]
pub struct CurvatureReport {
    /// Of what metric.
    #[serde(flatten)]
    pub about: About,
    /// Cells of the mesh.
    pub cell_count: usize,
    /// No boundary?
    pub closed: bool,
    /// What boundary terms are in the sums: `none`, the paper's choice, or `gauss-bonnet`.
    pub boundary: &'static str,
    /// Σ_T ∫ R + 2 Σ̊_F ∫ ⟦H⟧ + 2 Σ̊_S ∫ Θ_S, with the boundary terms if there are: the functional at v = 1.
    pub total_curvature: f64,
    /// Σ_k (−1)^k |𝒯^k|.
    pub euler_characteristic: i64,
    /// Total curvature − 4πχ, for surfaces that are closed or have their boundary terms.
    pub gauss_bonnet_residual: Option<f64>,
    /// The connected pieces of the mesh, one as a rule.
    pub pieces: Vec<Piece>,
    /// The errors in the norms that were asked for, by the norm's name: `hm2`.
    #[serde(flatten)]
    pub norms: BTreeMap<&'static str, NormError>,
    /// The physical groups of the mesh file.
    pub physical_groups: Vec<Group>,
    /// The hat functions of the interior vertices; of all of them where there are boundary terms.
    pub vertices: Vec<VertexSums>,
    /// All test functions of the degree asked for, as far as they are tested.
    pub test_functions: Option<Vec<TestSums>>,
    /// R_h^(q).
    pub r_h: Option<ProjectedCurvature>,
    /// The interior hinges.
    pub hinges: Option<Vec<HingeDefect>>,
    /// The interior faces.
    pub faces: Option<Vec<FaceJump>>,
    /// ∫ R ω of the cells, in the order of the file.
    pub cells: Option<Vec<f64>>,
    /// What is proven of the numbers, if that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosures: Option<Enclosures>,
    /// What is proven of the curvature at every point, if that was asked for and the degree is not 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub everywhere: Option<Everywhere>,
    /// What there is to be seen, if that was asked for.
    #[serde(skip)]
    pub fields: Option<Fields>,
}

/// What every report says of its metric and its sums.
#[derive(Clone, Debug, Default, Serialize)]
pub struct About {
    /// The version of the form of the file: docs/formats.md.
    pub format: u32,
    /// The version of the program.
    pub version: &'static str,
    /// The mesh file.
    pub mesh: String,
    /// N.
    pub dimension: usize,
    /// r.
    pub degree: usize,
    /// How the Regge metric was made: the interpolant's name, `lengths`, or `points` for the surface's own.
    pub interpolant: String,
    /// The quadrature of the sums.
    pub quadrature: QuadratureUsed,
    /// What is to be known of the mesh and the metric beside the numbers, a line each.
    pub notes: Vec<String>,
}

impl About {
    /// Of a metric, and how its sums settled.
    pub(super) fn of<const N: usize, T>(given: &Given<'_, N>, sums: &Settled<T>) -> Self {
        Self {
            format: FORMAT,
            version: env!("CARGO_PKG_VERSION"),
            mesh: given.file.file.display().to_string(),
            dimension: N,
            degree: given.g_h.space().degree(),
            interpolant: given.interpolant.into(),
            quadrature: QuadratureUsed::of(sums, SUMS_SETTLE),
            notes: given.notes.clone(),
        }
    }
}

/// By which order was integrated, and what the last raise of it changed.
#[derive(Clone, Debug, Default, Serialize)]
pub struct QuadratureUsed {
    /// The order of the rules on cells, faces and hinges.
    pub order: usize,
    /// The largest change of a sum by the last raise, relative to the largest sum; null if the order was given.
    pub change: Option<f64>,
    /// Is that below what was wanted? null if the order was given.
    pub settled: Option<bool>,
}

impl QuadratureUsed {
    /// How something settled that may still change by `limit`.
    pub(super) fn of<T>(settled: &Settled<T>, limit: f64) -> Self {
        Self {
            order: settled.order,
            change: settled.change,
            settled: settled.change.map(|change| change <= limit),
        }
    }

    /// Is a result by this order in doubt?
    pub fn is_unsettled(&self) -> bool {
        self.settled == Some(false)
    }
}

/// R_h^(q): the L²(Ω, g_h)-projection of the distributional curvature onto Lagrange functions of degree q.
#[derive(Clone, Debug, Serialize)]
pub struct ProjectedCurvature {
    /// q.
    pub degree: usize,
    /// Its coefficients in Bernstein's basis; those of vertices are its values there.
    pub coefficients: Vec<Projected>,
}

/// One coefficient.
#[derive(Clone, Debug, Serialize)]
pub struct Projected {
    /// The vertices of the simplex that carries the basis function.
    pub simplex: Vec<u32>,
    /// The coefficient.
    pub value: f64,
}

/// ‖(Rω)_dist(g_h) − (Rω)(g)‖ in a dual norm.
#[derive(Clone, Debug, Serialize)]
pub struct NormError {
    /// How the norm is written in plain text.
    #[serde(skip)]
    pub symbol: &'static str,
    /// The error.
    pub error: f64,
    /// The degree of the norm's test functions: r + 2 for H⁻².
    pub degree: usize,
    /// What solved for it: `cholesky`, a factorisation, or `cg`, conjugate gradients without a matrix.
    pub solver: &'static str,
    /// How many steps it took, if it is iterative.
    pub steps: Option<usize>,
    /// The residual of the last step over the first one, in the norm of the preconditioner.
    pub residual: Option<f64>,
    /// How many unknowns there were, clamped ones included.
    pub unknowns: usize,
    /// The quadrature of the functionals.
    pub quadrature: QuadratureUsed,
}

/// A functional for one test function, by parts, factors 2 included.
#[derive(Clone, Debug, Serialize)]
pub struct Parts {
    /// Σ_T.
    pub cells: f64,
    /// Σ_F.
    pub faces: f64,
    /// Σ_S.
    pub hinges: f64,
    /// The boundary terms, if they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub boundary: Option<f64>,
    /// Their sum.
    pub total: f64,
}

impl Parts {
    /// For each test function of a space.
    pub(super) fn of(inner: &Sums<f64>, boundary: Option<&[f64]>) -> Vec<Self> {
        let of = |(dof, inner_total): (usize, f64)| {
            let boundary = boundary.map(|b| b[dof]);
            Self {
                cells: inner.cells[dof],
                faces: inner.faces[dof],
                hinges: inner.hinges[dof],
                boundary,
                total: inner_total + boundary.unwrap_or(0.0),
            }
        };
        inner.total().into_iter().enumerate().map(of).collect()
    }
}

/// The curvature against the hat function of a vertex.
#[derive(Clone, Debug, Serialize)]
pub struct VertexSums {
    /// Its index in the file, from 0, those not counted that belong to no cell.
    pub vertex: usize,
    /// The sums.
    #[serde(flatten)]
    pub sums: Parts,
    /// For N = 2, what is said of surfaces.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub surface: Option<OnSurface>,
}

/// The Gauss curvature K = R/2 of a surface at a vertex, φ its hat function.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OnSurface {
    /// ∫ φ ω: for flat triangles a third of the area around it.
    pub area: f64,
    /// ∫ K φ ω, half of the total: for flat triangles the angle defect, on the boundary (where its terms are asked for) π − Σθ.
    #[serde(rename = "K_integral")]
    pub k_integral: f64,
    /// ½ R_h at the vertex, if R_h was computed; none on the boundary, where the functional has point measures and no function.
    #[serde(rename = "K", skip_serializing_if = "Option::is_none")]
    pub k: Option<f64>,
}

/// The curvature against one of Bernstein's basis functions.
#[derive(Clone, Debug, Serialize)]
pub struct TestSums {
    /// The vertices of the simplex that carries the function.
    pub simplex: Vec<u32>,
    /// The sums.
    #[serde(flatten)]
    pub sums: Parts,
}

/// A hinge.
#[derive(Clone, Debug, Serialize)]
pub struct HingeDefect {
    /// Its vertices.
    pub vertices: Vec<u32>,
    /// Θ_S at its barycentre.
    pub defect: f64,
    /// |S|.
    pub volume: f64,
}

/// A face.
#[derive(Clone, Debug, Serialize)]
pub struct FaceJump {
    /// Its vertices.
    pub vertices: Vec<u32>,
    /// ∫ ⟦H⟧ ω_F.
    pub jump: f64,
}

//! From a mesh and a metric, or a mesh and edge lengths, to the distributional curvature.

mod evaluate;
mod local;
mod report;
mod settle;
mod smooth;

pub use report::{
    CurvatureReport, FaceJump, HingeDefect, NormError, QuadratureUsed, TestSums, VertexSums,
};

use crate::input::InputError;
use crate::input::mesh::MeshFile;
use crate::input::metric::MetricFile;
use crate::input::read_lengths;
use evaluate::Evaluation;
use regge::quadrature::Rule;
use regge::regge::ReggeSpace;
use regge::smooth::Smooth;
use regge_study::{Interpolation, Named, ProjectionKind};
use std::path::PathBuf;

/// Where the Regge metric comes from.
#[derive(Clone, Debug)]
pub enum Source {
    /// A smooth metric, to be interpolated.
    Metric(Box<MetricFile>, Interpolation),
    /// A table of edge lengths.
    Lengths(PathBuf),
}

/// What is to be computed.
#[derive(Clone, Debug)]
pub struct Request {
    /// r.
    pub degree: usize,
    /// The order of quadrature; None: raised until the sums settle.
    pub quadrature: Option<usize>,
    /// Sums for all test functions of this degree, beside the hat functions.
    pub test_degree: Option<usize>,
    /// The error in H⁻² too?
    pub norm: bool,
}

/// Why there is no curvature.
#[derive(Clone, Debug, thiserror::Error)]
pub enum CurvatureError {
    /// A file or a request is to blame.
    #[error("{0}")]
    Input(String),
    /// The computation failed.
    #[error("{0}")]
    Failed(String),
}

impl From<InputError> for CurvatureError {
    fn from(error: InputError) -> Self {
        Self::Input(error.to_string())
    }
}

fn input(error: regge::Error) -> CurvatureError {
    CurvatureError::Input(error.to_string())
}

fn failed(error: regge::Error) -> CurvatureError {
    CurvatureError::Failed(error.to_string())
}

/// The curvature of the Regge metric on the mesh.
///
/// # Errors
/// Whether the input is to blame or the computation, and what is wrong where.
pub fn curvature(
    mesh: &MeshFile,
    source: &Source,
    request: &Request,
) -> Result<CurvatureReport, CurvatureError> {
    if let Source::Metric(metric, _) = source
        && metric.dimension != mesh.dimension
    {
        return Err(CurvatureError::Input(format!(
            "the metric has dimension {}, the mesh {} has {}",
            metric.dimension,
            mesh.file.display(),
            mesh.dimension
        )));
    }
    match mesh.dimension {
        2 => in_dimension::<2>(mesh, source, request),
        3 => in_dimension::<3>(mesh, source, request),
        4 => in_dimension::<4>(mesh, source, request),
        n => Err(CurvatureError::Input(format!(
            "{}: dimension {n}; the program is built for 2, 3 and 4",
            mesh.file.display()
        ))),
    }
}

fn in_dimension<const N: usize>(
    file: &MeshFile,
    source: &Source,
    request: &Request,
) -> Result<CurvatureReport, CurvatureError> {
    match source {
        Source::Metric(metric, interpolation) => {
            by_metric::<N>(file, metric, *interpolation, request)
        }
        Source::Lengths(lengths) => {
            let mesh = file.abstract_mesh::<N>()?;
            let space = ReggeSpace::new(&mesh, 0);
            let squares = read_lengths(lengths, &mesh)?;
            let g_h = space.function(squares).map_err(failed)?;
            Evaluation::new(file, &g_h, request).report("lengths", None)
        }
    }
}

fn by_metric<const N: usize>(
    file: &MeshFile,
    metric: &MetricFile,
    interpolation: Interpolation,
    request: &Request,
) -> Result<CurvatureReport, CurvatureError> {
    let mesh = file.mesh::<N>()?;
    let g = Smooth::new(&mesh, metric.metric()).map_err(input)?;
    // Where the interpolant looks at g, and the curvature at g_h, to begin with.
    smooth::check_formula(&g, &Rule::new(N, 2 * request.degree + 2)).map_err(input)?;
    smooth::check_edges(&g, request.degree).map_err(input)?;
    let space = ReggeSpace::new(&mesh, request.degree);
    let g_h = interpolation.apply(&space, &g, ProjectionKind::Exact);
    let g_h = g_h.map_err(failed)?;
    let exact = metric.exact_scalar_curvature.as_ref();
    let evaluation = Evaluation::new(file, &g_h, request);
    evaluation.report(interpolation.name_of(), Some((&g, exact)))
}

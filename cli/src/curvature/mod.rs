//! From a mesh with its points, with a metric, or with edge lengths, to the distributional curvature.

mod action;
mod arrays;
mod drawn;
mod einstein;
mod enclosed;
mod evaluate;
mod everywhere;
mod fields;
mod given;
mod norm;
mod pieces;
mod report;
mod settle;
mod simplices;
mod smooth;
mod sums;
mod surface;
mod topology;

pub use action::{ActionReport, EdgeDerivative, action};
pub use arrays::Arrays;
pub use drawn::{Fields, FlatPiece};
pub use einstein::{EinsteinReport, EinsteinSums, einstein};
pub use enclosed::{Bounds, EdgeEnclosure, Enclosures, HingeEnclosure};
pub use everywhere::{Everywhere, Signs, SimplexBounds};
pub use given::{Phase, Source};
pub use norm::LARGEST_WITH_NORM;
pub use report::{
    About, CurvatureReport, FaceJump, HingeDefect, NormError, OnSurface, Parts, Projected,
    ProjectedCurvature, QuadratureUsed, TestSums, VertexSums,
};
pub use topology::Piece;

use given::{Given, by_dimension};
use regge_readers::InputError;
use regge_readers::mesh::MeshFile;
use std::fmt;

/// The largest N that the program is built for.
pub const LARGEST_DIMENSION: usize = 5;

/// What is done on the boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Boundary {
    /// Nothing, as in the paper: test functions vanish there.
    None,
    /// The terms of Gauss and Bonnet are added, and all test functions are used.
    GaussBonnet,
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
    /// The error in this norm too, a name of `regge_curvature::norm::Kind`.
    pub norm: Option<&'static str>,
    /// Take a stated R for the metric's own without a look?
    pub trust_stated: bool,
    /// The boundary's part.
    pub boundary: Boundary,
    /// Hinges, faces, cells and R_h one by one?
    pub details: bool,
    /// What a picture needs?
    pub fields: bool,
    /// The table of the vertices, with R_h there?
    pub table: bool,
    /// Enclosures for degree 0, bounds everywhere for higher ones?
    pub certified: bool,
}

/// Why there is no curvature.
#[derive(Clone, Debug)]
pub enum CurvatureError {
    /// A file or a request is to blame.
    Input(String),
    /// The computation failed.
    Failed(String),
}

impl std::error::Error for CurvatureError {}

impl fmt::Display for CurvatureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(reason) | Self::Failed(reason) => f.write_str(reason),
        }
    }
}

impl From<InputError> for CurvatureError {
    fn from(error: InputError) -> Self {
        Self::Input(error.to_string())
    }
}

fn input(error: regge_curvature::Error) -> CurvatureError {
    CurvatureError::Input(error.to_string())
}

fn failed(error: regge_curvature::Error) -> CurvatureError {
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
    phase: Phase<'_>,
) -> Result<CurvatureReport, CurvatureError> {
    if request.fields {
        fields::check(mesh)?;
    }
    by_dimension!(mesh, N => {
        let given = Given::<N>::new(mesh, source, request.degree, phase)?;
        evaluate::report(&given, request, phase)
    })
}

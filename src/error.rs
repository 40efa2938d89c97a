//! Floor 1. One error type: what is wrong, where, and with what value.

use std::fmt;

/// Why an input was refused or a computation could not be done.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// The input as a whole makes no sense: no cells, a dimension below 2, a list of the wrong length.
    Input(String),
    /// A cell cannot be part of a mesh.
    Cell {
        /// Its index in the list that was given.
        cell: usize,
        /// What is wrong with it.
        reason: String,
    },
    /// A vertex cannot be part of a mesh.
    Vertex {
        /// Its index in the list that was given.
        vertex: usize,
        /// What is wrong with it.
        reason: String,
    },
    /// The cells do not form a manifold along this simplex.
    NotAManifold {
        /// The vertices of the simplex.
        simplex: Vec<usize>,
        /// A cell that contains it.
        cell: usize,
        /// In which way.
        reason: String,
    },
    /// A metric is not positive definite.
    Indefinite {
        /// The cell.
        cell: usize,
        /// Barycentric coordinates in the cell, vertices in ascending order.
        point: Vec<f64>,
        /// The pivot of LDLᵀ that is not positive (or is NaN).
        pivot: f64,
    },
    /// An edge has no length: the geodesic left the domain of the formula, or was not found.
    Edge {
        /// Its two vertices.
        vertices: [usize; 2],
        /// Why.
        reason: String,
    },
    /// The mesh has no coordinates, and the operation needs them.
    NoCoordinates(&'static str),
    /// A linear system could not be solved.
    Solver(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(reason) => write!(f, "{reason}"),
            Self::Cell { cell, reason } => write!(f, "cell {cell}: {reason}"),
            Self::Vertex { vertex, reason } => write!(f, "vertex {vertex}: {reason}"),
            Self::NotAManifold {
                simplex,
                cell,
                reason,
            } => {
                write!(
                    f,
                    "not a manifold at the simplex {simplex:?} of cell {cell}: {reason}"
                )
            }
            Self::Indefinite { cell, point, pivot } => write!(
                f,
                "the metric is not positive definite in cell {cell} at barycentric point {point:?} \
                 (pivot {pivot:e}): refine the mesh, raise the degree or check the metric"
            ),
            Self::Edge {
                vertices: [a, b],
                reason,
            } => write!(f, "edge {a}-{b}: {reason}"),
            Self::NoCoordinates(what) => {
                write!(f, "the mesh has no vertex coordinates, which {what} needs")
            }
            Self::Solver(reason) => write!(f, "linear solver: {reason}"),
        }
    }
}

impl std::error::Error for Error {}

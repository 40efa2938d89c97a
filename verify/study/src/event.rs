//! What an observer of a study is told, and how a study fails.

use crate::case::Case;
use crate::row::Row;
use regge_curvature::Error;
use regge_curvature::norm::Step;
use std::fmt;

/// What a study is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Makes the mesh.
    Mesh,
    /// Sets up the solver of the biharmonic problem.
    SetUp,
    /// Makes g_h.
    Interpolate,
    /// Integrates the functional.
    Load,
    /// Solves the biharmonic problem.
    Solve,
    /// Takes the norm.
    Norm,
}

impl fmt::Display for Phase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Mesh => "mesh",
            Self::SetUp => "set-up of the solver",
            Self::Interpolate => "interpolation",
            Self::Load => "functional",
            Self::Solve => "solution",
            Self::Norm => "norm",
        })
    }
}

/// What an observer is told.
#[derive(Clone, Copy, Debug)]
pub enum Event<'a> {
    /// A phase of a case begins.
    Phase(Case, Phase),
    /// A step of an iterative solver.
    Step(Case, Step),
    /// A row is there.
    Row(&'a Row),
    /// All rows of a case are there.
    Done(Case),
}

/// Why and where a study stopped.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// The case, if one had begun.
    pub case: Option<Case>,
    /// The reason.
    pub error: Error,
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(Case { degree, level }) = self.case {
            write!(f, "degree {degree}, level {level}: ")?;
        }
        write!(f, "{}", self.error)
    }
}

impl std::error::Error for Failure {}

//! Floor 1. Why a call fails, and the Python exception that says so.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use regge_curvature::Error;
use regge_readers::{InputError, Place};

/// Why a call fails.
#[derive(Debug)]
pub enum Failure {
    /// The library's refusal.
    Library(Error),
    /// A file that was refused.
    File(InputError),
    /// An argument makes no sense.
    Value(String),
    /// What Python raised.
    Python(PyErr),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Library(error)
    }
}

impl From<InputError> for Failure {
    fn from(error: InputError) -> Self {
        Self::File(error)
    }
}

impl From<PyErr> for Failure {
    fn from(error: PyErr) -> Self {
        Self::Python(error)
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Python(error) => error,
            Failure::Value(reason) => PyValueError::new_err(reason),
            Failure::Library(error) => Python::attach(|py| library(py, &error)),
            Failure::File(error) => Python::attach(|py| file(py, &error)),
        }
    }
}

/// An exception of the family in `regge/_errors.py`; if that fails, what Python says of it.
fn raise<'py>(
    py: Python<'py>,
    class: &str,
    message: String,
    attributes: impl FnOnce(&Bound<'py, PyDict>) -> PyResult<()>,
) -> PyErr {
    let made = || -> PyResult<Bound<'py, PyAny>> {
        let class = py.import("regge._errors")?.getattr(class)?;
        let kwargs = PyDict::new(py);
        attributes(&kwargs)?;
        class.call((message,), Some(&kwargs))
    };
    made().map_or_else(|error| error, PyErr::from_value)
}

fn library(py: Python<'_>, error: &Error) -> PyErr {
    let message = error.to_string();
    match error {
        Error::Cell { cell, .. } => {
            raise(py, "CellError", message, |with| with.set_item("cell", cell))
        }
        Error::Vertex { vertex, .. } => raise(py, "VertexError", message, |with| {
            with.set_item("vertex", vertex)
        }),
        Error::NotAManifold { simplex, cell, .. } => raise(py, "ManifoldError", message, |with| {
            with.set_item("simplex", simplex)?;
            with.set_item("cell", cell)
        }),
        Error::Indefinite { cell, point, pivot } => raise(py, "IndefiniteError", message, |with| {
            with.set_item("cell", cell)?;
            with.set_item("point", point)?;
            with.set_item("pivot", pivot)
        }),
        Error::Edge { vertices, .. } => raise(py, "EdgeError", message, |with| {
            with.set_item("vertices", vertices.to_vec())
        }),
        Error::NoCoordinates(_) => raise(py, "NoCoordinatesError", message, |_| Ok(())),
        Error::Solver(_) => raise(py, "SolverError", message, |_| Ok(())),
        _ => raise(py, "InputError", message, |_| Ok(())),
    }
}

fn file(py: Python<'_>, error: &InputError) -> PyErr {
    raise(py, "FileError", error.to_string(), |with| {
        with.set_item("file", error.file.display().to_string())?;
        match error.place {
            Place::Line(line) => with.set_item("line", line),
            Place::Byte(byte) => with.set_item("byte", byte),
            Place::Whole => Ok(()),
        }
    })
}

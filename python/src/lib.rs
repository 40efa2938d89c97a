//! The native half of the Python package `regge`: handles of any dimension, and calls that give the interpreter back.
//!
//! The Python half (`regge/*.py`) has the documentation, checks what it is given and builds results; this half holds no
//! formula. Modules import only from floors below their own:
//!
//! | floor | modules |
//! |---|---|
//! | 1 | `failure`, `arrays` |
//! | 2 | `job` |
//! | 3 | `watched`, `source` |
//! | 4 | `function` |
//! | 5 | `space` |
//! | 6 | `mesh` |
//!
//! The dimension is known at run time only. What depends on it sits behind three traits ([`mesh::AnyMesh`],
//! [`space::AnySpace`], [`function::AnyFunction`]), each implemented once for every N; `by_dimension!` makes a mesh and
//! chooses N in doing so, the one place that does.

mod arrays;
mod failure;
mod function;
mod job;
mod mesh;
mod source;
mod space;
mod watched;

use pyo3::prelude::*;

/// Handles and functions; everything that is public has its face in the package `regge`.
#[pymodule]
mod _regge {
    #[pymodule_export]
    use super::function::{Function, default_order, norms};
    #[pymodule_export]
    use super::job::{num_threads, set_num_threads};
    #[pymodule_export]
    use super::mesh::Mesh;
    #[pymodule_export]
    use super::source::{Source, known_metrics};
    #[pymodule_export]
    use super::space::{Space, interpolants};
    #[pymodule_export]
    use super::unused_width;
}

/// What a build for this machine would gain, in a line; None where nothing is lost.
#[pyfunction]
fn unused_width() -> Option<String> {
    regge_curvature::scalar::Lanes::unused_width().map(|what| what.to_string())
}

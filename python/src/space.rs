//! Floor 5. Regge spaces of any dimension.

use crate::arrays::{array1, array2, integers, slice};
use crate::failure::Failure;
use crate::function::{AnyFunction, Function};
use numpy::{PyArray2, PyArray4, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use regge_curvature::field::Evaluate;
use regge_curvature::simplex::{Bernstein, Points};
use regge_curvature::spaces::{BasisFunction, TestSpace};
use regge_curvature::{Error, Interpolant, Mesh, ReggeSpace};
use std::sync::Arc;

/// What a Regge space offers, whatever its dimension.
pub trait AnySpace: Send + Sync {
    /// N.
    fn dimension(&self) -> usize;
    /// r.
    fn degree(&self) -> usize;
    /// How many degrees of freedom.
    fn len(&self) -> usize;
    /// How many of them a cell has.
    fn cell_len(&self) -> usize;
    /// The numbers of those of every cell.
    fn cell_dofs(&self) -> Vec<i64>;
    /// The dimension and the number of the simplex that each belongs to.
    fn owners(&self) -> Vec<i64>;
    /// The basis functions of a cell in its reference coordinates: `[point][function][i][j]`.
    fn tabulate(&self, points: &Points) -> Result<Vec<f64>, Error>;
    /// The function with these coefficients.
    fn function(&self, coefficients: Vec<f64>) -> Result<Arc<dyn AnyFunction>, Error>;
}

impl<const N: usize> AnySpace for ReggeSpace<N> {
    fn dimension(&self) -> usize {
        N
    }

    fn degree(&self) -> usize {
        self.degree()
    }

    fn len(&self) -> usize {
        self.len()
    }

    fn cell_len(&self) -> usize {
        TestSpace::cell_len(self)
    }

    fn cell_dofs(&self) -> Vec<i64> {
        let (mut all, mut dofs) = (Vec::new(), Vec::new());
        for cell in 0..self.mesh().cell_count() {
            dofs.clear();
            self.push_dofs(cell, &mut dofs);
            all.extend(integers(dofs.iter().copied()));
        }
        all
    }

    fn owners(&self) -> Vec<i64> {
        let owner = |dof| {
            let (k, simplex) = self.numbering().owner(dof);
            [k as i64, simplex as i64]
        };
        (0..self.len()).flat_map(owner).collect()
    }

    fn tabulate(&self, points: &Points) -> Result<Vec<f64>, Error> {
        // On every cell they are the same as on a mesh of one cell.
        let one = Self::new(&Mesh::single()?, self.degree());
        let mut numbers = Vec::new();
        one.push_dofs(0, &mut numbers);
        let table: Vec<_> = (numbers.iter())
            .map(|&number| {
                let function = BasisFunction::new(&one, number);
                let table = Evaluate::<f64, N>::tabulate(&function, points);
                let local = Evaluate::<f64, N>::on_cell(&function, 0);
                (0..points.len())
                    .map(|q| function.value(&local, &table, q))
                    .collect::<Vec<_>>()
            })
            .collect();
        let mut all = Vec::with_capacity(points.len() * numbers.len() * N * N);
        for q in 0..points.len() {
            for values in &table {
                // Symmetric: rows are columns.
                all.extend(values[q].iter());
            }
        }
        Ok(all)
    }

    fn function(&self, coefficients: Vec<f64>) -> Result<Arc<dyn AnyFunction>, Error> {
        Ok(Arc::new(self.function(coefficients)?))
    }
}

/// A Regge space.
#[pyclass(frozen, module = "regge._regge")]
pub struct Space {
    /// The space.
    pub inner: Arc<dyn AnySpace>,
}

#[pymethods]
impl Space {
    #[getter]
    fn degree(&self) -> usize {
        self.inner.degree()
    }

    #[getter]
    fn len(&self) -> usize {
        self.inner.len()
    }

    fn cell_dofs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i64>>> {
        let width = self.inner.cell_len();
        array2(py, self.inner.cell_dofs(), width)
    }

    fn owners<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<i64>>> {
        array2(py, self.inner.owners(), 2)
    }

    /// `[point][function][i][j]`, at points by their barycentric coordinates.
    fn tabulate<'py>(
        &self,
        py: Python<'py>,
        points: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray4<f64>>> {
        let (n, width) = (self.inner.dimension(), self.inner.cell_len());
        let points = Points::new(n + 1, points.as_slice()?.to_vec());
        let all = self.inner.tabulate(&points).map_err(Failure::from)?;
        array1(py, all).reshape([points.len(), width, n, n])
    }

    /// Bernstein's polynomials `[point][α]` in which edge components are expanded.
    fn bernstein<'py>(
        &self,
        py: Python<'py>,
        points: PyReadonlyArray2<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let vertices = self.inner.dimension() + 1;
        let points = Points::new(vertices, points.as_slice()?.to_vec());
        let basis = Bernstein::new(vertices, self.inner.degree());
        let all = basis.tabulate::<f64>(&points).concat();
        array2(py, all, basis.len())
    }

    fn function(&self, coefficients: PyReadonlyArray1<'_, f64>) -> PyResult<Function> {
        let coefficients = slice(&coefficients)?.to_vec();
        let inner = self.inner.function(coefficients).map_err(Failure::from)?;
        Ok(Function::new(inner))
    }
}

/// Names and descriptions of the interpolants.
#[pyfunction]
pub fn interpolants() -> Vec<(&'static str, &'static str)> {
    Interpolant::ALL
        .iter()
        .map(|one| (one.name(), one.about()))
        .collect()
}

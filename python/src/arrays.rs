//! Floor 1. NumPy's arrays and ours: results move into NumPy, arguments are read where they are.

use crate::failure::Failure;
use numpy::{
    Element, Ix1, Ix2, Ix3, PyArray, PyArray1, PyArrayMethods, PyReadonlyArray, PyReadonlyArray1,
    PyReadonlyArray2,
};
use pyo3::prelude::*;

/// An array of floating point numbers with D axes.
type Floats<'py, D> = Bound<'py, PyArray<f64, D>>;

/// A list as an array, without a copy.
pub fn array1<T: Element>(py: Python<'_>, values: Vec<T>) -> Bound<'_, PyArray1<T>> {
    PyArray1::from_vec(py, values)
}

/// A list, row by row, as an array with rows of this length.
pub fn array2<T: Element>(
    py: Python<'_>,
    values: Vec<T>,
    width: usize,
) -> PyResult<Bound<'_, PyArray<T, Ix2>>> {
    let rows = values.len() / width;
    array1(py, values).reshape([rows, width])
}

/// A list of square matrices, row by row.
pub fn matrices(py: Python<'_>, values: Vec<f64>, n: usize) -> PyResult<Floats<'_, Ix3>> {
    let count = values.len() / (n * n);
    array1(py, values).reshape([count, n, n])
}

/// The numbers of an array that is known to be contiguous.
pub fn slice<'a, T: Element>(array: &'a PyReadonlyArray<'_, T, Ix1>) -> PyResult<&'a [T]> {
    Ok(array.as_slice()?)
}

/// Vertices of cells as the library takes them; what is negative cannot be a vertex.
pub fn cells(array: &PyReadonlyArray2<'_, i64>) -> Result<Vec<Vec<usize>>, Failure> {
    let rows = array.as_array();
    let row = |(cell, row): (usize, numpy::ndarray::ArrayView1<'_, i64>)| {
        let vertex = |v: &i64| {
            usize::try_from(*v)
                .map_err(|_| Failure::Value(format!("cells: row {cell} has the vertex {v}")))
        };
        row.iter().map(vertex).collect()
    };
    rows.rows().into_iter().enumerate().map(row).collect()
}

/// Indices that are known not to be negative.
pub fn indices(array: &PyReadonlyArray1<'_, i64>, below: usize) -> Result<Vec<usize>, Failure> {
    let index = |(row, i): (usize, &i64)| match usize::try_from(*i) {
        Ok(i) if i < below => Ok(i),
        _ => Err(Failure::Value(format!(
            "row {row}: {i} is not in 0..{below}"
        ))),
    };
    array.as_array().iter().enumerate().map(index).collect()
}

/// usize as Python's integers.
pub fn integers(values: impl IntoIterator<Item = usize>) -> Vec<i64> {
    values.into_iter().map(|v| v as i64).collect()
}

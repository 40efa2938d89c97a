//! Meshes written down with serde (feature `serde`).
//!
//! In JSON: `{"version": 1, "dimension": 2, "vertices": [[0.0, 0.0], …], "corners": null, "cells": [[0, 1, 2], …]}`. A mesh with
//! several charts has `corners` in place of `vertices`: N+1 points for each cell. An abstract one has neither. What is read
//! goes through the constructors of [`Mesh`], which refuse what is no mesh; cells are listed with ascending vertices, so
//! that reading gives the same mesh to the bit.

use super::{Chart, Mesh};
use crate::Error;
use crate::linalg::Vector;
use serde::de::{Deserialize, Deserializer, Error as _};
use serde::{Serialize, Serializer};

/// The version of the documents of meshes and Regge functions. A change that old readers would misread raises it.
const VERSION: u64 = 1;

/// The field `version`, first in each document, so that another version is refused before anything else is looked at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Version;

impl Serialize for Version {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u64(VERSION)
    }
}

impl<'de> Deserialize<'de> for Version {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match u64::deserialize(deserializer)? {
            VERSION => Ok(Self),
            other => Err(D::Error::custom(format!(
                "the document has version {other}, and this library reads version {VERSION}"
            ))),
        }
    }
}

/// A mesh as it is written.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Document {
    version: Version,
    dimension: usize,
    #[serde(default)]
    vertices: Option<Vec<Vec<f64>>>,
    #[serde(default)]
    corners: Option<Vec<Vec<Vec<f64>>>>,
    cells: Vec<Vec<usize>>,
}

impl<const N: usize> From<Mesh<N>> for Document {
    fn from(mesh: Mesh<N>) -> Self {
        let list = |points: &[Vector<f64, N>]| -> Vec<Vec<f64>> {
            points.iter().map(|x| x.as_slice().to_vec()).collect()
        };
        let (vertices, corners) = match &mesh.chart {
            Chart::Abstract => (None, None),
            Chart::Vertices(points) => (Some(list(points)), None),
            Chart::Cells(points) => (None, Some(points.chunks(N + 1).map(list).collect())),
        };
        let vertices_of = |cell| mesh.vertices(N, cell).iter().map(|&v| v as usize).collect();
        Self {
            version: Version,
            dimension: N,
            vertices,
            corners,
            cells: (0..mesh.cell_count()).map(vertices_of).collect(),
        }
    }
}

impl<const N: usize> TryFrom<Document> for Mesh<N> {
    type Error = Error;

    fn try_from(document: Document) -> Result<Self, Error> {
        let (cells, n) = (document.cells, document.dimension);
        if n != N {
            return Err(Error::Input(format!("the mesh has dimension {n}, not {N}")));
        }
        match (document.vertices, document.corners) {
            (Some(points), None) => Self::new(vectors(&points)?, &cells),
            (None, Some(corners)) => {
                let corners: Result<Vec<_>, _> = corners.iter().map(|c| vectors(c)).collect();
                Self::with_cell_charts(vertex_count(&cells)?, &cells, &corners?)
            }
            (None, None) => Self::new_abstract(vertex_count(&cells)?, &cells),
            (Some(_), Some(_)) => Err(Error::Input(
                "a mesh has coordinates of vertices or corners of cells, not both".into(),
            )),
        }
    }
}

fn vectors<const N: usize>(points: &[Vec<f64>]) -> Result<Vec<Vector<f64, N>>, Error> {
    let vector = |x: &Vec<f64>| {
        let length = || Error::Input(format!("a point has {} coordinates, not {N}", x.len()));
        Ok(Vector::from(
            <[f64; N]>::try_from(x.as_slice()).map_err(|_| length())?,
        ))
    };
    points.iter().map(vector).collect()
}

/// One more than the largest vertex. All vertices belong to cells, so that there cannot be more than the cells list.
fn vertex_count(cells: &[Vec<usize>]) -> Result<usize, Error> {
    let listed = cells.iter().map(Vec::len).sum();
    match cells.iter().flatten().max() {
        Some(&largest) if largest < listed => Ok(largest + 1),
        Some(largest) => Err(Error::Input(format!(
            "vertex {largest} is too large a number where the cells list {listed} vertices"
        ))),
        None => Ok(0),
    }
}

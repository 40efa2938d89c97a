//! Our own JSON: `{"dimension": 4, "vertices": [[…], …], "cells": [[…], …]}`, without `vertices` an abstract manifold.

use super::MeshFile;
use crate::error::{Fault, Place};
use serde::Deserialize;
use std::path::PathBuf;

/// The file as it stands.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Raw {
    dimension: usize,
    vertices: Option<Vec<Vec<f64>>>,
    cells: Vec<Vec<usize>>,
}

/// The mesh in a file, whose name is added by the caller.
pub fn parse(bytes: &[u8]) -> Result<MeshFile, Fault> {
    let raw: Raw = serde_json::from_slice(bytes)
        .map_err(|error| Fault::new(Place::Line(error.line() as u64), error.to_string()))?;
    let n = raw.dimension;
    for (cell, list) in raw.cells.iter().enumerate() {
        if n.checked_add(1) != Some(list.len()) {
            let reason = format!(
                "cell {cell} has {} vertices, a {n}-simplex has one more than {n}",
                list.len()
            );
            return Err(Fault::new(Place::Whole, reason));
        }
    }
    let (vertices, width, coordinates) = match raw.vertices {
        Some(points) => (points.len(), width(&points, n)?, points.concat()),
        None => (largest(&raw.cells)?, n, Vec::new()),
    };
    Ok(MeshFile {
        file: PathBuf::new(),
        dimension: n,
        curved: None,
        vertices,
        coordinates,
        width,
        groups: Vec::new(),
        notes: Vec::new(),
        vertex_places: Vec::new(),
        cell_places: Vec::new(),
        cells: raw.cells,
    })
}

/// How many coordinates the points have: N or more, all as many. A mesh in the plane may be written with z.
fn width(points: &[Vec<f64>], n: usize) -> Result<usize, Fault> {
    let width = points.first().map_or(n, Vec::len);
    match points
        .iter()
        .enumerate()
        .find(|(_, p)| p.len() != width || width < n)
    {
        None => Ok(width),
        Some((vertex, point)) => {
            let expected = if width < n {
                format!("dimension {n} needs {n} at least")
            } else {
                format!("vertex 0 has {width}")
            };
            let reason = format!(
                "vertex {vertex} has {} coordinates, {expected}",
                point.len()
            );
            Err(Fault::new(Place::Whole, reason))
        }
    }
}

/// One more than the largest vertex; the cells must be able to use so many.
fn largest(cells: &[Vec<usize>]) -> Result<usize, Fault> {
    for (cell, list) in cells.iter().enumerate() {
        let Some(vertex) = list.iter().max() else {
            continue;
        };
        let most: usize = cells.len().saturating_mul(list.len());
        if *vertex >= most {
            let reason = format!(
                "cell {cell} names vertex {vertex}, but the cells can use {most} vertices only"
            );
            return Err(Fault::new(Place::Whole, reason));
        }
    }
    Ok(cells.iter().flatten().max().map_or(0, |v| v + 1))
}

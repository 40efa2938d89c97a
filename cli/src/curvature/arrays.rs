//! Reports as arrays with names: what NumPy is given.

use super::action::ActionReport;
use super::einstein::EinsteinReport;
use super::report::{CurvatureReport, Parts};
use crate::npz::Array;
use serde::Serialize;
use serde_json::Value;

/// What has lists of numbers, beside numbers that stand alone.
pub trait Arrays: Serialize {
    /// The lists of the JSON file, as arrays by name.
    fn arrays(&self) -> Vec<(String, Array)>;

    /// The rest of the JSON file, as text.
    ///
    /// # Errors
    /// Those of serde_json: none that is known.
    fn rest(&self) -> serde_json::Result<String>;
}

/// An object without these keys, as text.
fn without(report: &impl Serialize, keys: &[&str]) -> serde_json::Result<String> {
    let mut value = serde_json::to_value(report)?;
    if let Value::Object(map) = &mut value {
        keys.iter().for_each(|key| drop(map.remove(*key)));
    }
    serde_json::to_string(&value)
}

impl Arrays for CurvatureReport {
    fn arrays(&self) -> Vec<(String, Array)> {
        let mut all = Vec::new();
        let mut put = |name: &str, array: Array| all.push((name.to_owned(), array));
        let index = |v: &super::VertexSums| v.vertex as i32;
        put(
            "vertices_vertex",
            Array::ints(self.vertices.iter().map(index)),
        );
        sums("vertices", self.vertices.iter().map(|v| &v.sums), &mut put);
        if let Some(functions) = &self.test_functions {
            let simplices = functions.iter().map(|f| &*f.simplex);
            put("test_functions_simplex", Array::simplices(simplices));
            sums(
                "test_functions",
                functions.iter().map(|f| &f.sums),
                &mut put,
            );
        }
        if let Some(r_h) = &self.r_h {
            let list = || r_h.coefficients.iter();
            put("r_h_simplex", Array::simplices(list().map(|c| &*c.simplex)));
            put("r_h_value", Array::doubles(list().map(|c| c.value)));
        }
        if let Some(hinges) = &self.hinges {
            put(
                "hinges_vertices",
                Array::simplices(hinges.iter().map(|h| &*h.vertices)),
            );
            put(
                "hinges_defect",
                Array::doubles(hinges.iter().map(|h| h.defect)),
            );
            put(
                "hinges_volume",
                Array::doubles(hinges.iter().map(|h| h.volume)),
            );
        }
        if let Some(faces) = &self.faces {
            put(
                "faces_vertices",
                Array::simplices(faces.iter().map(|f| &*f.vertices)),
            );
            put("faces_jump", Array::doubles(faces.iter().map(|f| f.jump)));
        }
        if let Some(cells) = &self.cells {
            put("cells", Array::doubles(cells.iter().copied()));
        }
        all
    }

    fn rest(&self) -> serde_json::Result<String> {
        // The lists may be large: they are not made into values only to be left out.
        let alone = Self {
            about: self.about.clone(),
            norms: self.norms.clone(),
            physical_groups: self.physical_groups.clone(),
            pieces: self.pieces.clone(),
            vertices: Vec::new(),
            test_functions: None,
            r_h: None,
            hinges: None,
            faces: None,
            cells: None,
            enclosures: self.enclosures.clone(),
            everywhere: self.everywhere.clone(),
            fields: None,
            ..*self
        };
        let lists = [
            "vertices",
            "test_functions",
            "r_h",
            "hinges",
            "faces",
            "cells",
        ];
        without(&alone, &lists)
    }
}

impl Arrays for EinsteinReport {
    fn arrays(&self) -> Vec<(String, Array)> {
        let mut all = Vec::new();
        let mut put = |name: &str, array: Array| all.push((name.to_owned(), array));
        let list = || self.functions.iter();
        put(
            "functions_simplex",
            Array::simplices(list().map(|f| &*f.simplex)),
        );
        put(
            "functions_index",
            Array::ints(list().map(|f| f.index as i32)),
        );
        sums("functions", list().map(|f| &f.sums), &mut put);
        all
    }

    fn rest(&self) -> serde_json::Result<String> {
        let alone = Self {
            about: self.about.clone(),
            largest: self.largest,
            functions: Vec::new(),
        };
        without(&alone, &["functions"])
    }
}

impl Arrays for ActionReport {
    fn arrays(&self) -> Vec<(String, Array)> {
        let list = || self.gradient.iter().flatten();
        let arrays = [
            (
                "gradient_vertices",
                Array::simplices(list().map(|e| &*e.vertices)),
            ),
            ("gradient_length", Array::doubles(list().map(|e| e.length))),
            (
                "gradient_derivative",
                Array::doubles(list().map(|e| e.derivative)),
            ),
        ];
        let named = arrays
            .into_iter()
            .map(|(name, array)| (name.to_owned(), array));
        named.collect()
    }

    fn rest(&self) -> serde_json::Result<String> {
        let alone = Self {
            gradient: None,
            ..self.clone()
        };
        without(&alone, &["gradient"])
    }
}

/// The columns of sums.
fn sums<'a>(
    of: &str,
    list: impl Iterator<Item = &'a Parts> + Clone,
    put: &mut dyn FnMut(&str, Array),
) {
    let mut column = |name: &str, part: fn(&Parts) -> f64| {
        put(
            &format!("{of}_{name}"),
            Array::doubles(list.clone().map(part)),
        );
    };
    column("cells", |sums| sums.cells);
    column("faces", |sums| sums.faces);
    column("hinges", |sums| sums.hinges);
    if list.clone().any(|sums| sums.boundary.is_some()) {
        column("boundary", |sums| sums.boundary.unwrap_or(f64::NAN));
    }
    column("total", |sums| sums.total);
}

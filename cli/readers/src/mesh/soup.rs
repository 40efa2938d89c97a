//! What a file lists, before it is known which of it is the mesh: points, triangles, tetrahedra.

use super::{Group, MeshFile};
use crate::error::{Fault, Place};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Simplices of one dimension, by the index of their points.
#[derive(Default)]
pub struct Listed {
    /// The points of each.
    pub points: Vec<Vec<usize>>,
    /// Where each stands.
    pub places: Vec<Place>,
    /// The number that the file gives each, if it gives any; 0 is none.
    pub tags: Vec<i32>,
}

impl Listed {
    /// Adds one.
    pub fn push(&mut self, place: Place, points: Vec<usize>) {
        self.points.push(points);
        self.places.push(place);
    }
}

/// The content of a file.
#[derive(Default)]
pub struct Soup {
    /// Coordinates, `width` of them for each point.
    pub coordinates: Vec<f64>,
    /// How many a point has.
    pub width: usize,
    /// Where each point stands.
    pub places: Vec<Place>,
    /// The triangles.
    pub triangles: Listed,
    /// The tetrahedra: if there are any, they are the cells, and triangles are parts of the boundary.
    pub tetrahedra: Listed,
    /// What the reader did that the user should know.
    pub notes: Vec<String>,
}

impl Soup {
    /// Nothing yet, in space.
    pub fn new() -> Self {
        Self {
            width: 3,
            ..Self::default()
        }
    }

    /// Adds a point.
    pub fn point(&mut self, place: Place, x: &[f64]) {
        self.coordinates.extend_from_slice(x);
        self.places.push(place);
    }

    /// How many points.
    pub fn len(&self) -> usize {
        self.places.len()
    }

    /// The mesh, without the points that no cell uses.
    pub fn finish(self) -> Result<MeshFile, Fault> {
        let dimension = match self.tetrahedra.points.is_empty() {
            true => 2,
            false => 3,
        };
        if self.triangles.points.is_empty() && dimension == 2 {
            let reason = "there is no triangle and no tetrahedron";
            return Err(Fault::new(Place::Whole, reason));
        }
        for listed in [&self.triangles, &self.tetrahedra] {
            self.check_indices(listed)?;
        }
        if let Some(place) = lost(&self.triangles, &self.tetrahedra) {
            let reason =
                "a triangle that is no face of a tetrahedron: the mesh is of mixed dimension";
            return Err(Fault::new(place, reason));
        }
        let mut groups = Vec::new();
        if dimension == 3 {
            groups.extend(self.triangles.groups(2, false));
        }
        let cells = match dimension {
            2 => self.triangles,
            _ => self.tetrahedra,
        };
        groups.extend(cells.groups(dimension, true));
        let mut file = MeshFile {
            file: PathBuf::new(),
            dimension,
            curved: None,
            vertices: self.places.len(),
            coordinates: self.coordinates,
            width: self.width,
            groups,
            notes: self.notes,
            vertex_places: self.places,
            cell_places: cells.places,
            cells: cells.points,
        };
        file.drop_unused();
        Ok(file)
    }

    fn check_indices(&self, listed: &Listed) -> Result<(), Fault> {
        for (points, place) in listed.points.iter().zip(&listed.places) {
            if let Some(point) = points.iter().find(|p| **p >= self.places.len()) {
                let reason = format!(
                    "point {point} (counted from 0) does not exist: there are {}",
                    self.places.len()
                );
                return Err(Fault::new(*place, reason));
            }
        }
        Ok(())
    }
}

impl Listed {
    /// What has one tag is a group.
    fn groups(&self, dimension: usize, are_cells: bool) -> Vec<Group> {
        let mut all = BTreeMap::new();
        for (i, &tag) in self.tags.iter().enumerate().filter(|(_, tag)| **tag != 0) {
            let group = all.entry(tag).or_insert_with(|| Group {
                dimension,
                tag,
                name: None,
                cells: Vec::new(),
                simplices: Vec::new(),
            });
            match are_cells {
                true => group.cells.push(i as u32),
                false => group.simplices.push(self.points[i].clone()),
            }
        }
        all.into_values().collect()
    }
}

/// In a mesh of tetrahedra: a triangle that is not a face of one.
fn lost(triangles: &Listed, tetrahedra: &Listed) -> Option<Place> {
    if tetrahedra.points.is_empty() || triangles.points.is_empty() {
        return None;
    }
    let sorted = |points: [usize; 3]| {
        let mut points = points;
        points.sort_unstable();
        points
    };
    let mut faces: Vec<[usize; 3]> = Vec::with_capacity(4 * tetrahedra.points.len());
    for t in &tetrahedra.points {
        let face = |out: usize| sorted([0, 1, 2].map(|j| t[if j < out { j } else { j + 1 }]));
        faces.extend([0, 1, 2, 3].map(face));
    }
    faces.sort_unstable();
    let mut all = triangles.points.iter().zip(&triangles.places);
    let is_lost = |t: &[usize]| faces.binary_search(&sorted([t[0], t[1], t[2]])).is_err();
    all.find(|(t, _)| is_lost(t)).map(|(_, place)| *place)
}

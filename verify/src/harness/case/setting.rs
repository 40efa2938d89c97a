//! Where a claim on meshes is tried: meshes, degrees, orders of quadrature, by name. The floor above makes the meshes.

use regge_curvature::formulas::{Formulas, PAPER};
use regge_curvature::functional::Rules;

/// A mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One simplex.
    Single,
    /// One simplex cut at its barycentre: a boundary, one interior vertex, obtuse dihedral angles.
    Alfeld,
    /// (−1, 1)^N with this many cubes a side, inner vertices moved.
    Cube(usize),
    /// (−1, 1)^N with this many cubes a side, their vertices and midpoints by Delaunay: hinges of other valences.
    Delaunay(usize),
    /// A mesh of few cells, pressed together in a direction that is none of its edges', to heights of a thirtieth of the edges.
    Stretched,
    /// The flat torus with this many cubes a side.
    Torus(usize),
    /// ∂Δ^{N+1}.
    Sphere,
    /// The mesh of a reference case, by its number.
    Oracle(usize),
}

impl Shape {
    /// How large it is, roughly: meshes of one dimension in the order of their numbers of cells.
    fn size(self) -> usize {
        match self {
            Self::Single => 0,
            Self::Alfeld | Self::Stretched => 1,
            Self::Sphere => 2,
            Self::Cube(side) | Self::Torus(side) | Self::Delaunay(side) => 2 + side,
            Self::Oracle(number) => number,
        }
    }

    /// Without boundary?
    pub fn is_closed(self) -> bool {
        matches!(self, Self::Torus(_) | Self::Sphere)
    }
}

/// One case: a mesh, the degree r of the fields, the order of the quadrature.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// The mesh.
    pub shape: Shape,
    /// r.
    pub degree: usize,
    /// Exactness of the rules on cells, faces and hinges.
    pub order: usize,
    /// The degree of the test functions.
    pub test: usize,
    /// How many times as far from flat ones as elsewhere metrics are: where no quadrature is involved, they may be strongly curved.
    pub noise: f64,
    /// Which of a few: of formulas or interpolants, where a claim has them; else which repetition.
    pub pick: usize,
    /// By which formulas the library computes: the paper's, unless a sceptic breaks one.
    pub formulas: Formulas,
}

impl Setting {
    /// With test functions of degree 2.
    pub const fn new(shape: Shape, degree: usize, order: usize) -> Self {
        Self {
            shape,
            degree,
            order,
            test: 2,
            noise: 1.0,
            pick: 0,
            formulas: PAPER,
        }
    }

    /// With test functions of this degree.
    pub const fn tested_by(self, degree: usize) -> Self {
        Self {
            test: degree,
            ..self
        }
    }

    /// With metrics that are so many times as far from flat ones.
    pub const fn wild(self, noise: f64) -> Self {
        Self { noise, ..self }
    }

    /// Rules of the case's order, with its formulas.
    pub fn rules(&self, dimension: usize) -> Rules {
        Rules::new(dimension, self.order).with_formulas(self.formulas)
    }

    /// The simplest case first: by degree, then by the size of the mesh.
    pub(in crate::harness) fn complexity(&self) -> (usize, usize) {
        (self.degree, self.shape.size())
    }
}

/// Every shape with every degree, lowest degree first, `orders[r]` for degree r; each `times` times.
pub fn grid(shapes: &[Shape], orders: &[usize], times: usize) -> Vec<Setting> {
    let mut all = Vec::new();
    for (degree, order) in orders.iter().enumerate() {
        for shape in shapes {
            let at = Setting::new(*shape, degree, *order);
            all.extend((0..times).map(|pick| Setting { pick, ..at }));
        }
    }
    all
}

//! What pictures and ParaView are given: a mesh and fields on it, as lists of numbers.

/// A list of numbers with a name.
pub type Field = (&'static str, Vec<f64>);

/// A small flat triangle of a curved cell.
#[derive(Clone, Copy, Debug)]
pub struct FlatPiece {
    /// The cell.
    pub cell: usize,
    /// Barycentric coordinates of its middle in the cell, in the order of the cell's vertices.
    pub middle: [f64; 3],
    /// Its corners in space, in the cell's orientation.
    pub corners: [[f64; 3]; 3],
}

/// A mesh in the plane or in space with fields on its vertices and cells; NaN where a field is not defined.
#[derive(Clone, Debug, Default)]
pub struct Fields {
    /// N: triangles or tetrahedra.
    pub dimension: usize,
    /// Three coordinates a vertex.
    pub points: Vec<f64>,
    /// N+1 vertices a cell.
    pub cells: Vec<u32>,
    /// Curved triangles, cut into small flat ones; none where cells are straight.
    pub pieces: Vec<FlatPiece>,
    /// On vertices.
    pub on_points: Vec<Field>,
    /// On cells.
    pub on_cells: Vec<Field>,
    /// The tag of the first physical group of each cell, 0 where there is none.
    pub groups: Vec<i32>,
}

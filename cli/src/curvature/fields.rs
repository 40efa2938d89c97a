//! Mesh and curvature as lists of numbers for pictures and for ParaView.

use super::CurvatureError;
use super::drawn::{Field, Fields};
use super::given::Given;
use super::pieces::pieces;
use super::report::{CurvatureReport, VertexSums};
use regge_curvature::functional::{Rules, angle_defects, cell_volumes};
use regge_readers::mesh::MeshFile;

/// What surfaces have at vertices, by the names of [`super::OnSurface`].
const SURFACE: [&str; 3] = ["area", "K_integral", "K"];

/// Refuses a mesh that has no place in space.
pub fn check(file: &MeshFile) -> Result<(), CurvatureError> {
    let refuse = |what: String| {
        let path = file.file.display();
        Err(CurvatureError::Input(format!(
            "{path}: {what}, which VTU files and pictures need: ask for JSON"
        )))
    };
    match (file.has_coordinates(), file.dimension) {
        (false, _) => refuse("the mesh has no coordinates".into()),
        (true, 2 | 3) => Ok(()),
        (true, n) => refuse(format!("the mesh has dimension {n}, not 2 or 3")),
    }
}

/// What there is to be seen, with ∫R of the cells.
pub fn fields<const N: usize>(
    given: &Given<'_, N>,
    report: &CurvatureReport,
    rules: &Rules,
    cells: Vec<f64>,
) -> Fields {
    let (file, mesh) = (given.file, given.g_h.space().mesh());
    let volumes = cell_volumes(&given.g_h, mesh, rules);
    let mean = cells.iter().zip(&volumes).map(|(r, v)| r / v).collect();
    let mut on_points = on_vertices(report, file.vertices);
    if N == 2 {
        let mut theta = vec![f64::NAN; file.vertices];
        for vertex in angle_defects(&given.g_h, mesh, 1) {
            theta[vertex.hinge] = vertex.defect;
        }
        on_points.push(("Theta", theta));
    }
    Fields {
        dimension: N,
        points: points(file),
        cells: file.cells.iter().flatten().map(|&v| v as u32).collect(),
        pieces: given
            .points
            .as_ref()
            .map_or(Vec::new(), |map| pieces(map, file)),
        on_points,
        on_cells: vec![("R_integral", cells), ("volume", volumes), ("R", mean)],
        groups: file.cell_groups(),
    }
}

/// The sums of the hat functions, what surfaces have, and R_h.
fn on_vertices(report: &CurvatureReport, vertices: usize) -> Vec<Field> {
    let mut names = vec!["sum_cells", "sum_faces", "sum_hinges", "sum_total"];
    names.extend((report.boundary != "none").then_some("sum_boundary"));
    names.extend(SURFACE.iter().filter(|_| report.about.dimension == 2));
    let mut lists = vec![vec![f64::NAN; vertices]; names.len()];
    for VertexSums {
        vertex,
        sums,
        surface,
    } in &report.vertices
    {
        let mut values = vec![sums.cells, sums.faces, sums.hinges, sums.total];
        values.extend(sums.boundary);
        if let Some(on) = surface {
            values.extend([on.area, on.k_integral, on.k.unwrap_or(f64::NAN)]);
        }
        for (list, value) in lists.iter_mut().zip(values) {
            list[*vertex] = value;
        }
    }
    let mut fields: Vec<Field> = names.into_iter().zip(lists).collect();
    if let Some(r_h) = &report.r_h {
        // The coefficients of the vertices come first, and are the values there.
        let values = r_h.coefficients.iter().take(vertices);
        fields.push(("R_h", values.map(|c| c.value).collect()));
    }
    fields
}

/// Three coordinates a vertex.
fn points(file: &MeshFile) -> Vec<f64> {
    let of = |x: &[f64]| [0, 1, 2].map(|i| x.get(i).copied().unwrap_or(0.0));
    file.coordinates
        .chunks_exact(file.width)
        .flat_map(of)
        .collect()
}

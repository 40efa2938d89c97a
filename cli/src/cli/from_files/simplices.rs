//! Files about single hinges and faces: tables, and meshes of them for ParaView.

use regge_cli::curvature::{CurvatureReport, Fields};
use regge_cli::vtu;
use regge_terminal::Stop;
use regge_terminal::output::{self, Named};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Which files are wanted.
#[derive(clap::Args)]
#[group(skip)]
pub struct SimplexFiles {
    /// Write the inner hinges (vertices for N = 2, edges for N = 3) to this file: vertices, angle defect, volume
    #[arg(long, value_name = "FILE")]
    hinges_csv: Option<PathBuf>,
    /// Write the inner faces (edges for N = 2, triangles for N = 3) to this file: vertices, jump of the mean curvature
    #[arg(long, value_name = "FILE")]
    faces_csv: Option<PathBuf>,
    /// Write the inner hinges with their angle defects as a mesh of their own, for ParaView
    #[arg(long, value_name = "FILE.vtu")]
    hinges_vtu: Option<PathBuf>,
    /// Write the inner faces with their jumps as a mesh of their own, for ParaView
    #[arg(long, value_name = "FILE.vtu")]
    faces_vtu: Option<PathBuf>,
}

/// Simplices of one dimension with their numbers.
struct List<'a> {
    vertices: Vec<&'a [u32]>,
    columns: Vec<(&'static str, Vec<f64>)>,
}

impl SimplexFiles {
    /// Those that were asked for.
    pub fn list(&self) -> Vec<Named<'_>> {
        output::given([
            ("--hinges-csv", &self.hinges_csv),
            ("--faces-csv", &self.faces_csv),
            ("--hinges-vtu", &self.hinges_vtu),
            ("--faces-vtu", &self.faces_vtu),
        ])
    }

    /// Are hinges and faces wanted one by one?
    pub fn want_details(&self) -> bool {
        !self.list().is_empty()
    }

    /// Are places in space wanted?
    pub fn want_fields(&self) -> bool {
        self.hinges_vtu.is_some() || self.faces_vtu.is_some()
    }

    /// Refuses endings that ParaView does not know.
    pub fn check(&self) -> Result<(), Stop> {
        let all = [&self.hinges_vtu, &self.faces_vtu];
        all.into_iter()
            .flatten()
            .try_for_each(|path| check_vtu(path))
    }

    /// Writes them.
    pub fn write(&self, report: &CurvatureReport) -> Result<(), Stop> {
        let files = [
            (
                &self.hinges_csv,
                &self.hinges_vtu,
                hinges as fn(&CurvatureReport) -> List<'_>,
            ),
            (&self.faces_csv, &self.faces_vtu, faces),
        ];
        for (csv, vtu, list) in files {
            if let Some(path) = csv {
                output::write_by(path, |out| table(&list(report), out))?;
            }
            if let (Some(path), Some(fields)) = (vtu, &report.fields) {
                output::write_by(path, |out| vtu::write(&part(&list(report), fields), out))?;
            }
        }
        Ok(())
    }
}

/// Refuses a mesh for ParaView that ParaView would not open.
pub fn check_vtu(path: &Path) -> Result<(), Stop> {
    let known = path
        .extension()
        .is_some_and(|end| end.eq_ignore_ascii_case("vtu"));
    match known || output::is_standard(path) {
        true => Ok(()),
        false => Err(Stop::Usage(format!(
            "{}: a mesh for ParaView ends in .vtu",
            path.display()
        ))),
    }
}

fn hinges(report: &CurvatureReport) -> List<'_> {
    let all = || report.hinges.iter().flatten();
    List {
        vertices: all().map(|hinge| &*hinge.vertices).collect(),
        columns: vec![
            ("defect", all().map(|hinge| hinge.defect).collect()),
            ("volume", all().map(|hinge| hinge.volume).collect()),
        ],
    }
}

fn faces(report: &CurvatureReport) -> List<'_> {
    let all = || report.faces.iter().flatten();
    List {
        vertices: all().map(|face| &*face.vertices).collect(),
        columns: vec![("jump", all().map(|face| face.jump).collect())],
    }
}

/// In a form that reads back to the same bits.
fn table(list: &List<'_>, out: &mut dyn Write) -> io::Result<()> {
    let width = list.vertices.first().map_or(0, |vertices| vertices.len());
    for i in 0..width {
        write!(out, "v{i},")?;
    }
    let names: Vec<&str> = list.columns.iter().map(|column| column.0).collect();
    writeln!(out, "{}", names.join(","))?;
    for (row, vertices) in list.vertices.iter().enumerate() {
        for vertex in *vertices {
            write!(out, "{vertex},")?;
        }
        let numbers = list
            .columns
            .iter()
            .map(|column| format!("{:e}", column.1[row]));
        writeln!(out, "{}", numbers.collect::<Vec<_>>().join(","))?;
    }
    Ok(())
}

/// The simplices as a mesh on the points of the whole.
fn part(list: &List<'_>, whole: &Fields) -> Fields {
    let width = list.vertices.first().map_or(1, |vertices| vertices.len());
    Fields {
        pieces: Vec::new(),
        dimension: width - 1,
        points: whole.points.clone(),
        cells: list.vertices.concat(),
        on_points: Vec::new(),
        on_cells: list.columns.clone(),
        groups: vec![0; list.vertices.len()],
    }
}

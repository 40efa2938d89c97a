//! `regge curvature`: from a mesh file to its curvature.

use super::super::common::Common;
use super::super::picture;
use super::files::{self, Files};
use super::given::{Given, details, stopped};
use super::memory::{self, Listed};
use super::simplices::{SimplexFiles, check_vtu};
use clap::builder::{PossibleValue, PossibleValuesParser};
use regge_cli::curvature::{
    Boundary, CurvatureReport, Fields, LARGEST_WITH_NORM, NormError, Request, curvature,
};
use regge_cli::map::{self, View};
use regge_cli::{ply, vtu};
use regge_curvature::norm::Kind;
use regge_readers::mesh::MeshFile;
use regge_terminal::output::{self, Named};
use regge_terminal::{Out, Stop};
use std::f64::consts::PI;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// About how many phases the command has.
const PHASES: u64 = 9;

const BOUNDARY: &str = "\
The sums are those of the paper: interior faces and hinges only, test functions that vanish on the boundary. With
--boundary gauss-bonnet the boundary's mean curvature and its angles (pi minus their sum) are added, and all test
functions are used: in dimension 2 the total is then 4 pi times the Euler characteristic.";

const SHORT: &str =
    "Example: regge curvature --mesh m.msh --metric g.toml --plot c.svg (more: --help)";

const EXAMPLES: &str = "\
Examples:
  regge curvature --mesh disc.msh --metric sphere.toml --degree 1 --norm hm2 --plot disc.svg
  regge curvature --mesh m.json --lengths l.csv --boundary gauss-bonnet --json -
  regge curvature --mesh ball.msh --metric g.toml --vtu cells.vtu --hinges-vtu edges.vtu --npz all.npz";

/// The distributional curvature of a Regge metric on a mesh from a file.
#[derive(clap::Args)]
#[command(after_help = SHORT, after_long_help = format!("{}\n\n{BOUNDARY}\n\n{EXAMPLES}", details()))]
pub struct Args {
    #[command(flatten)]
    given: Given,
    /// Also pair with all test functions of this degree, onto which the curvature is projected
    #[arg(long, value_name = "Q", value_parser = clap::value_parser!(u64).range(1..=8))]
    test_degree: Option<u64>,
    /// Also the error against the smooth metric in this norm
    #[arg(long, conflicts_with = "lengths", value_parser = norms())]
    norm: Option<String>,
    /// Do not compare exact_scalar_curvature with the metric's own, at the quadrature points
    #[arg(long, requires = "norm")]
    trust_exact_curvature: bool,
    /// What is done on the boundary
    #[arg(long, default_value = "none")]
    boundary: AtBoundary,
    /// Also what is proven: for degree 0 intervals with the angle defects and a surface's Euler characteristic; for higher degrees
    /// that the metric is positive definite everywhere, and bounds of the curvature over whole cells, faces and hinges
    #[arg(long)]
    certified: bool,
    #[command(flatten)]
    files: Files,
    /// Write mesh and fields to this file, for ParaView
    #[arg(long, value_name = "FILE")]
    vtu: Option<PathBuf>,
    #[command(flatten)]
    simplices: SimplexFiles,
    /// Write a surface with K at its vertices to this file, for MeshLab and Blender
    #[arg(long, value_name = "FILE")]
    ply: Option<PathBuf>,
    /// Draw the curvature of a plane mesh or a surface, as .svg, or as .png in a build with --features png
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// From where the picture shows a surface, in degrees, and which axis is up [default: 30,20,z; for .obj 30,20,y]
    #[arg(
        long,
        value_name = "AZIMUTH,ELEVATION[,UP]",
        requires = "plot",
        allow_hyphen_values = true
    )]
    view: Option<String>,
}

/// Norms that can be asked for: those of the library's table, which is the same for every dimension.
fn norms() -> PossibleValuesParser {
    let kinds = Kind::<2>::all().iter();
    kinds
        .map(|kind| PossibleValue::new(kind.name).help(kind.about))
        .into()
}

/// What is done on the boundary.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum AtBoundary {
    /// Nothing: test functions vanish there
    None,
    /// Mean curvature and angles are added
    GaussBonnet,
}

impl Args {
    /// Runs the command.
    pub fn run(self, common: &Common) -> Result<(), Stop> {
        self.check()?;
        let voice = common.voice(&self.outputs());
        let phases = voice.phases(PHASES);
        let begin = |what: &str| phases.begin(what);
        begin("reading the mesh");
        let mesh = self.given.mesh()?;
        self.check_mesh(&mesh)?;
        let listed = match self.test_degree {
            Some(q) if q > 1 => Listed::Lagrange(q as usize),
            _ => Listed::Vertices,
        };
        memory::check(
            common,
            &mesh,
            self.given.degree,
            listed,
            self.request().norm,
        )?;
        let source = self.given.source()?;
        let report = curvature(&mesh, &source, &self.request(), &begin).map_err(stopped)?;
        begin("writing");
        self.write(&report)?;
        drop(phases);
        files::notes(&voice, &report.about);
        self.show(&report, &mut voice.out())
    }

    /// What can be refused before any file is read.
    fn check(&self) -> Result<(), Stop> {
        if let Some(path) = &self.plot {
            picture::check(path)?;
        }
        self.vtu.as_deref().map_or(Ok(()), check_vtu)?;
        self.simplices.check()?;
        self.view()?;
        self.given.check(&self.outputs())
    }

    /// What can be refused as soon as the mesh is known.
    fn check_mesh(&self, mesh: &MeshFile) -> Result<(), Stop> {
        let (n, cells) = (mesh.dimension, mesh.cells.len());
        if let Some(name) = self.norm.as_ref().filter(|_| n > LARGEST_WITH_NORM) {
            let reason =
                format!("--norm {name} is for dimensions 2 to {LARGEST_WITH_NORM}, not {n}");
            return Err(Stop::Usage(reason));
        }
        if self.plot.is_some() && n != 2 {
            let reason = format!(
                "--plot is for dimension 2, not {n}: write --vtu, --faces-vtu, --hinges-vtu and look at them with ParaView"
            );
            return Err(Stop::Usage(reason));
        }
        if self.ply.is_some() && n != 2 {
            let reason = format!("--ply is for surfaces, not for dimension {n}: write --vtu");
            return Err(Stop::Usage(reason));
        }
        if self.plot.is_some() && cells > map::LARGEST {
            let reason = format!(
                "{cells} cells are too many for a picture (the limit is {}): write --vtu and look at it with ParaView",
                map::LARGEST
            );
            return Err(Stop::Usage(reason));
        }
        Ok(())
    }

    /// From where a surface is seen.
    fn view(&self) -> Result<View, Stop> {
        let usual = View::of(&self.given.mesh);
        match &self.view {
            Some(text) => {
                let view = usual.changed(text);
                view.map_err(|reason| Stop::Usage(format!("--view {reason}")))
            }
            None => Ok(usual),
        }
    }

    fn outputs(&self) -> Vec<Named<'_>> {
        let mut all = self.files.list();
        all.extend(self.simplices.list());
        all.extend(output::given([
            ("--vtu", &self.vtu),
            ("--ply", &self.ply),
            ("--plot", &self.plot),
        ]));
        all
    }

    fn request(&self) -> Request {
        Request {
            degree: self.given.degree,
            quadrature: self.given.quadrature(),
            test_degree: self.test_degree.map(|degree| degree as usize),
            norm: self.norm.as_deref().map(|name| {
                let kind = Kind::<2>::named(name);
                kind.expect("the parser knows the table").name
            }),
            trust_stated: self.trust_exact_curvature,
            boundary: match self.boundary {
                AtBoundary::None => Boundary::None,
                AtBoundary::GaussBonnet => Boundary::GaussBonnet,
            },
            details: self.files.want_details() || self.simplices.want_details(),
            fields: self.vtu.is_some()
                || self.ply.is_some()
                || self.plot.is_some()
                || self.simplices.want_fields(),
            table: self.files.csv.is_some(),
            certified: self.certified,
        }
    }

    fn write(&self, report: &CurvatureReport) -> Result<(), Stop> {
        self.files.write(report, table)?;
        self.simplices.write(report)?;
        let Some(fields) = &report.fields else {
            return Ok(());
        };
        if let Some(path) = &self.vtu {
            output::write_by(path, |out| vtu::write(fields, out))?;
        }
        if let Some(path) = &self.ply {
            output::write_by(path, |out| ply::write(fields, out))?;
        }
        match &self.plot {
            Some(path) => draw(path, report, fields, &self.view()?),
            None => Ok(()),
        }
    }

    fn show(&self, report: &CurvatureReport, out: &mut Out) -> Result<(), Stop> {
        let about = &report.about;
        writeln!(
            out,
            "{}: N = {}, {} cells, Euler characteristic {}",
            about.mesh, about.dimension, report.cell_count, report.euler_characteristic
        )?;
        writeln!(
            out,
            "Regge metric: {}, degree {}",
            about.interpolant, about.degree
        )?;
        files::show_quadrature(out, about)?;
        writeln!(out, "boundary terms: {}", report.boundary)?;
        writeln!(out, "total curvature {:.12e}", report.total_curvature)?;
        if let Some(residual) = report.gauss_bonnet_residual {
            let flat = 4.0 * PI * report.euler_characteristic as f64;
            writeln!(out, "4 pi chi        {flat:.12e}")?;
            writeln!(out, "Gauss-Bonnet residual {residual:.3e}")?;
        }
        if let Some(enclosures) = &report.enclosures {
            files::show_certified(out, enclosures)?;
        }
        if let Some(everywhere) = &report.everywhere {
            files::show_everywhere(out, everywhere)?;
        }
        show_pieces(report, out)?;
        for norm in report.norms.values() {
            let unsettled = norm.quadrature.is_unsettled();
            let state = if unsettled { ", NOT settled" } else { "" };
            writeln!(out, "error in {} {:.12e}{state}", norm.symbol, norm.error)?;
            writeln!(out, "  {}", solved(norm))?;
        }
        Ok(output::show_written(out, &self.outputs())?)
    }
}

/// What solved for a norm.
fn solved(norm: &NormError) -> String {
    let how = match (norm.steps, norm.residual) {
        (Some(steps), Some(residual)) => format!(", {steps} steps to {residual:.1e}"),
        _ => String::new(),
    };
    format!("by {}, {} unknowns{how}", norm.solver, norm.unknowns)
}

/// Each piece of a mesh that falls into several.
fn show_pieces(report: &CurvatureReport, out: &mut Out) -> io::Result<()> {
    /// More are in the JSON file.
    const SHOWN: usize = 20;
    let count = report.pieces.len();
    if count < 2 {
        return Ok(());
    }
    writeln!(out, "the mesh falls into {count} pieces:")?;
    for piece in report.pieces.iter().take(SHOWN) {
        writeln!(
            out,
            "  from cell {}: {} cells, Euler characteristic {}, total curvature {:.12e}",
            piece.first_cell, piece.cell_count, piece.euler_characteristic, piece.total_curvature
        )?;
    }
    match count - count.min(SHOWN) {
        0 => Ok(()),
        more => writeln!(out, "  and {more} more, which --json has"),
    }
}

/// The sums at the vertices, in a form that reads back to the same bits.
fn table(report: &CurvatureReport, out: &mut dyn Write) -> io::Result<()> {
    let more = report.boundary != "none";
    let name = if more { ",boundary" } else { "" };
    let surface = match report.about.dimension {
        2 => ",area,K_integral,K",
        _ => "",
    };
    writeln!(out, "vertex,cells,faces,hinges{name},total{surface}")?;
    for v in &report.vertices {
        write!(out, "{},", v.vertex)?;
        files::parts(out, &v.sums)?;
        if let Some(on) = &v.surface {
            write!(out, ",{:e},{:e},", on.area, on.k_integral)?;
            // None on the boundary: an empty field.
            on.k.map_or(Ok(()), |k| write!(out, "{k:e}"))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

fn draw(path: &Path, report: &CurvatureReport, fields: &Fields, view: &View) -> Result<(), Stop> {
    let about = &report.about;
    let title = format!(
        "{}: {} cells, {}, degree {}",
        about.mesh, report.cell_count, about.interpolant, about.degree
    );
    let svg = map::svg(fields, &title, view).map_err(Stop::Input)?;
    picture::write(path, svg)
}

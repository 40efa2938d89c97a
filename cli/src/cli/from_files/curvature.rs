//! `regge curvature`: from a mesh file to its curvature.

use super::files::{self, Files};
use super::given::{DETAILS, Given, stopped};
use clap::builder::{PossibleValue, PossibleValuesParser};
use regge_cli::curvature::{Boundary, CurvatureReport, Fields, Request, curvature};
use regge_cli::{map, vtu};
use regge_curvature::norm::Kind;
use regge_terminal::{Bar, Out, Stop, output};
use std::ffi::OsStr;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// About how many phases the command has.
const PHASES: u64 = 9;

const BOUNDARY: &str = "\
The sums are those of the paper: interior faces and hinges only, test functions that vanish on the boundary. With
--boundary gauss-bonnet the boundary's mean curvature and its angles (pi minus their sum) are added, and all test
functions are used: in dimension 2 the total is then 4 pi times the Euler characteristic.";

/// The distributional curvature of a Regge metric on a mesh from a file.
#[derive(clap::Args)]
#[command(after_help = format!("{DETAILS}\n\n{BOUNDARY}"))]
pub struct Args {
    #[command(flatten)]
    given: Given,
    /// Also pair with all test functions of this degree, onto which the curvature is projected
    #[arg(long, value_name = "Q", value_parser = clap::value_parser!(u64).range(1..=8))]
    test_degree: Option<u64>,
    /// Also the error against the smooth metric in this norm
    #[arg(long, conflicts_with = "lengths", value_parser = norms())]
    norm: Option<String>,
    /// What is done on the boundary
    #[arg(long, default_value = "none")]
    boundary: AtBoundary,
    #[command(flatten)]
    files: Files,
    /// Write mesh and fields to this file, for ParaView
    #[arg(long, value_name = "FILE")]
    vtu: Option<PathBuf>,
    /// Draw the curvature of a plane mesh, as .svg, or as .png in a build with --features png
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// Norms that can be asked for: those of the library's table, which is the same for every dimension.
fn norms() -> PossibleValuesParser {
    let kinds = Kind::<2>::ALL.iter();
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
    pub fn run(self) -> Result<(), Stop> {
        self.check()?;
        let bar = Bar::new(PHASES);
        let begin = |what: &'static str| bar.advance(PHASES, what);
        begin("reading the mesh");
        let mesh = self.given.mesh()?;
        if let Some(name) = self.norm.as_ref().filter(|_| mesh.dimension > 3) {
            let n = mesh.dimension;
            let reason = format!("--norm {name} is for dimensions 2 and 3, not {n}");
            return Err(Stop::Usage(reason));
        }
        if self.plot.is_some() && mesh.dimension != 2 {
            let reason = format!("--plot is for dimension 2, not {}", mesh.dimension);
            return Err(Stop::Usage(reason));
        }
        let source = self.given.source()?;
        let report = curvature(&mesh, &source, &self.request(), &begin).map_err(stopped)?;
        begin("writing");
        self.write(&report)?;
        drop(bar);
        self.show(&report)
    }

    /// What can be refused before any file is read.
    fn check(&self) -> Result<(), Stop> {
        self.given.check()?;
        if let Some(path) = &self.plot {
            Picture::of(path)?;
        }
        files::check(self.paths())
    }

    fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        self.files.list().chain(&self.vtu).chain(&self.plot)
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
            boundary: match self.boundary {
                AtBoundary::None => Boundary::None,
                AtBoundary::GaussBonnet => Boundary::GaussBonnet,
            },
            details: self.files.json.is_some(),
            fields: self.vtu.is_some() || self.plot.is_some(),
        }
    }

    fn write(&self, report: &CurvatureReport) -> Result<(), Stop> {
        self.files.write(report, table)?;
        let Some(fields) = &report.fields else {
            return Ok(());
        };
        if let Some(path) = &self.vtu {
            output::write_by(path, |out| vtu::write(fields, out))?;
        }
        match &self.plot {
            Some(path) => draw(path, report, fields),
            None => Ok(()),
        }
    }

    fn show(&self, report: &CurvatureReport) -> Result<(), Stop> {
        let (mut out, about) = (Out::new(), &report.about);
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
        files::show_quadrature(&mut out, &report.about)?;
        writeln!(out, "boundary terms: {}", report.boundary)?;
        writeln!(out, "total curvature {:.12e}", report.total_curvature)?;
        if let Some(residual) = report.gauss_bonnet_residual {
            writeln!(out, "Gauss-Bonnet residual {residual:.3e}")?;
        }
        for norm in report.norms.values() {
            let unsettled = norm.quadrature.is_unsettled();
            let state = if unsettled { ", NOT settled" } else { "" };
            writeln!(out, "error in {} {:.12e}{state}", norm.symbol, norm.error)?;
        }
        files::show_written(&mut out, self.paths())
    }
}

/// The sums at the vertices, in a form that reads back to the same bits.
fn table(report: &CurvatureReport, out: &mut dyn Write) -> io::Result<()> {
    let more = report.boundary != "none";
    let name = if more { ",boundary" } else { "" };
    writeln!(out, "vertex,cells,faces,hinges{name},total")?;
    for v in &report.vertices {
        write!(out, "{},", v.vertex)?;
        files::parts(out, &v.sums)?;
    }
    Ok(())
}

/// How a picture is written.
enum Picture {
    Svg,
    #[cfg(feature = "png")]
    Png,
}

impl Picture {
    fn of(path: &Path) -> Result<Self, Stop> {
        let end = path.extension().map(OsStr::to_ascii_lowercase);
        match end.as_deref().and_then(OsStr::to_str) {
            Some("svg") => Ok(Self::Svg),
            #[cfg(feature = "png")]
            Some("png") => Ok(Self::Png),
            #[cfg(not(feature = "png"))]
            Some("png") => Err(Stop::Input(format!(
                "{}: this build draws .svg only; cargo build --release -p regge-cli --features png draws .png too",
                path.display()
            ))),
            _ => Err(Stop::Usage(format!(
                "{}: a picture ends in .svg or .png",
                path.display()
            ))),
        }
    }
}

fn draw(path: &Path, report: &CurvatureReport, fields: &Fields) -> Result<(), Stop> {
    let about = &report.about;
    let title = format!(
        "{}: {} cells, {}, degree {}",
        about.mesh, report.cell_count, about.interpolant, about.degree
    );
    let svg = map::svg(fields, &title).map_err(Stop::Input)?;
    let bytes = match Picture::of(path)? {
        Picture::Svg => svg.into_bytes(),
        #[cfg(feature = "png")]
        Picture::Png => map::png(&svg).map_err(Stop::Failed)?,
    };
    output::write_by(path, |out| out.write_all(&bytes))
}

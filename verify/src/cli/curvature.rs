//! `regge curvature`: from a mesh file to its curvature.

use super::output;
use super::stop::{Out, Stop};
use super::values::named;
use regge_study::{Interpolation, LARGEST_DEGREE};
use regge_verify::curvature::{CurvatureError, CurvatureReport, Request, Source, curvature};
use regge_verify::input::InputError;
use regge_verify::input::mesh::read_mesh;
use regge_verify::input::metric::read_metric;
use std::fmt::Write as _;
use std::io::Write;
use std::path::PathBuf;

const DETAILS: &str = "\
Mesh: Gmsh 2.2 or 4.1 (text or binary; triangles or tetrahedra), or JSON:
  {\"dimension\": 2, \"vertices\": [[0, 0], ...], \"cells\": [[0, 1, 2], ...]}
  without \"vertices\" it is an abstract manifold, which edge lengths suffice for.

Metric, a TOML file with the dimension and one of
  g = [[\"1 + x^2\", \"x*y\"], [\"x*y\", \"1 + y^2\"]]
  graph = \"x^2/2 - x^4/12\"          the metric of the graph of f
  conformal = \"4/(1 + x^2 + y^2)^2\" the Euclidean one times this factor
  embedding = [\"x\", \"y\", \"x*y\"]     the metric induced by this map
in x, y, z or x1, x2, ...; exact_scalar_curvature = \"...\" may be added.

Edge lengths: a CSV file with i,j,length for every edge, vertices counted from 0.

The sums are those of the paper: interior faces and hinges only, no boundary terms.";

/// The distributional curvature of a Regge metric on a mesh from a file.
#[derive(clap::Args)]
#[command(after_help = DETAILS)]
#[command(group(clap::ArgGroup::new("source").required(true).args(["metric", "lengths"])))]
pub struct Args {
    /// The mesh: Gmsh or JSON
    #[arg(long, value_name = "FILE")]
    mesh: PathBuf,
    /// The smooth metric, by formulas
    #[arg(long, value_name = "FILE.toml")]
    metric: Option<PathBuf>,
    /// The edge lengths: classical Regge calculus
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["degree", "interpolant", "norm"])]
    lengths: Option<PathBuf>,
    /// Degree r of the Regge metric
    #[arg(long, value_name = "R", default_value_t = 0)]
    degree: usize,
    /// How the Regge metric is made from the smooth one
    #[arg(long, default_value = "canonical", value_parser = named::<Interpolation>())]
    interpolant: Interpolation,
    /// Order of quadrature [default: raised until the sums settle to 1e-8 of the largest]
    #[arg(long, value_name = "ORDER", value_parser = clap::value_parser!(u64).range(0..=60))]
    quadrature: Option<u64>,
    /// Also pair with all test functions of this degree
    #[arg(long, value_name = "Q", value_parser = clap::value_parser!(u64).range(1..=8))]
    test_degree: Option<u64>,
    /// Also the error against the smooth metric in this norm
    #[arg(long)]
    norm: Option<Norm>,
    /// Write everything to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write the sums at the vertices to this file
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

/// Norms that can be asked for.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Norm {
    /// H^-2 by Hellan, Herrmann and Johnson, N = 2 and 3
    Hm2,
}

impl Args {
    /// Runs the command.
    pub fn run(self) -> Result<(), Stop> {
        self.check()?;
        let mesh = read_mesh(&self.mesh).map_err(refused)?;
        if self.norm.is_some() && mesh.dimension > 3 {
            let reason = format!(
                "--norm hm2 is for dimensions 2 and 3, not {}",
                mesh.dimension
            );
            return Err(Stop::Usage(reason));
        }
        let report = curvature(&mesh, &self.source()?, &self.request());
        let report = report.map_err(|error| match error {
            CurvatureError::Input(reason) => Stop::Input(reason),
            CurvatureError::Failed(reason) => Stop::Failed(reason),
        })?;
        self.write(&report)?;
        self.show(&report)
    }

    /// What can be refused before any file is read.
    fn check(&self) -> Result<(), Stop> {
        let refuse = |reason: String| Err(Stop::Usage(reason));
        if self.degree > LARGEST_DEGREE {
            return refuse(format!(
                "degree {} is too high: {LARGEST_DEGREE} is the highest",
                self.degree
            ));
        }
        if self.degree > 0 && self.interpolant == Interpolation::Geodesic {
            return refuse(format!(
                "the geodesic interpolant has degree 0, not {}",
                self.degree
            ));
        }
        if self.json.is_some() && self.json == self.csv {
            return refuse("the JSON and the CSV go to one file".into());
        }
        self.files().try_for_each(|path| output::check(path))
    }

    fn files(&self) -> impl Iterator<Item = &PathBuf> {
        self.json.iter().chain(&self.csv)
    }

    fn source(&self) -> Result<Source, Stop> {
        match (&self.metric, &self.lengths) {
            (Some(metric), _) => {
                let metric = read_metric(metric).map_err(refused)?;
                Ok(Source::Metric(Box::new(metric), self.interpolant))
            }
            (None, Some(lengths)) => Ok(Source::Lengths(lengths.clone())),
            (None, None) => Err(Stop::Usage("--metric or --lengths is needed".into())),
        }
    }

    fn request(&self) -> Request {
        Request {
            degree: self.degree,
            quadrature: self.quadrature.map(|order| order as usize),
            test_degree: self.test_degree.map(|degree| degree as usize),
            norm: self.norm.is_some(),
        }
    }

    fn write(&self, report: &CurvatureReport) -> Result<(), Stop> {
        if let Some(path) = &self.json {
            let json = serde_json::to_string_pretty(report);
            let json = json.map_err(|error| Stop::Failed(error.to_string()))?;
            output::write(path, &(json + "\n"))?;
        }
        if let Some(path) = &self.csv {
            output::write(path, &table(report))?;
        }
        Ok(())
    }

    fn show(&self, report: &CurvatureReport) -> Result<(), Stop> {
        let mut out = Out::new();
        writeln!(
            out,
            "{}: N = {}, {} cells, Euler characteristic {}",
            report.mesh, report.dimension, report.cell_count, report.euler_characteristic
        )?;
        let quadrature = &report.quadrature;
        writeln!(
            out,
            "Regge metric: {}, degree {}",
            report.interpolant, report.degree
        )?;
        let unsettled = quadrature.settled == Some(false);
        let state = if unsettled {
            ", the sums have NOT settled"
        } else {
            ""
        };
        writeln!(out, "quadrature of order {}{state}", quadrature.order)?;
        writeln!(out, "total curvature {:.12e}", report.total_curvature)?;
        if let Some(residual) = report.gauss_bonnet_residual {
            writeln!(out, "Gauss-Bonnet residual {residual:.3e}")?;
        }
        if let Some(norm) = &report.hm2 {
            let unsettled = norm.quadrature.settled == Some(false);
            let state = if unsettled { ", NOT settled" } else { "" };
            writeln!(out, "error in H^-2 {:.12e}{state}", norm.error)?;
        }
        for path in self.files() {
            writeln!(out, "written: {}", path.display())?;
        }
        Ok(())
    }
}

fn refused(error: InputError) -> Stop {
    Stop::Input(error.to_string())
}

/// The sums at the vertices, in a form that reads back to the same bits.
fn table(report: &CurvatureReport) -> String {
    let mut text = String::from("vertex,element,face,hinge,total\n");
    for v in &report.vertices {
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{},{:e},{:e},{:e},{:e}",
            v.vertex, v.element, v.face, v.hinge, v.total
        );
    }
    text
}

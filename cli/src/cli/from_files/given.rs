//! The arguments that say which Regge metric: shared by the commands for meshes from files.

use super::super::values;
use regge_cli::curvature::{CurvatureError, LARGEST_DIMENSION, Source};
use regge_curvature::interpolate::Interpolant;
use regge_readers::InputError;
use regge_readers::expression::functions;
use regge_readers::mesh::{MeshFile, read_mesh};
use regge_readers::metric::read_metric;
use regge_study::LARGEST_DEGREE;
use regge_terminal::Stop;
use regge_terminal::output::{self, Named};
use std::path::PathBuf;

const MESH: &str = "\
Mesh: Gmsh 2.2 or 4.1 (text or binary, curved cells up to order 4), OBJ, PLY, STL, OFF, VTK, VTU, VTP, MEDIT (.mesh),
with triangles or tetrahedra; or JSON:
  {\"dimension\": 2, \"vertices\": [[0, 0], ...], \"cells\": [[0, 1, 2], ...]}
  without \"vertices\" it is an abstract manifold, which edge lengths suffice for.

Without a metric and without lengths it is that of the points: what a surface or solid has in space.

Metric, a TOML file with the dimension and one of
  g = [[\"1 + x^2\", \"x*y\"], [\"x*y\", \"1 + y^2\"]]
  graph = \"x^2/2 - x^4/12\"          the metric of the graph of f
  conformal = \"4/(1 + x^2 + y^2)^2\" the Euclidean one times this factor
  embedding = [\"x\", \"y\", \"x*y\"]     the metric induced by this map
in x, y, z or x1, x2, ...; exact_scalar_curvature = \"...\" may be added. On a surface in space it may be in x, y, z
(dimension = 3): the surface inherits what the formula is in space.";

const LENGTHS: &str = "\
Edge lengths: a CSV file with i,j,length for every edge, vertices counted from 0.";

/// What is said of these arguments at the end of the long help.
pub fn details() -> String {
    format!(
        "{MESH}\nFormulas: + - * / ^, pi, e, and\n{}\nabs, sign, min and max have kinks: there one side is differentiated, and a note says so.\n\n\
         {LENGTHS}\n\nThis build takes dimensions 2 to {LARGEST_DIMENSION} and degrees up to {LARGEST_DEGREE}. \
         The forms of all files are in docs/formats.md.",
        lines(&functions(), 110)
    )
}

/// Words in lines of this width at most, a little indented.
fn lines(words: &[String], width: usize) -> String {
    let mut text = String::new();
    let mut column = width;
    for word in words {
        if column + word.len() + 2 > width {
            text += if text.is_empty() { "  " } else { ",\n  " };
            column = 2;
        } else {
            text += ", ";
            column += 2;
        }
        text += word;
        column += word.len();
    }
    text
}

/// Which Regge metric.
#[derive(clap::Args)]
#[command(group(clap::ArgGroup::new("source").args(["metric", "lengths"])))]
pub struct Given {
    /// The mesh: Gmsh, OBJ, PLY, STL, OFF, VTK, MEDIT or JSON
    #[arg(long, value_name = "FILE")]
    pub mesh: PathBuf,
    /// The smooth metric, by formulas [default: that of the mesh's points]
    #[arg(long, value_name = "FILE.toml")]
    metric: Option<PathBuf>,
    /// The edge lengths: classical Regge calculus
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["degree", "interpolant"])]
    lengths: Option<PathBuf>,
    /// Degree r of the Regge metric, up to 8
    #[arg(long, value_name = "R", default_value_t = 0, requires = "metric")]
    pub degree: usize,
    /// How the Regge metric is made from the smooth one
    #[arg(long, default_value = values::DEFAULT_INTERPOLANT, value_parser = values::named::<Interpolant>(), requires = "metric")]
    interpolant: Interpolant,
    /// Order of quadrature [default: raised until the sums settle to 1e-8 of the largest]
    #[arg(long, value_name = "ORDER", value_parser = clap::value_parser!(u64).range(0..=60))]
    quadrature: Option<u64>,
}

impl Given {
    /// What can be refused before any file is read, the files among it that are to be written.
    pub fn check(&self, outputs: &[Named<'_>]) -> Result<(), Stop> {
        output::check_all(&self.inputs(), outputs)?;
        if self.degree > LARGEST_DEGREE {
            return Err(Stop::Usage(format!(
                "degree {} is too high: {LARGEST_DEGREE} is the highest",
                self.degree
            )));
        }
        let checked = self.interpolant.check_degree(self.degree);
        checked.map_err(|error| Stop::Usage(error.to_string()))
    }

    /// The files that are read.
    fn inputs(&self) -> Vec<Named<'_>> {
        let mut all = vec![("--mesh", &*self.mesh)];
        all.extend(output::given([
            ("--metric", &self.metric),
            ("--lengths", &self.lengths),
        ]));
        all
    }

    /// The order of quadrature, if it is given.
    pub fn quadrature(&self) -> Option<usize> {
        self.quadrature.map(|order| order as usize)
    }

    /// Reads the mesh.
    pub fn mesh(&self) -> Result<MeshFile, Stop> {
        read_mesh(&self.mesh).map_err(refused)
    }

    /// Reads the metric, or tells where the lengths are.
    pub fn source(&self) -> Result<Source, Stop> {
        match (&self.metric, &self.lengths) {
            (Some(metric), _) => {
                let metric = read_metric(metric).map_err(refused)?;
                Ok(Source::Metric(Box::new(metric), self.interpolant))
            }
            (None, Some(lengths)) => Ok(Source::Lengths(lengths.clone())),
            (None, None) => Ok(Source::Points),
        }
    }
}

fn refused(error: InputError) -> Stop {
    Stop::Input(error.to_string())
}

/// Why a computation stopped.
pub fn stopped(error: CurvatureError) -> Stop {
    match error {
        CurvatureError::Input(reason) => Stop::Input(reason),
        CurvatureError::Failed(reason) => Stop::Failed(reason),
    }
}

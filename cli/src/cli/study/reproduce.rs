//! `regge reproduce`: the paper's tables and figures.

use super::super::common::Common;
use super::super::values::{Levels, named, unique};
use super::{Job, journal};
use clap::ValueEnum;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Metric;
use regge_study::{Case, LoadQuadrature, ProjectionKind, Quadrature, Quantity, Study};
use regge_terminal::{Stop, output};
use std::path::{Path, PathBuf};

/// Where the files of `reproduce` go unless told otherwise.
const FOLDER: &str = "results";

const DETAILS: &str = "\
What is computed: g is the metric of the graph of sum(x^2/2 - x^4/12) on (-1, 1)^N, on a cube with
2^k cells a side cut into simplices, inner vertices moved at random as in the paper; g_h is its
Regge interpolant of degree r; 'error' is the H^-2 norm of (R omega)_dist(g_h) - (R omega)(g), for
figure2 that of the paper's critical term. 'ratio' is our error over the printed one.

By default the quadrature is converged, which that of the paper was not: the columns r = 1, 2 then
differ from the printed ones by a factor that the program explains. With --as-printed they agree up
to the random meshes.

Examples:
  regge reproduce table1
  regge reproduce table1 --as-printed --seed 7 --json printed.json --plot printed.svg
  regge reproduce table1 --levels 0..=4 --degrees 1 --interpolant average
  regge reproduce figure2 --levels 1..=2 --degrees 2";

const SHORT: &str = "Example: regge reproduce table1 (more: --help)";

/// Recompute a table or figure of the paper and show each error beside the printed one.
#[derive(clap::Args)]
#[command(after_help = SHORT, after_long_help = DETAILS)]
pub struct Args {
    /// Which one
    target: Target,
    /// Levels k: 0..=7, 0..8 or 3 [default: the paper's: table1 0..=7, table2 and figure2 0..=6, 0..=5 for figure2 with r = 2]
    #[arg(long, value_name = "A..=B")]
    levels: Option<Levels>,
    /// Degrees r of the Regge metric
    #[arg(
        long,
        value_name = "R,...",
        value_delimiter = ',',
        default_value = "0,1,2"
    )]
    degrees: Vec<usize>,
    /// How g_h is made [default: average-hierarchical, which the printed tables used; for figure2 also canonical]
    #[arg(long, value_name = "NAME,...", value_delimiter = ',', value_parser = named::<Interpolant>())]
    interpolant: Vec<Interpolant>,
    /// The local L2 projection inside the averages [default: exact; with --as-printed: discrete]
    #[arg(long, value_parser = named::<ProjectionKind>(), conflicts_with = "as_printed")]
    projection: Option<ProjectionKind>,
    /// Where the random meshes come from: each level has its own seed, made from this one
    #[arg(long, default_value_t = DEFAULT_SEED, allow_negative_numbers = true)]
    seed: u64,
    /// Integrate as the paper's program did: projection of exactness 2r, functional 2(r+2), norm 5
    #[arg(long, conflicts_with = "quadrature")]
    as_printed: bool,
    #[command(flatten)]
    orders: Orders,
    /// Where the JSON goes [default: results/TARGET.json]
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Where the picture goes [default: results/TARGET.svg]
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    journal: journal::Args,
}

/// The seed that is used unless told otherwise. It was selected, not drawn: docs/design.md says among which and why. All
/// numbers in this project's documents are of it.
pub const DEFAULT_SEED: u64 = 3;

/// Orders of quadrature.
#[derive(clap::Args)]
pub struct Orders {
    /// Order of the rules of the functionals [default: high enough that raising it changes errors by less than 0.1 %]
    #[arg(long, value_name = "ORDER", value_parser = clap::value_parser!(u64).range(0..=60))]
    quadrature: Option<u64>,
    /// Order of the rule of the norm [default: the paper's 5 where that changes errors by less than 0.1 %, else exact]
    #[arg(long, value_name = "ORDER", value_parser = clap::value_parser!(u64).range(0..=60))]
    norm_quadrature: Option<u64>,
}

impl Orders {
    /// What was asked for.
    pub fn quadrature(&self, as_printed: bool) -> Quadrature {
        let load = match self.quadrature {
            _ if as_printed => LoadQuadrature::AsPrinted,
            Some(order) => LoadQuadrature::Order(order as usize),
            None => LoadQuadrature::Converged,
        };
        Quadrature {
            load,
            norm: self.norm_quadrature.map(|order| order as usize),
        }
    }
}

/// What can be reproduced.
#[derive(Clone, Copy, ValueEnum)]
enum Target {
    /// Table 1 (tab:error_N2): the curvature's error for N = 2
    Table1,
    /// Table 2 (tab:error_N3): the curvature's error for N = 3
    Table2,
    /// Figure 2 (fig:conv_plot_crit_term): the critical term for N = 3
    Figure2,
}

impl Target {
    fn name(self) -> &'static str {
        match self {
            Self::Table1 => "table1",
            Self::Table2 => "table2",
            Self::Figure2 => "figure2",
        }
    }

    fn title(self) -> &'static str {
        match self {
            Self::Table1 => "Table 1: error of the distributional curvature in H⁻², N = 2",
            Self::Table2 => "Table 2: error of the distributional curvature in H⁻², N = 3",
            Self::Figure2 => "Figure 2: the critical term in H⁻², N = 3",
        }
    }

    /// Those of the paper, which stops a level earlier with its dearest curves.
    fn default_levels(self, degree: usize) -> std::ops::RangeInclusive<u32> {
        match (self, degree) {
            (Self::Table1, _) => 0..=7,
            (Self::Figure2, 2..) => 0..=5,
            (Self::Table2 | Self::Figure2, _) => 0..=6,
        }
    }

    fn default_interpolants(self) -> Vec<Interpolant> {
        match self {
            Self::Figure2 => vec![
                Interpolant::average_hierarchical(),
                Interpolant::canonical(),
            ],
            Self::Table1 | Self::Table2 => vec![Interpolant::average_hierarchical()],
        }
    }
}

impl Args {
    /// Runs the command.
    pub fn run(self, common: &Common) -> Result<(), Stop> {
        let study = self.study();
        // What cannot be computed must not leave a folder behind.
        study
            .check()
            .map_err(|error| Stop::Usage(error.to_string()))?;
        let given = [
            ("--json", &self.json),
            ("--plot", &self.plot),
            ("--rows", self.journal.file()),
        ];
        output::check_all(&[], &output::given(given))?;
        let file = |given: &Option<PathBuf>, extension: &str| match given {
            Some(path) => Ok(path.clone()),
            None => default_file(self.target, extension),
        };
        let job = Job {
            title: format!(
                "{}, {} quadrature, seed {}",
                self.target.title(),
                study.quadrature.words(),
                self.seed
            ),
            json: Some(file(&self.json, "json")?),
            plot: Some(file(&self.plot, "svg")?),
            study,
            journal: self.journal,
        };
        job.run(common)
    }

    fn study(&self) -> Study {
        let (dimension, quantity) = match self.target {
            Target::Table1 => (2, Quantity::CurvatureError),
            Target::Table2 => (3, Quantity::CurvatureError),
            Target::Figure2 => (3, Quantity::CriticalTerm),
        };
        let projection = match self.as_printed {
            true => ProjectionKind::Discrete,
            false => self.projection.unwrap_or(ProjectionKind::Exact),
        };
        Study {
            metric: Metric::GraphQuartic,
            dimension,
            quantity,
            interpolants: match self.interpolant.is_empty() {
                true => self.target.default_interpolants(),
                false => unique(&self.interpolant, Interpolant::is),
            },
            projection,
            quadrature: self.orders.quadrature(self.as_printed),
            seed: self.seed,
            cases: self.cases(),
        }
    }

    fn cases(&self) -> Vec<Case> {
        let levels = |degree| match &self.levels {
            Some(levels) => levels.0.clone(),
            None => self.target.default_levels(degree).collect(),
        };
        let of_degree = |&degree: &usize| {
            let case = move |level| Case { degree, level };
            levels(degree).into_iter().map(case)
        };
        unique(&self.degrees, usize::eq)
            .iter()
            .flat_map(of_degree)
            .collect()
    }
}

/// A file in a folder that is made if it is not there.
fn default_file(target: Target, extension: &str) -> Result<PathBuf, Stop> {
    let failed = |error| Stop::Failed(format!("{FOLDER}: {error}"));
    std::fs::create_dir_all(FOLDER).map_err(failed)?;
    Ok(Path::new(FOLDER).join(format!("{}.{extension}", target.name())))
}

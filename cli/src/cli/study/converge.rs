//! `regge converge`: a convergence study of any built-in metric.

use super::super::common::Common;
use super::super::values::{DEFAULT_INTERPOLANT, Levels, named, unique};
use super::reproduce::{DEFAULT_SEED, Orders};
use super::{Job, journal};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Metric;
use regge_study::{Case, Named, ProjectionKind, Quantity, Study};
use regge_terminal::Stop;
use std::path::PathBuf;

const DETAILS: &str = "\
Metrics on the cube (-1, 1)^N:
  flat              the Euclidean one
  graph-quartic     of the graph of sum(x^2/2 - x^4/12), the paper's
  conformal-sphere  4/(1+|x|^2)^2, the unit sphere
  hyperbolic        4/(1-|x|^2/(4N))^2, the ball of hyperbolic space
  trig              a generic one, sines in every component

Quantities, all measured in H^-2, with g(t) = (1-t) g + t g_h and sigma = g_h - g:
  curvature-error   (R omega)_dist(g_h) - (R omega)(g)
  critical-term     the hinges' part of it that limits the rate (paper: eq. critical_term)
  b-term, a-term    the integrals of b_h and a_h over t, of which the error is the difference
  einstein-term, second-form-term   the cells' and the faces' part of a-term

Examples:
  regge converge --metric trig --dimension 2 --degree 1
  regge converge --metric conformal-sphere --degree 0,1 --interpolant canonical,average --levels 1..=4
  regge converge --metric hyperbolic --quantity critical-term --dimension 3 --json h.json --plot h.svg";

const SHORT: &str =
    "Example: regge converge --metric trig --degree 1 --plot trig.svg (more: --help)";

/// A convergence study of a built-in metric on ever finer meshes.
#[derive(clap::Args)]
#[command(after_help = SHORT, after_long_help = DETAILS)]
pub struct Args {
    /// The smooth metric g
    #[arg(long, value_parser = named::<Metric>())]
    metric: Metric,
    /// N: 2 or 3
    #[arg(long, value_name = "N", default_value_t = 2)]
    dimension: usize,
    /// Degrees r of the Regge metric
    #[arg(
        long,
        visible_alias = "degrees",
        value_name = "R,...",
        value_delimiter = ',',
        default_value = "0"
    )]
    degree: Vec<usize>,
    /// How g_h is made
    #[arg(
        long,
        value_name = "NAME,...",
        value_delimiter = ',',
        default_value = DEFAULT_INTERPOLANT,
        value_parser = named::<Interpolant>()
    )]
    interpolant: Vec<Interpolant>,
    /// What is measured
    #[arg(long, default_value = "curvature-error", value_parser = named::<Quantity>())]
    quantity: Quantity,
    /// Levels k: 0..=4, 0..5 or 3; the mesh has 2^k cells a side [default: 0..=5, for N = 3 0..=3]
    #[arg(long, value_name = "A..=B")]
    levels: Option<Levels>,
    /// The local L2 projection inside the averages
    #[arg(long, default_value = "exact", value_parser = named::<ProjectionKind>())]
    projection: ProjectionKind,
    /// Where the random meshes come from: each level has its own seed, made from this one
    #[arg(long, default_value_t = DEFAULT_SEED, allow_negative_numbers = true)]
    seed: u64,
    #[command(flatten)]
    orders: Orders,
    /// Write the rows to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Draw the errors to this file
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    journal: journal::Args,
}

impl Args {
    /// Runs the command.
    pub fn run(self, common: &Common) -> Result<(), Stop> {
        let study = self.study();
        let title = format!(
            "{} of {} in H⁻², N = {}, {} quadrature, seed {}",
            study.quantity.name_of(),
            study.metric.name_of(),
            study.dimension,
            study.quadrature.words(),
            study.seed
        );
        let job = Job {
            title,
            json: self.json,
            plot: self.plot,
            study,
            journal: self.journal,
        };
        job.run(common)
    }

    fn study(&self) -> Study {
        let levels = match &self.levels {
            Some(levels) => levels.0.clone(),
            None if self.dimension == 2 => (0..=5).collect(),
            None => (0..=3).collect(),
        };
        let of_degree = |&degree: &usize| {
            let case = move |&level: &u32| Case { degree, level };
            levels.iter().map(case)
        };
        Study {
            metric: self.metric,
            dimension: self.dimension,
            quantity: self.quantity,
            interpolants: unique(&self.interpolant, Interpolant::is),
            projection: self.projection,
            quadrature: self.orders.quadrature(false),
            seed: self.seed,
            cases: unique(&self.degree, usize::eq)
                .iter()
                .flat_map(of_degree)
                .collect(),
        }
    }
}

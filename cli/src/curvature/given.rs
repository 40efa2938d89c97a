//! A Regge metric on the mesh of a file, of whatever dimension, and what is to be done with it.

use super::{CurvatureError, failed, input, smooth};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Smooth;
use regge_curvature::quadrature::Rule;
use regge_curvature::spaces::{ReggeFunction, ReggeSpace};
use regge_readers::expression::Expression;
use regge_readers::mesh::MeshFile;
use regge_readers::metric::{FormulaMetric, MetricFile};
use regge_readers::read_lengths;
use std::path::PathBuf;

/// Where the Regge metric comes from.
#[derive(Clone, Debug)]
pub enum Source {
    /// A smooth metric, to be interpolated.
    Metric(Box<MetricFile>, Interpolant),
    /// A table of edge lengths.
    Lengths(PathBuf),
}

/// Is told what begins.
pub type Phase<'a> = &'a dyn Fn(&'static str);

/// The smooth metric that was interpolated, with its R if that is stated.
pub type Origin<'a, const N: usize> = (&'a Smooth<FormulaMetric<'a>, N>, Option<&'a Expression>);

/// A Regge metric on the mesh of a file.
#[derive(Clone, Copy)]
pub struct Given<'a, const N: usize> {
    /// The file.
    pub file: &'a MeshFile,
    /// The metric.
    pub g_h: &'a ReggeFunction<f64, N>,
    /// How it was made.
    pub interpolant: &'static str,
    /// From what.
    pub origin: Option<Origin<'a, N>>,
}

/// What can be done with a Regge metric of any dimension.
pub trait Task {
    /// The result.
    type Output;

    /// Does it.
    fn run<const N: usize>(&self, given: &Given<'_, N>) -> Result<Self::Output, CurvatureError>;
}

/// Makes the Regge metric and hands it over.
pub fn on_metric<K: Task>(
    mesh: &MeshFile,
    source: &Source,
    degree: usize,
    phase: Phase<'_>,
    task: &K,
) -> Result<K::Output, CurvatureError> {
    if let Source::Metric(metric, _) = source
        && metric.dimension != mesh.dimension
    {
        return Err(CurvatureError::Input(format!(
            "the metric has dimension {}, the mesh {} has {}",
            metric.dimension,
            mesh.file.display(),
            mesh.dimension
        )));
    }
    match mesh.dimension {
        2 => in_dimension::<2, K>(mesh, source, degree, phase, task),
        3 => in_dimension::<3, K>(mesh, source, degree, phase, task),
        4 => in_dimension::<4, K>(mesh, source, degree, phase, task),
        n => Err(CurvatureError::Input(format!(
            "{}: dimension {n}; the program is built for 2, 3 and 4",
            mesh.file.display()
        ))),
    }
}

fn in_dimension<const N: usize, K: Task>(
    file: &MeshFile,
    source: &Source,
    degree: usize,
    phase: Phase<'_>,
    task: &K,
) -> Result<K::Output, CurvatureError> {
    phase("building the mesh");
    match source {
        Source::Metric(metric, interpolant) => {
            by_metric::<N, K>(file, metric, *interpolant, degree, phase, task)
        }
        Source::Lengths(lengths) => {
            let mesh = file.abstract_mesh::<N>()?;
            let space = ReggeSpace::new(&mesh, 0);
            phase("reading the edge lengths");
            let squares = read_lengths(lengths, &mesh)?;
            let g_h = space.function(squares).map_err(failed)?;
            task.run(&Given {
                file,
                g_h: &g_h,
                interpolant: "lengths",
                origin: None,
            })
        }
    }
}

fn by_metric<const N: usize, K: Task>(
    file: &MeshFile,
    metric: &MetricFile,
    interpolant: Interpolant,
    degree: usize,
    phase: Phase<'_>,
    task: &K,
) -> Result<K::Output, CurvatureError> {
    let mesh = file.mesh::<N>()?;
    let g = Smooth::new(&mesh, metric.metric()).map_err(input)?;
    phase("interpolating the metric");
    let space = ReggeSpace::new(&mesh, degree);
    let g_h = interpolant.apply(&space, &g);
    // The interpolant refuses what is not positive definite where it looks; the formula may be to blame for it.
    let g_h = g_h.map_err(|error| match blame(&g, degree) {
        Err(formula) => input(formula),
        Ok(()) => failed(error),
    })?;
    task.run(&Given {
        file,
        g_h: &g_h,
        interpolant: interpolant.name(),
        origin: Some((&g, metric.exact_scalar_curvature.as_ref())),
    })
}

/// Is the formula itself no metric somewhere that the interpolant looks at it?
fn blame<const N: usize>(
    g: &Smooth<FormulaMetric<'_>, N>,
    degree: usize,
) -> Result<(), regge_curvature::Error> {
    smooth::check_values(g, &Rule::new(N, 2 * degree + 2))?;
    smooth::check_edges(g, degree)?;
    // The rule of the local projections.
    smooth::check_values(g, &Rule::new(N, Interpolant::default_order(degree)))
}

//! A Regge metric on the mesh of a file, of whatever dimension, and what is to be done with it.

use super::surface::{Dimension, InSpace, is_in_space};
use super::{CurvatureError, failed, input, smooth, topology};
use regge_curvature::Error;
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::Smooth;
use regge_curvature::quadrature::Rule;
use regge_curvature::spaces::{Immersion, ReggeFunction, ReggeSpace};
use regge_readers::expression::Expression;
use regge_readers::mesh::MeshFile;
use regge_readers::metric::{FormulaMetric, MetricFile};
use regge_readers::read_lengths;
use std::path::{Path, PathBuf};

/// Where the Regge metric comes from.
#[derive(Clone, Debug)]
pub enum Source {
    /// A smooth metric, to be interpolated.
    Metric(Box<MetricFile>, Interpolant),
    /// A table of edge lengths.
    Lengths(PathBuf),
    /// The points of the mesh: the metric that a surface or solid has in space.
    Points,
}

/// Is told what begins.
pub type Phase<'a> = &'a dyn Fn(&str);

/// The smooth metric that was interpolated.
pub struct Origin<'a, const N: usize> {
    /// The metric.
    pub metric: Smooth<FormulaMetric<'a>, N>,
    /// Its R, where it is stated.
    pub scalar_curvature: Option<&'a Expression>,
}

/// A Regge metric on the mesh of a file.
pub struct Given<'a, const N: usize> {
    /// The file.
    pub file: &'a MeshFile,
    /// The metric.
    pub g_h: ReggeFunction<f64, N>,
    /// How it was made.
    pub interpolant: &'static str,
    /// From what.
    pub origin: Option<Origin<'a, N>>,
    /// What is to be known beside the numbers, a line each.
    pub notes: Vec<String>,
    /// The surface or solid that has it, where it is that of the mesh's points.
    pub points: Option<Immersion<N>>,
}

/// Does a thing in the dimension of a mesh file: `by_dimension!(file, N => expression)`, where N is a constant in the expression.
macro_rules! by_dimension {
    ($file:expr, $n:ident => $do:expr) => {
        match $file.dimension {
            2 => {
                const $n: usize = 2;
                $do
            }
            3 => {
                const $n: usize = 3;
                $do
            }
            4 => {
                const $n: usize = 4;
                $do
            }
            5 => {
                const $n: usize = 5;
                $do
            }
            n => Err($crate::curvature::CurvatureError::Input(format!(
                "{}: dimension {n}; the program is built for 2 to {}",
                $file.file.display(),
                $crate::curvature::LARGEST_DIMENSION
            ))),
        }
    };
}
pub(super) use by_dimension;

impl<'a, const N: usize> Given<'a, N>
where
    Dimension<N>: InSpace<N>,
{
    /// Reads the lengths or interpolates the metric, in degree r.
    ///
    /// # Errors
    /// Whether the input is to blame or the computation, and what is wrong where.
    pub fn new(
        file: &'a MeshFile,
        source: &'a Source,
        degree: usize,
        phase: Phase<'_>,
    ) -> Result<Self, CurvatureError> {
        match source {
            Source::Metric(metric, interpolant) if is_in_space(file, metric) => {
                Self::in_space(file, metric, *interpolant, degree, phase)
            }
            Source::Metric(metric, _) if metric.dimension != N => {
                Err(CurvatureError::Input(format!(
                    "the metric has dimension {}, the mesh {} has {N}",
                    metric.dimension,
                    file.file.display(),
                )))
            }
            Source::Metric(metric, interpolant) => {
                Self::by_metric(file, metric, *interpolant, degree, phase)
            }
            Source::Lengths(lengths) => Self::by_lengths(file, lengths, phase),
            Source::Points => Self::by_points(file, phase),
        }
    }

    /// A formula in the coordinates of space, on the surface that lies in it.
    fn in_space(
        file: &'a MeshFile,
        metric: &MetricFile,
        interpolant: Interpolant,
        degree: usize,
        phase: Phase<'_>,
    ) -> Result<Self, CurvatureError> {
        phase("interpolating the metric on the surface");
        let made = Dimension::<N>::interpolate(file, metric, interpolant, degree);
        let (g_h, points) = made?;
        Ok(Self {
            file,
            g_h,
            interpolant: interpolant.name(),
            origin: None,
            notes: notes(file, points.mesh(), kinks(metric)),
            points: Some(points),
        })
    }

    fn by_lengths(
        file: &'a MeshFile,
        lengths: &Path,
        phase: Phase<'_>,
    ) -> Result<Self, CurvatureError> {
        phase("building the mesh");
        let mesh = file.abstract_mesh::<N>()?;
        let space = ReggeSpace::new(&mesh, 0);
        phase("reading the edge lengths");
        let squares = read_lengths(lengths, &mesh)?;
        Ok(Self {
            file,
            g_h: space.function(squares).map_err(failed)?,
            interpolant: "lengths",
            origin: None,
            notes: notes(file, &mesh, None),
            points: None,
        })
    }

    /// The edges' lengths in space, or F*δ where cells are curved.
    fn by_points(file: &'a MeshFile, phase: Phase<'_>) -> Result<Self, CurvatureError> {
        phase("building the mesh");
        let points = file.immersion::<N>()?;
        Ok(Self {
            file,
            g_h: points.metric(),
            interpolant: "points",
            origin: None,
            notes: notes(file, points.mesh(), None),
            points: Some(points),
        })
    }

    fn by_metric(
        file: &'a MeshFile,
        metric: &'a MetricFile,
        interpolant: Interpolant,
        degree: usize,
        phase: Phase<'_>,
    ) -> Result<Self, CurvatureError> {
        phase("building the mesh");
        let mesh = file.mesh::<N>()?;
        let g = Smooth::new(&mesh, metric.metric()).map_err(input)?;
        phase("interpolating the metric");
        let space = ReggeSpace::new(&mesh, degree);
        let g_h = interpolant.apply(&space, &g);
        // The interpolant refuses what is not positive definite where it looks; the formula may be to blame for it.
        let g_h = g_h.map_err(|error| match blame(&g, degree) {
            Err(formula) => input(formula),
            Ok(()) => lost(error, &g, interpolant, degree),
        })?;
        Ok(Self {
            file,
            g_h,
            interpolant: interpolant.name(),
            origin: Some(Origin {
                metric: g,
                scalar_curvature: metric.exact_scalar_curvature.as_ref(),
            }),
            notes: notes(file, &mesh, kinks(metric)),
            points: None,
        })
    }
}

/// The formula is a metric, what was made of it is not: what else would be, as far as that can be tried at once.
fn lost<const N: usize>(
    error: Error,
    g: &Smooth<FormulaMetric<'_>, N>,
    interpolant: Interpolant,
    degree: usize,
) -> CurvatureError {
    let Error::Indefinite { cell, point, .. } = &error else {
        return failed(error);
    };
    let works = |interpolant: Interpolant, degree: usize| {
        let space = ReggeSpace::new(g.mesh(), degree);
        interpolant.check_degree(degree).is_ok() && interpolant.apply(&space, g).is_ok()
    };
    let name = interpolant.name();
    let geodesic = Interpolant::named("geodesic").filter(|of| degree == 0 && !of.is(&interpolant));
    let mut ways = Vec::new();
    if works(interpolant, degree + 1) {
        ways.push(format!("--degree {}", degree + 1));
    }
    if geodesic.is_some_and(|geodesic| works(geodesic, degree)) {
        ways.push("--interpolant geodesic".into());
    }
    let advice = match ways.is_empty() {
        true => "refine the mesh there".to_owned(),
        false => format!("refine the mesh there, or use {}", ways.join(" or ")),
    };
    CurvatureError::Failed(format!(
        "cell {cell}: the {name} interpolant of degree {degree} is not positive definite at the barycentric point \
         {point:?}, though the metric is: the cell is too large or too thin for it; {advice}"
    ))
}

/// What is to be known of the file, the mesh and the metric.
fn notes<const N: usize>(file: &MeshFile, mesh: &Mesh<N>, metric: Option<String>) -> Vec<String> {
    let all = file.notes.iter().cloned();
    all.chain(topology::odd_links(mesh)).chain(metric).collect()
}

/// Says that a formula is not smooth everywhere, if it is not.
fn kinks(metric: &MetricFile) -> Option<String> {
    let names = metric.kinks();
    (!names.is_empty()).then(|| {
        format!(
            "the metric uses {}, which has a kink: there the derivatives of one side are taken, and no curvature that is \
             concentrated on it is seen in the smooth metric",
            names.join(", ")
        )
    })
}

/// Is the formula itself no metric somewhere that the interpolant looks at it?
fn blame<const N: usize>(g: &Smooth<FormulaMetric<'_>, N>, degree: usize) -> Result<(), Error> {
    smooth::check_values(g, &Rule::new(N, 2 * degree + 2))?;
    smooth::check_edges(g, degree)?;
    // The rule of the local projections.
    smooth::check_values(g, &Rule::new(N, Interpolant::default_order(degree)))
}

//! Floor 3. Smooth metrics: formulas, and functions of the user.

use crate::arrays::{array2, slice};
use crate::failure::Failure;
use crate::job::Watch;
use numpy::{PyReadonlyArray1, PyReadonlyArray3};
use pyo3::prelude::*;
use regge_curvature::density::Volume;
use regge_curvature::field::{Ambient, Evaluate};
use regge_curvature::functional::{Rules, integrate, smooth_curvature};
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, inverse_and_det};
use regge_curvature::metrics::SmoothTensor;
use regge_curvature::quadrature::Rule;
use regge_curvature::scalar::Real;
use regge_curvature::simplex::Points;
use regge_curvature::{Lagrange, Mesh, Metric, Smooth, TensorField};
use regge_readers::metric::{MetricFile, metric_from, read_metric};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A smooth metric, of whatever dimension.
#[pyclass(frozen, module = "regge._regge")]
pub struct Source {
    /// How it is stated.
    pub kind: Kind,
}

/// How a metric is stated.
#[derive(Clone)]
pub enum Kind {
    /// By a formula.
    Formula(Formula),
    /// By functions of the user: points `(n, N)` to components `(n, N, N)`, and to R `(n,)` if it is known.
    Functions(Arc<Functions>),
}

/// Functions of the user.
pub struct Functions {
    metric: Py<PyAny>,
    scalar_curvature: Option<Py<PyAny>>,
}

/// A formula that the library knows, or that was read.
#[derive(Clone)]
pub enum Formula {
    /// The library's own.
    Known(Metric),
    /// One that was read.
    Read(Arc<MetricFile>),
}

impl Formula {
    fn dimension(&self) -> Option<usize> {
        match self {
            Self::Known(_) => None,
            Self::Read(file) => Some(file.dimension),
        }
    }

    /// R where it is stated.
    fn stated<const N: usize>(&self, x: &[f64; N]) -> Option<f64> {
        match self {
            Self::Known(metric) => metric.scalar_curvature(x),
            Self::Read(file) => file.exact_scalar_curvature.as_ref().map(|r| r.at(x)),
        }
    }
}

impl<const N: usize> SmoothTensor<N> for Formula {
    fn at<S: Real>(&self, x: &[S; N]) -> Mat<S, N> {
        match self {
            Self::Known(metric) => metric.at(x),
            Self::Read(file) => file.metric().at(x),
        }
    }

    fn contains(&self, x: &[f64; N]) -> bool {
        match self {
            Self::Known(metric) => metric.contains(x),
            Self::Read(_) => true,
        }
    }
}

#[pymethods]
impl Source {
    /// One of the library's metrics by its name.
    #[staticmethod]
    fn known(name: &str) -> Option<Self> {
        let known = Metric::ALL.iter().find(|metric| metric.0 == name)?;
        let kind = Kind::Formula(Formula::Known(known.1));
        Some(Self { kind })
    }

    /// A metric from TOML; `name` is what refusals call the text.
    #[staticmethod]
    fn toml(name: &str, text: &str) -> PyResult<Self> {
        let file = metric_from(Path::new(name), text).map_err(Failure::from)?;
        Ok(Self::of(file))
    }

    /// A metric from a TOML file.
    #[staticmethod]
    fn file(path: PathBuf) -> PyResult<Self> {
        Ok(Self::of(read_metric(&path).map_err(Failure::from)?))
    }

    /// A metric by functions.
    #[staticmethod]
    #[pyo3(signature = (metric, scalar_curvature=None))]
    fn functions(metric: Py<PyAny>, scalar_curvature: Option<Py<PyAny>>) -> Self {
        let functions = Functions {
            metric,
            scalar_curvature,
        };
        Self {
            kind: Kind::Functions(Arc::new(functions)),
        }
    }

    /// N; None if it is a metric in any dimension.
    #[getter]
    fn dimension(&self) -> Option<usize> {
        match &self.kind {
            Kind::Formula(formula) => formula.dimension(),
            Kind::Functions(_) => None,
        }
    }
}

impl Source {
    fn of(file: MetricFile) -> Self {
        Self {
            kind: Kind::Formula(Formula::Read(Arc::new(file))),
        }
    }
}

/// The names of the metrics that the library knows.
#[pyfunction]
pub fn known_metrics() -> Vec<&'static str> {
    Metric::ALL.iter().map(|metric| metric.0).collect()
}

/// A smooth metric on a mesh, by its values alone or with its derivatives.
pub enum Given<'w, const N: usize> {
    /// A formula.
    Formula(Smooth<Formula, N>),
    /// What a function says.
    Sampled(Sampled<'w, N>),
}

impl Kind {
    /// On a mesh.
    ///
    /// # Errors
    /// If it is of another dimension, or the mesh has no coordinates.
    pub fn on<'w, const N: usize>(
        &self,
        mesh: &Mesh<N>,
        watch: &'w Watch,
    ) -> Result<Given<'w, N>, Failure> {
        match self {
            Self::Formula(formula) => match formula.dimension() {
                Some(n) if n != N => Err(Failure::Value(format!(
                    "the metric has dimension {n}, the mesh has {N}"
                ))),
                _ => Ok(Given::Formula(Smooth::new(mesh, formula.clone())?)),
            },
            Self::Functions(functions) => {
                if !mesh.has_coordinates() {
                    return Err(regge_curvature::Error::NoCoordinates("a function").into());
                }
                Ok(Given::Sampled(Sampled {
                    mesh: mesh.clone(),
                    functions: Arc::clone(functions),
                    watch,
                }))
            }
        }
    }
}

/// A metric by a function of the user.
pub struct Sampled<'w, const N: usize> {
    mesh: Mesh<N>,
    functions: Arc<Functions>,
    watch: &'w Watch,
}

/// Where the points of a rule are in all cells of a mesh, one after the other.
fn places<const N: usize>(mesh: &Mesh<N>, points: &Points) -> Vec<f64> {
    let mut all = Vec::with_capacity(mesh.cell_count() * points.len() * N);
    for cell in 0..mesh.cell_count() {
        for q in 0..points.len() {
            all.extend(place(mesh, cell, points.lambda(q)));
        }
    }
    all
}

/// The point with these barycentric coordinates in ℝ^N.
pub fn place<const N: usize>(mesh: &Mesh<N>, cell: usize, lambda: &[f64]) -> [f64; N] {
    let mut x = [0.0; N];
    for (i, l) in lambda.iter().enumerate() {
        let corner = mesh
            .corner(cell, i)
            .expect("a smooth metric is on a mesh with coordinates");
        for (x, c) in x.iter_mut().zip(corner.iter()) {
            *x += l * c;
        }
    }
    x
}

impl<const N: usize> Sampled<'_, N> {
    /// g at points, row by row.
    fn metric(&self, x: Vec<f64>) -> Vec<f64> {
        let functions = Arc::clone(&self.functions);
        self.watch.in_python(move |py| {
            let values = functions.metric.call1(py, (array2(py, x, N)?,))?;
            let values: PyReadonlyArray3<'_, f64> = values.bind(py).extract()?;
            Ok(values.as_slice()?.to_vec())
        })
    }

    /// R at points; None if nobody said what it is.
    fn scalar_curvature(&self, x: Vec<f64>) -> Option<Vec<f64>> {
        self.functions.scalar_curvature.as_ref()?;
        let functions = Arc::clone(&self.functions);
        Some(self.watch.in_python(move |py| {
            let function = functions.scalar_curvature.as_ref();
            let function = function.expect("it was seen to that there is one");
            let values = function.call1(py, (array2(py, x, N)?,))?;
            let values: PyReadonlyArray1<'_, f64> = values.bind(py).extract()?;
            Ok(slice(&values)?.to_vec())
        }))
    }
}

/// g at the points of a rule in all cells.
pub struct Samples {
    points: usize,
    values: Vec<f64>,
}

/// What is known of a metric in a cell.
pub enum Local<const N: usize> {
    /// Of a formula.
    Formula(<Smooth<Formula, N> as Evaluate<f64, N>>::Local),
    /// Of samples: the cell and ∂x/∂ξ.
    Sampled(usize, Mat<f64, N>),
}

/// What is known of a metric at points.
pub enum Table<const N: usize> {
    /// Of a formula.
    Formula(<Smooth<Formula, N> as Evaluate<f64, N>>::Table),
    /// Samples.
    Sampled(Samples),
}

impl<const N: usize> Evaluate<f64, N> for Given<'_, N> {
    type Table = Table<N>;
    type Local = Local<N>;

    fn tabulate(&self, points: &Points) -> Table<N> {
        match self {
            Self::Formula(smooth) => Table::Formula(smooth.tabulate(points)),
            Self::Sampled(sampled) => Table::Sampled(Samples {
                points: points.len(),
                values: sampled.metric(places(&sampled.mesh, points)),
            }),
        }
    }

    fn on_cell(&self, cell: usize) -> Local<N> {
        match self {
            Self::Formula(smooth) => Local::Formula(Evaluate::<f64, N>::on_cell(smooth, cell)),
            Self::Sampled(sampled) => {
                let jacobian = sampled.mesh.jacobian(cell);
                Local::Sampled(cell, jacobian.expect("samples need coordinates"))
            }
        }
    }

    fn jet2(&self, local: &Local<N>, table: &Table<N>, block: usize) -> Mat<Jet2<f64, N>, N> {
        match (self, local, table) {
            (Self::Formula(smooth), Local::Formula(local), Table::Formula(table)) => {
                smooth.jet2(local, table, block)
            }
            // Samples have no derivatives, and whoever asks for them shall see it.
            _ => self.value(local, table, block).map(|value| Jet2 {
                value,
                d: [f64::NAN; N],
                dd: [[f64::NAN; N]; N],
            }),
        }
    }

    fn jet1(&self, local: &Local<N>, table: &Table<N>, block: usize) -> Mat<Jet1<f64, N>, N> {
        match (self, local, table) {
            (Self::Formula(smooth), Local::Formula(local), Table::Formula(table)) => {
                smooth.jet1(local, table, block)
            }
            _ => self.value(local, table, block).map(|value| Jet1 {
                value,
                d: [f64::NAN; N],
            }),
        }
    }

    fn value(&self, local: &Local<N>, table: &Table<N>, block: usize) -> Mat<f64, N> {
        match (self, local, table) {
            (Self::Formula(smooth), Local::Formula(local), Table::Formula(table)) => {
                smooth.value(local, table, block)
            }
            (_, Local::Sampled(cell, jacobian), Table::Sampled(samples)) => {
                let start = (cell * samples.points + block) * N * N;
                let g = Mat::from_row_slice(&samples.values[start..start + N * N]);
                jacobian.transpose() * g * jacobian
            }
            _ => unreachable!("cells and tables are those of this metric"),
        }
    }

    fn ambient(&self) -> Option<&dyn Ambient<N>> {
        match self {
            Self::Formula(smooth) => Evaluate::<f64, N>::ambient(smooth),
            Self::Sampled(_) => None,
        }
    }
}

/// Point by point: samples are there already, and a formula alone is evaluated by lanes.
impl<const N: usize> TensorField<N> for Given<'_, N> {
    type Scalar = f64;
    type Wide = f64;
}

impl<const N: usize> Given<'_, N> {
    /// ∫ R v ω for every function v, with R as it is stated, or else from derivatives of the formula.
    ///
    /// # Errors
    /// If g is a function and R is not stated.
    pub fn curvature(&self, space: &Lagrange<N>, rules: &Rules) -> Result<Vec<f64>, Failure> {
        let mesh = space.mesh();
        let stated = match self {
            Self::Formula(smooth) => {
                let formula = smooth.formula();
                let origin = place(mesh, 0, Rule::new(N, 1).points().lambda(0));
                if formula.stated(&origin).is_none() {
                    return Ok(smooth_curvature(smooth, space, rules));
                }
                let at = |x: &[f64]| formula.stated::<N>(x.try_into().expect("N coordinates"));
                let all = places(mesh, rules.cells.points());
                all.chunks_exact(N).filter_map(at).collect()
            }
            Self::Sampled(sampled) => {
                let all = places(mesh, rules.cells.points());
                sampled.scalar_curvature(all).ok_or_else(|| {
                    let reason = "the metric is a function, which has values only: say what its \
                                  scalar curvature is, regge.metric(g, scalar_curvature=R)";
                    Failure::Value(reason.into())
                })?
            }
        };
        Ok(self.integrate(&stated, space, &rules.cells))
    }

    /// ∫ f v ω for values of f at the points of a rule in all cells.
    fn integrate(&self, f: &[f64], space: &Lagrange<N>, rule: &Rule) -> Vec<f64> {
        let table = self.tabulate(rule.points());
        let cells = 0..space.mesh().cell_count();
        integrate::<f64, N>(space, N, rule, cells, |cell, _, q| {
            let (_, det) = inverse_and_det(&self.value(&self.on_cell(cell), &table, q));
            f[cell * rule.len() + q] * Volume::from_det(det)
        })
    }
}

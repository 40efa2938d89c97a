//! Floor 6. Meshes of any dimension, and the one place that chooses the dimension.

use crate::arrays::{array1, array2, cells, integers};
use crate::failure::Failure;
use crate::function::{AnyFunction, Function};
use crate::job::{self, Watch};
use crate::source::{Given, Kind, Source};
use crate::space::{AnySpace, Space};
use crate::watched::Watched;
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray2};
use pyo3::prelude::*;
use regge_curvature::linalg::Vector;
use regge_curvature::{Error, Interpolant, ReggeSpace};
use regge_readers::mesh::{MeshFile, read_mesh};
use std::path::PathBuf;
use std::sync::Arc;

/// What a mesh offers, whatever its dimension.
pub trait AnyMesh: Send + Sync {
    /// N.
    fn dimension(&self) -> usize;
    /// How many k-simplices.
    fn count(&self, k: usize) -> usize;
    /// The vertices of all k-simplices.
    fn vertices(&self, k: usize) -> Vec<i64>;
    /// The numbers of the k-simplices of the boundary.
    fn boundary(&self, k: usize) -> Vec<i64>;
    /// The numbers of the k-simplices of every cell, k < N.
    fn of_cells(&self, k: usize) -> Vec<i64>;
    /// The points of the vertices.
    fn points(&self) -> Option<Vec<f64>>;
    /// The corners of every cell.
    fn corners(&self) -> Option<Vec<f64>>;
    /// Σ_k (−1)^k |𝒯^k|.
    fn euler_characteristic(&self) -> i64;
    /// h.
    fn mesh_size(&self) -> f64;
    /// With its inner vertices moved.
    fn perturbed(&self, amplitude: f64, seed: u64) -> Result<Arc<dyn AnyMesh>, Error>;
    /// A Regge space.
    fn space(&self, degree: usize) -> Arc<dyn AnySpace>;
    /// A Regge metric from a smooth one.
    fn interpolate(
        &self,
        metric: &Kind,
        degree: usize,
        how: Interpolant,
        watch: &Watch,
    ) -> Result<Arc<dyn AnyFunction>, Failure>;
}

impl<const N: usize> AnyMesh for regge_curvature::Mesh<N> {
    fn dimension(&self) -> usize {
        N
    }

    fn count(&self, k: usize) -> usize {
        self.count(k)
    }

    fn vertices(&self, k: usize) -> Vec<i64> {
        let of = |simplex| self.vertices(k, simplex).iter().map(|&v| i64::from(v));
        (0..self.count(k)).flat_map(of).collect()
    }

    fn boundary(&self, k: usize) -> Vec<i64> {
        integers((0..self.count(k)).filter(|&s| !self.is_interior(k, s)))
    }

    fn of_cells(&self, k: usize) -> Vec<i64> {
        let of = |cell| self.simplices_of(cell, k).iter().map(|&s| i64::from(s));
        (0..self.cell_count()).flat_map(of).collect()
    }

    fn points(&self) -> Option<Vec<f64>> {
        Some(
            self.points()?
                .iter()
                .flat_map(|x| x.iter().copied())
                .collect(),
        )
    }

    fn corners(&self) -> Option<Vec<f64>> {
        let mut all = Vec::with_capacity(self.cell_count() * (N + 1) * N);
        for cell in 0..self.cell_count() {
            for i in 0..=N {
                all.extend(self.corner(cell, i)?.iter());
            }
        }
        Some(all)
    }

    fn euler_characteristic(&self) -> i64 {
        self.euler_characteristic()
    }

    fn mesh_size(&self) -> f64 {
        self.mesh_size()
    }

    fn perturbed(&self, amplitude: f64, seed: u64) -> Result<Arc<dyn AnyMesh>, Error> {
        Ok(Arc::new(self.perturbed(amplitude, seed)?))
    }

    fn space(&self, degree: usize) -> Arc<dyn AnySpace> {
        Arc::new(ReggeSpace::new(self, degree))
    }

    fn interpolate(
        &self,
        metric: &Kind,
        degree: usize,
        how: Interpolant,
        watch: &Watch,
    ) -> Result<Arc<dyn AnyFunction>, Failure> {
        let given = metric.on(self, watch)?;
        // Once to see that it is a metric, and about once more to integrate it.
        watch.expect(2 * self.cell_count());
        let space = ReggeSpace::new(self, degree);
        let g_h = match given {
            Given::Formula(smooth) => how.apply(&space, &Watched::new(smooth, watch)),
            sampled @ Given::Sampled(_) => how.apply(&space, &Watched::new(sampled, watch)),
        };
        Ok(Arc::new(g_h?))
    }
}

/// Does a thing in a dimension that is known at run time only: `by_dimension!(n, N => expression)`, where N is a constant
/// in the expression.
macro_rules! by_dimension {
    ($dimension:expr, $n:ident => $do:expr) => {
        by_dimension!(@ $dimension, $n => $do; 2, 3, 4, 5)
    };
    (@ $dimension:expr, $n:ident => $do:expr; $($known:literal),*) => {
        match $dimension {
            $($known => {
                const $n: usize = $known;
                $do
            })*
            other => Err(Failure::Value(format!(
                "a mesh of dimension {other}: this package is built for dimensions {:?}",
                [$($known),*]
            ))),
        }
    };
}

/// Do the points of a file differ in coordinates beyond the N that cells have?
fn is_immersed(file: &MeshFile) -> bool {
    let n = file.dimension;
    let mut beyond = file
        .coordinates
        .chunks_exact(file.width.max(1))
        .map(|x| x.get(n..));
    let first = beyond.next().flatten();
    file.width > n && beyond.any(|rest| rest != first)
}

/// What constructors return.
type Made = Result<Arc<dyn AnyMesh>, Failure>;

fn made<const N: usize>(mesh: Result<regge_curvature::Mesh<N>, impl Into<Failure>>) -> Made {
    mesh.map(|mesh| Arc::new(mesh) as Arc<dyn AnyMesh>)
        .map_err(Into::into)
}

/// What is found in a file.
type ReadFile<'py> = (
    Mesh,
    Option<Bound<'py, PyArray2<f64>>>,
    Option<Function>,
    Vec<String>,
);

/// A mesh.
#[pyclass(frozen, module = "regge._regge")]
pub struct Mesh {
    inner: Arc<dyn AnyMesh>,
}

impl Mesh {
    fn of(made: Made) -> PyResult<Self> {
        Ok(Self { inner: made? })
    }
}

#[pymethods]
impl Mesh {
    /// The triangulation of a domain.
    #[staticmethod]
    fn of_points(
        points: PyReadonlyArray2<'_, f64>,
        simplices: PyReadonlyArray2<'_, i64>,
    ) -> PyResult<Self> {
        let (simplices, points) = (cells(&simplices)?, points.as_array());
        Self::of(by_dimension!(points.ncols(), N => {
            let rows = points.rows().into_iter();
            let all = rows.map(|row| Vector::<f64, N>::from_fn(|i, _| row[i])).collect();
            made(regge_curvature::Mesh::<N>::new(all, &simplices))
        }))
    }

    /// A manifold without coordinates.
    #[staticmethod]
    fn of_cells(vertices: usize, simplices: PyReadonlyArray2<'_, i64>) -> PyResult<Self> {
        let simplex = simplices.as_array().ncols();
        let simplices = cells(&simplices)?;
        Self::of(by_dimension!(simplex.saturating_sub(1), N => {
            made(regge_curvature::Mesh::<N>::new_abstract(vertices, &simplices))
        }))
    }

    /// (−1, 1)^N in `side`^N cubes.
    #[staticmethod]
    fn cube(dimension: usize, side: usize) -> PyResult<Self> {
        Self::of(by_dimension!(dimension, N => made(regge_curvature::Mesh::<N>::cube(side))))
    }

    /// The cube with opposite faces identified.
    #[staticmethod]
    fn torus(dimension: usize, side: usize) -> PyResult<Self> {
        Self::of(by_dimension!(dimension, N => made(regge_curvature::Mesh::<N>::torus(side))))
    }

    /// The boundary of one simplex.
    #[staticmethod]
    fn simplex_boundary(dimension: usize) -> PyResult<Self> {
        Self::of(by_dimension!(dimension, N => {
            made(regge_curvature::Mesh::<N>::simplex_boundary())
        }))
    }

    /// The mesh of a file; its points where they are in a space of more dimensions, and the metric of curved cells there; what its
    /// author may want to know. `forget` leaves points out.
    #[staticmethod]
    fn read<'py>(py: Python<'py>, path: PathBuf, forget: bool) -> PyResult<ReadFile<'py>> {
        let (inner, width, points, metric, notes) = job::run(py, None, move |_| {
            let mut file = read_mesh(&path)?;
            let immersed = !forget && is_immersed(&file);
            let mut metric = None;
            let inner = by_dimension!(file.dimension, N => match &file.curved {
                Some(_) if immersed => {
                    let surface = file.immersion::<N>()?;
                    metric = Some(Arc::new(surface.metric()) as Arc<dyn AnyFunction>);
                    made(Ok::<_, Failure>(surface.mesh().clone()))
                }
                _ if !forget && !immersed && file.has_coordinates() => made(file.mesh::<N>()),
                _ => made(file.abstract_mesh::<N>()),
            })?;
            if let (Some(curved), false) = (&file.curved, forget || immersed) {
                let order = curved.order;
                let note = format!("cells of order {order} in ℝ^N are taken by their corners");
                file.notes.push(note);
            }
            let points = immersed.then_some(file.coordinates);
            Ok((inner, file.width, points, metric, file.notes))
        })?;
        let points = points.map(|all| array2(py, all, width)).transpose()?;
        Ok((Self { inner }, points, metric.map(Function::new), notes))
    }

    fn perturbed(&self, amplitude: f64, seed: u64) -> PyResult<Self> {
        Self::of(self.inner.perturbed(amplitude, seed).map_err(Failure::from))
    }

    #[getter]
    fn dimension(&self) -> usize {
        self.inner.dimension()
    }

    #[getter]
    fn euler_characteristic(&self) -> i64 {
        self.inner.euler_characteristic()
    }

    #[getter]
    fn mesh_size(&self) -> f64 {
        self.inner.mesh_size()
    }

    fn count(&self, k: usize) -> usize {
        self.inner.count(k)
    }

    fn vertices<'py>(&self, py: Python<'py>, k: usize) -> PyResult<Bound<'py, PyArray2<i64>>> {
        array2(py, self.inner.vertices(k), k + 1)
    }

    fn boundary<'py>(&self, py: Python<'py>, k: usize) -> Bound<'py, PyArray1<i64>> {
        array1(py, self.inner.boundary(k))
    }

    fn of_each_cell<'py>(&self, py: Python<'py>, k: usize) -> PyResult<Bound<'py, PyArray2<i64>>> {
        let all = self.inner.of_cells(k);
        let width = all.len() / self.inner.count(self.inner.dimension());
        array2(py, all, width)
    }

    fn points<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
        let width = self.inner.dimension();
        let points = self.inner.points();
        points.map(|all| array2(py, all, width)).transpose()
    }

    fn corners<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray3<f64>>>> {
        let n = self.inner.dimension();
        let cells = self.inner.count(n);
        let shaped = |all| array1(py, all).reshape([cells, n + 1, n]);
        self.inner.corners().map(shaped).transpose()
    }

    fn space(&self, degree: usize) -> Space {
        Space {
            inner: self.inner.space(degree),
        }
    }

    #[pyo3(signature = (metric, degree, kind, order=None, progress=None))]
    fn interpolate(
        &self,
        py: Python<'_>,
        metric: &Source,
        degree: usize,
        kind: &str,
        order: Option<usize>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Function> {
        let how = Interpolant::named(kind);
        let how =
            how.ok_or_else(|| Failure::Value(format!("no interpolant is called {kind:?}")))?;
        let how = order.map_or(how, |order| how.with_order(order));
        let (mesh, metric) = (Arc::clone(&self.inner), metric.kind.clone());
        let inner = job::run(py, progress, move |watch| {
            mesh.interpolate(&metric, degree, how, watch)
        })?;
        Ok(Function::known_metric(inner))
    }
}

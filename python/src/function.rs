//! Floor 4. Regge functions of any dimension, and what is computed of them.

use crate::arrays::{array1, indices, integers, matrices, slice};
use crate::failure::Failure;
use crate::job::{self, Watch};
use crate::source::{Kind, Source};
use crate::watched::Watched;
use numpy::{PyArray1, PyArray3, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use regge_curvature::field::Evaluate;
use regge_curvature::functional::{
    Rules, Sums, a_h, action_gradient, action_hessian, angle_defects, b_h, boundary_curvatures,
    cell_volumes, distributional_curvatures, einstein_against, regge_action, variation,
    variation_adjoint,
};
use regge_curvature::interpolate::Canonical;
use regge_curvature::norm::{Kind as Norm, Setting, metric_values};
use regge_curvature::project::{Projection, Tested};
use regge_curvature::quadrature::Rule;
use regge_curvature::simplex::Points;
use regge_curvature::spaces::{Indicators, Scalar, TestSpace};
use regge_curvature::{Error, Lagrange, ReggeFunction, ReggeSpace};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// With what the curvature is paired.
#[derive(Clone, Copy)]
pub enum Tests {
    /// Lagrange functions of a degree.
    Lagrange(usize),
    /// Simplices one by one.
    Simplices,
}

/// The norm of the error of the curvature.
pub struct ErrorNorm {
    total: f64,
    parts: Vec<(&'static str, f64)>,
    steps: usize,
    solver: &'static str,
}

/// An entry of a matrix by its row and column.
type Entries = (Vec<i64>, Vec<i64>, Vec<f64>);

/// What a Regge function offers, whatever its dimension. `order` is that of the rules of quadrature.
pub trait AnyFunction: Send + Sync {
    /// N.
    fn dimension(&self) -> usize;
    /// r.
    fn degree(&self) -> usize;
    /// How many cells.
    fn cells(&self) -> usize;
    /// Its coefficients.
    fn coefficients(&self) -> &[f64];
    /// Is it a metric, at the points of a rule of this order?
    fn check(&self, order: usize) -> Result<(), Error>;
    /// Values in cells at points: in reference coordinates, or in those of ℝ^N.
    fn values(&self, cells: &[usize], lambda: &[f64], ambient: bool) -> Result<Vec<f64>, Error>;
    /// ⟨(Rω)_dist, v⟩.
    fn curvature(&self, tests: Tests, order: usize, watch: &Watch) -> Sums<f64>;
    /// The terms of the boundary.
    fn boundary(&self, tests: Tests, order: usize, watch: &Watch) -> Sums<f64>;
    /// The projection R_h of what has this load.
    fn density(
        &self,
        degree: usize,
        load: &[f64],
        all: bool,
        order: usize,
    ) -> Result<Vec<f64>, Error>;
    /// b_h, a_h or the derivative, for another function of the same space.
    fn form(
        &self,
        form: Form,
        sigma: Vec<f64>,
        degree: usize,
        order: usize,
        watch: &Watch,
    ) -> Result<Sums<f64>, Error>;
    /// The derivative's transpose for weights of Lagrange functions.
    fn adjoint(
        &self,
        weights: &[f64],
        degree: usize,
        boundary: bool,
        order: usize,
        watch: &Watch,
    ) -> Result<Sums<f64>, Error>;
    /// ⟨(Gω)_dist, ψ⟩ for the functions of a Regge space.
    fn einstein(&self, degree: usize, order: usize, watch: &Watch) -> Sums<f64>;
    /// The action's interior and boundary.
    fn action(&self, order: usize, watch: &Watch) -> [f64; 2];
    /// Its gradient in the lengths, and the residual of Schläfli's identity.
    fn action_gradient(&self) -> Result<(Vec<f64>, f64), Error>;
    /// Its Hessian.
    fn action_hessian(&self) -> Result<Entries, Error>;
    /// The interior hinges, Θ_S at their barycentres, |S|.
    fn defects(&self, order: usize) -> (Vec<i64>, Vec<f64>, Vec<f64>);
    /// The volumes of the cells.
    fn volumes(&self, order: usize, watch: &Watch) -> Vec<f64>;
    /// Its canonical degrees of freedom.
    fn canonical(&self, order: usize) -> Vec<f64>;
    /// ‖(Rω)_dist − (Rω)(metric)‖ in a norm.
    fn error_norm(
        &self,
        metric: &Kind,
        norm: &str,
        order: usize,
        watch: &Watch,
    ) -> Result<ErrorNorm, Failure>;
}

/// The two forms of the curvature's first variation, and their difference, on the boundary too or not.
#[derive(Clone, Copy)]
pub enum Form {
    /// b_h.
    B,
    /// a_h.
    A,
    /// b_h − a_h.
    Difference(bool),
}

/// Does a thing with the test space that is meant.
fn tested<const N: usize, R>(
    g: &ReggeFunction<f64, N>,
    tests: Tests,
    with: impl FnOnce(&dyn TestSpace<N, Value = Scalar>) -> R,
) -> R {
    let mesh = g.space().mesh();
    match tests {
        Tests::Lagrange(degree) => with(&Lagrange::new(mesh, degree)),
        Tests::Simplices => with(&Indicators::new(mesh)),
    }
}

fn one<S>(sums: Vec<S>) -> S {
    sums.into_iter().next().expect("one space, one result")
}

impl<const N: usize> AnyFunction for ReggeFunction<f64, N> {
    fn dimension(&self) -> usize {
        N
    }

    fn degree(&self) -> usize {
        self.space().degree()
    }

    fn cells(&self) -> usize {
        self.space().mesh().cell_count()
    }

    fn coefficients(&self) -> &[f64] {
        self.coefficients()
    }

    fn check(&self, order: usize) -> Result<(), Error> {
        self.check_positive(Rule::new(N, order).points())
    }

    fn values(&self, cells: &[usize], lambda: &[f64], ambient: bool) -> Result<Vec<f64>, Error> {
        let mesh = self.space().mesh();
        let mut all = Vec::with_capacity(cells.len() * N * N);
        for (&cell, lambda) in cells.iter().zip(lambda.chunks_exact(N + 1)) {
            let table = Evaluate::<f64, N>::tabulate(self, &Points::new(N + 1, lambda.to_vec()));
            let local = Evaluate::<f64, N>::on_cell(self, cell);
            let mut g = Evaluate::<f64, N>::value(self, &local, &table, 0);
            if ambient {
                let jacobian = mesh.jacobian(cell);
                let jacobian = jacobian.ok_or(Error::NoCoordinates("a value in them"))?;
                let inverse = jacobian.try_inverse().expect("a cell of a mesh has volume");
                g = inverse.transpose() * g * inverse;
            }
            // Symmetric: rows are columns.
            all.extend(g.iter());
        }
        Ok(all)
    }

    fn curvature(&self, tests: Tests, order: usize, watch: &Watch) -> Sums<f64> {
        watch.expect(self.cells());
        let (g, rules) = (Watched::new(self, watch), Rules::new(N, order));
        tested(self, tests, |space| {
            one(distributional_curvatures(&g, &[space], &rules))
        })
    }

    fn boundary(&self, tests: Tests, order: usize, watch: &Watch) -> Sums<f64> {
        watch.expect(self.cells());
        let (g, rules) = (Watched::new(self, watch), Rules::new(N, order));
        tested(self, tests, |space| {
            one(boundary_curvatures(&g, &[space], &rules))
        })
    }

    fn density(
        &self,
        degree: usize,
        load: &[f64],
        all: bool,
        order: usize,
    ) -> Result<Vec<f64>, Error> {
        let space = Lagrange::new(self.space().mesh(), degree);
        if load.len() != space.len() {
            let (given, wanted) = (load.len(), space.len());
            let reason = format!("{given} values for {wanted} Lagrange functions");
            return Err(Error::Input(reason));
        }
        let tested = if all { Tested::All } else { Tested::Interior };
        let projection = Projection::new(self, &space, tested, &Rule::new(N, order))?;
        projection.apply(load)
    }

    fn form(
        &self,
        form: Form,
        sigma: Vec<f64>,
        degree: usize,
        order: usize,
        watch: &Watch,
    ) -> Result<Sums<f64>, Error> {
        let sigma = self.space().function(sigma)?;
        let space = Lagrange::new(self.space().mesh(), degree);
        let (g, rules) = (Watched::new(self, watch), Rules::new(N, order));
        let passes = match form {
            Form::B | Form::A => 1,
            Form::Difference(boundary) => 2 + usize::from(boundary),
        };
        watch.expect(passes * self.cells());
        let mut sums = match form {
            Form::B => b_h(&g, &sigma, &space, &rules),
            Form::A => a_h(&g, &sigma, &space, &rules),
            Form::Difference(boundary) => variation(&g, &sigma, &space, boundary, &rules),
        };
        if matches!(form, Form::Difference(false)) {
            for dof in (0..space.len()).filter(|&dof| !space.vanishes_on_boundary(dof)) {
                for list in [&mut sums.cells, &mut sums.faces, &mut sums.hinges] {
                    list[dof] = 0.0;
                }
            }
        }
        Ok(sums)
    }

    fn adjoint(
        &self,
        weights: &[f64],
        degree: usize,
        boundary: bool,
        order: usize,
        watch: &Watch,
    ) -> Result<Sums<f64>, Error> {
        let space = Lagrange::new(self.space().mesh(), degree);
        if weights.len() != space.len() {
            let (given, wanted) = (weights.len(), space.len());
            let reason = format!("{given} weights for {wanted} Lagrange functions");
            return Err(Error::Input(reason));
        }
        watch.expect(2 * self.cells());
        let counts = |dof: usize| boundary || space.vanishes_on_boundary(dof);
        let weights: Vec<f64> = (weights.iter().enumerate())
            .map(|(dof, w)| if counts(dof) { *w } else { 0.0 })
            .collect();
        let (g, rules) = (Watched::new(self, watch), Rules::new(N, order));
        Ok(variation_adjoint(
            &g,
            &weights,
            &space,
            self.space(),
            boundary,
            &rules,
        ))
    }

    fn einstein(&self, degree: usize, order: usize, watch: &Watch) -> Sums<f64> {
        watch.expect(self.cells());
        let space = ReggeSpace::new(self.space().mesh(), degree);
        einstein_against(&Watched::new(self, watch), &space, &Rules::new(N, order))
    }

    fn action(&self, order: usize, watch: &Watch) -> [f64; 2] {
        watch.expect(2 * self.cells());
        let (g, rules) = (Watched::new(self, watch), Rules::new(N, order));
        let action = regge_action(&g, self.space().mesh(), &rules);
        [action.interior, action.boundary]
    }

    fn action_gradient(&self) -> Result<(Vec<f64>, f64), Error> {
        let all = action_gradient(self)?;
        Ok((all.gradient, all.schlaefli))
    }

    fn action_hessian(&self) -> Result<Entries, Error> {
        let all = action_hessian(self)?;
        Ok((
            integers(all.iter().map(|entry| entry.row)),
            integers(all.iter().map(|entry| entry.column)),
            all.iter().map(|entry| entry.value).collect(),
        ))
    }

    fn defects(&self, order: usize) -> (Vec<i64>, Vec<f64>, Vec<f64>) {
        let all = angle_defects(self, self.space().mesh(), order);
        (
            integers(all.iter().map(|one| one.hinge)),
            all.iter().map(|one| one.defect).collect(),
            all.iter().map(|one| one.size).collect(),
        )
    }

    fn volumes(&self, order: usize, watch: &Watch) -> Vec<f64> {
        watch.expect(self.cells());
        let (g, rules) = (Watched::new(self, watch), Rules::new(N, order));
        cell_volumes(&g, self.space().mesh(), &rules)
    }

    fn canonical(&self, order: usize) -> Vec<f64> {
        Canonical::new(self.space()).evaluate(self, order)
    }

    fn error_norm(
        &self,
        metric: &Kind,
        norm: &str,
        order: usize,
        watch: &Watch,
    ) -> Result<ErrorNorm, Failure> {
        let kind = Norm::<N>::named(norm);
        let kind = kind
            .ok_or_else(|| Failure::Value(format!("there is no norm {norm:?} in dimension {N}")))?;
        let mesh = self.space().mesh();
        let given = metric.on(mesh, watch)?;
        let values = metric_values(&given);
        let setting = Setting::new(mesh, (kind.degree)(self.degree())).with_metric(&values);
        let norm = (kind.new)(&setting)?;
        let rules = Rules::new(N, order);
        let smooth = given.curvature(norm.space(), &rules)?;
        watch.expect(self.cells());
        let g = Watched::new(self, watch);
        let sums = one(distributional_curvatures(&g, &[norm.space()], &rules));
        let load: Vec<f64> = (sums.total().iter().zip(&smooth))
            .map(|(ours, smooth)| ours - smooth)
            .collect();
        let mut steps = 0;
        let representative = norm.represent(&load, &mut |step| {
            watch.step();
            steps = step.number;
        })?;
        let value = norm.measure(&representative, None)?;
        Ok(ErrorNorm {
            total: value.total,
            parts: value.parts.iter().map(|p| (p.name, p.value)).collect(),
            steps,
            solver: norm.solver(),
        })
    }
}

/// Names, symbols and descriptions of the norms.
#[pyfunction]
pub fn norms() -> Vec<(&'static str, &'static str, &'static str)> {
    let all = Norm::<2>::all().iter();
    all.map(|norm| (norm.name, norm.symbol, norm.about))
        .collect()
}

/// The order of the rules for a metric and test functions of these degrees, unless another is asked for.
#[pyfunction]
pub fn default_order(degree: usize, test_degree: usize) -> usize {
    if degree == 0 {
        // What is integrated is the test function, since a metric of degree 0 is constant on cells.
        return test_degree;
    }
    // The library's is for test functions of degree r + 2.
    Rules::default_order(degree.max(test_degree.saturating_sub(2)))
}

/// A Regge function.
#[pyclass(frozen, module = "regge._regge")]
pub struct Function {
    inner: Arc<dyn AnyFunction>,
    /// Is it known to be a metric?
    is_metric: Arc<AtomicBool>,
}

/// Three lists as arrays.
type Three<'py> = (
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<f64>>,
);

fn three(py: Python<'_>, sums: Sums<f64>) -> Three<'_> {
    (
        array1(py, sums.cells),
        array1(py, sums.faces),
        array1(py, sums.hinges),
    )
}

impl Function {
    /// Any function.
    pub fn new(inner: Arc<dyn AnyFunction>) -> Self {
        Self {
            inner,
            is_metric: Arc::new(AtomicBool::new(false)),
        }
    }

    /// One that has been seen to be a metric.
    pub fn known_metric(inner: Arc<dyn AnyFunction>) -> Self {
        Self {
            inner,
            is_metric: Arc::new(AtomicBool::new(true)),
        }
    }

    /// Runs a piece of work on it, once it is known to be a metric.
    fn run<R: Send + 'static>(
        &self,
        py: Python<'_>,
        progress: Option<&Bound<'_, PyAny>>,
        work: impl FnOnce(&dyn AnyFunction, &Watch) -> Result<R, Failure> + Send + 'static,
    ) -> PyResult<R> {
        let (g, is_metric) = (Arc::clone(&self.inner), Arc::clone(&self.is_metric));
        job::run(py, progress, move |watch| {
            if !is_metric.load(Ordering::Relaxed) {
                // Where the library's interpolants look.
                g.check(2 * g.degree() + 2)?;
                is_metric.store(true, Ordering::Relaxed);
            }
            work(&*g, watch)
        })
    }

    /// One of the forms of the first variation, for every test function.
    fn form<'py>(
        &self,
        py: Python<'py>,
        form: Form,
        sigma: &PyReadonlyArray1<'py, f64>,
        test_degree: usize,
        order: usize,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Three<'py>> {
        let sigma = slice(sigma)?.to_vec();
        let sums = self.run(py, progress, move |g, watch| {
            let sums = g.form(form, sigma, test_degree, order, watch)?;
            finite(g, sums, order)
        })?;
        Ok(three(py, sums))
    }
}

/// Sums that are finite; else the metric is to blame, at a point of the rules or nearby.
fn finite(g: &dyn AnyFunction, sums: Sums<f64>, order: usize) -> Result<Sums<f64>, Failure> {
    let lists = [&sums.cells, &sums.faces, &sums.hinges];
    if lists.iter().all(|list| list.iter().all(|x| x.is_finite())) {
        return Ok(sums);
    }
    g.check(order)?;
    let reason = "a sum is not finite: the metric may be all but degenerate".into();
    Err(Error::Solver(reason).into())
}

fn tests(degree: Option<usize>) -> Tests {
    degree.map_or(Tests::Simplices, Tests::Lagrange)
}

#[pymethods]
impl Function {
    #[getter]
    fn degree(&self) -> usize {
        self.inner.degree()
    }

    /// A copy.
    fn coefficients<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.inner.coefficients())
    }

    fn check(&self, py: Python<'_>) -> PyResult<()> {
        self.run(py, None, |_, _| Ok(()))
    }

    /// `[point][i][j]`.
    fn values<'py>(
        &self,
        py: Python<'py>,
        cells: PyReadonlyArray1<'py, i64>,
        points: PyReadonlyArray2<'py, f64>,
        ambient: bool,
    ) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let cells = indices(&cells, self.inner.cells())?;
        let values = self.inner.values(&cells, points.as_slice()?, ambient);
        matrices(py, values.map_err(Failure::from)?, self.inner.dimension())
    }

    /// The three sums, by Lagrange function of this degree, or by indicator if there is none.
    #[pyo3(signature = (test_degree, order, boundary, progress=None))]
    fn curvature<'py>(
        &self,
        py: Python<'py>,
        test_degree: Option<usize>,
        order: usize,
        boundary: bool,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Three<'py>, Option<Three<'py>>)> {
        let (inner, outer) = self.run(py, progress, move |g, watch| {
            let tests = tests(test_degree);
            let inner = finite(g, g.curvature(tests, order, watch), order)?;
            let outer = boundary.then(|| g.boundary(tests, order, watch));
            Ok((inner, outer.map(|sums| finite(g, sums, order)).transpose()?))
        })?;
        Ok((three(py, inner), outer.map(|sums| three(py, sums))))
    }

    fn density<'py>(
        &self,
        py: Python<'py>,
        degree: usize,
        load: PyReadonlyArray1<'py, f64>,
        all: bool,
        order: usize,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let load = slice(&load)?.to_vec();
        let density = self.run(py, None, move |g, _| {
            Ok(g.density(degree, &load, all, order)?)
        })?;
        Ok(array1(py, density))
    }

    #[pyo3(signature = (sigma, test_degree, order, progress=None))]
    fn b_h<'py>(
        &self,
        py: Python<'py>,
        sigma: PyReadonlyArray1<'py, f64>,
        test_degree: usize,
        order: usize,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Three<'py>> {
        self.form(py, Form::B, &sigma, test_degree, order, progress)
    }

    #[pyo3(signature = (sigma, test_degree, order, progress=None))]
    fn a_h<'py>(
        &self,
        py: Python<'py>,
        sigma: PyReadonlyArray1<'py, f64>,
        test_degree: usize,
        order: usize,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Three<'py>> {
        self.form(py, Form::A, &sigma, test_degree, order, progress)
    }

    /// b_h − a_h.
    #[pyo3(signature = (sigma, test_degree, boundary, order, progress=None))]
    fn curvature_jvp<'py>(
        &self,
        py: Python<'py>,
        sigma: PyReadonlyArray1<'py, f64>,
        test_degree: usize,
        boundary: bool,
        order: usize,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Three<'py>> {
        let form = Form::Difference(boundary);
        self.form(py, form, &sigma, test_degree, order, progress)
    }

    /// Its transpose.
    #[pyo3(signature = (weights, test_degree, boundary, order, progress=None))]
    fn curvature_vjp<'py>(
        &self,
        py: Python<'py>,
        weights: PyReadonlyArray1<'py, f64>,
        test_degree: usize,
        boundary: bool,
        order: usize,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Three<'py>> {
        let weights = slice(&weights)?.to_vec();
        let sums = self.run(py, progress, move |g, watch| {
            let sums = g.adjoint(&weights, test_degree, boundary, order, watch)?;
            finite(g, sums, order)
        })?;
        Ok(three(py, sums))
    }

    #[pyo3(signature = (test_degree, order, progress=None))]
    fn einstein<'py>(
        &self,
        py: Python<'py>,
        test_degree: usize,
        order: usize,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Three<'py>> {
        let sums = self.run(py, progress, move |g, watch| {
            finite(g, g.einstein(test_degree, order, watch), order)
        })?;
        Ok(three(py, sums))
    }

    #[pyo3(signature = (order, progress=None))]
    fn action(
        &self,
        py: Python<'_>,
        order: usize,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<[f64; 2]> {
        self.run(py, progress, move |g, watch| Ok(g.action(order, watch)))
    }

    fn action_gradient<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyArray1<f64>>, f64)> {
        let (gradient, schlaefli) = self.run(py, None, |g, _| Ok(g.action_gradient()?))?;
        Ok((array1(py, gradient), schlaefli))
    }

    /// Rows, columns and values, to be added up.
    fn action_hessian<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(
        Bound<'py, PyArray1<i64>>,
        Bound<'py, PyArray1<i64>>,
        Bound<'py, PyArray1<f64>>,
    )> {
        let (rows, columns, values) = self.run(py, None, |g, _| Ok(g.action_hessian()?))?;
        Ok((array1(py, rows), array1(py, columns), array1(py, values)))
    }

    /// Hinges, Θ_S, |S|.
    fn angle_defects<'py>(
        &self,
        py: Python<'py>,
        order: usize,
    ) -> PyResult<(
        Bound<'py, PyArray1<i64>>,
        Bound<'py, PyArray1<f64>>,
        Bound<'py, PyArray1<f64>>,
    )> {
        let (hinges, defects, sizes) = self.run(py, None, move |g, _| Ok(g.defects(order)))?;
        Ok((array1(py, hinges), array1(py, defects), array1(py, sizes)))
    }

    fn cell_volumes<'py>(
        &self,
        py: Python<'py>,
        order: usize,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let volumes = self.run(py, None, move |g, watch| Ok(g.volumes(order, watch)))?;
        Ok(array1(py, volumes))
    }

    /// The canonical degrees of freedom.
    fn canonical<'py>(&self, py: Python<'py>, order: usize) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let g = Arc::clone(&self.inner);
        Ok(array1(
            py,
            job::run(py, None, move |_| Ok(g.canonical(order)))?,
        ))
    }

    /// Norm, parts, steps, solver.
    #[pyo3(signature = (metric, norm, order=None, progress=None))]
    fn error_norm(
        &self,
        py: Python<'_>,
        metric: &Source,
        norm: String,
        order: Option<usize>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<(f64, Vec<(&'static str, f64)>, usize, &'static str)> {
        let metric = metric.kind.clone();
        let order = order.unwrap_or(Rules::default_order(self.inner.degree()));
        let norm = self.run(py, progress, move |g, watch| {
            g.error_norm(&metric, &norm, order, watch)
        })?;
        Ok((norm.total, norm.parts, norm.steps, norm.solver))
    }
}

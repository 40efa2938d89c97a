//! A Regge metric's sums, norm and local curvature, gathered in a report.

use super::local::{cell_integrals, face_integrals};
use super::report::{
    CurvatureReport, FaceJump, HingeDefect, NormError, QuadratureUsed, TestSums, VertexSums,
};
use super::settle::{NORM_SETTLES, SUMS_SETTLE, Settled, relative_change, settle};
use super::smooth::{check_formula, stated_curvature};
use super::{CurvatureError, Request, failed, input};
use crate::input::expression::Expression;
use crate::input::mesh::MeshFile;
use crate::input::metric::FormulaMetric;
use regge::Error;
use regge::functional::{Rules, Sums, angle_defects, distributional_curvature, smooth_curvature};
use regge::lagrange::Lagrange;
use regge::mesh::Mesh;
use regge::norm::HMinus2;
use regge::quadrature::Rule;
use regge::regge::ReggeFunction;
use regge::scalar::Lanes;
use regge::smooth::Smooth;

/// The smooth metric that was interpolated, with its R if that is stated.
pub type Origin<'a, const N: usize> =
    (&'a Smooth<'a, FormulaMetric<'a>, N>, Option<&'a Expression>);

/// A Regge metric and what is asked of it.
pub struct Evaluation<'a, const N: usize> {
    file: &'a MeshFile,
    g_h: &'a ReggeFunction<'a, f64, N>,
    request: &'a Request,
}

impl<'a, const N: usize> Evaluation<'a, N> {
    /// The metric on the mesh of a file.
    pub fn new(
        file: &'a MeshFile,
        g_h: &'a ReggeFunction<'a, f64, N>,
        request: &'a Request,
    ) -> Self {
        Self { file, g_h, request }
    }

    fn mesh(&self) -> &'a Mesh<N> {
        self.g_h.space().mesh()
    }

    /// Everything.
    pub fn report(
        &self,
        interpolant: &str,
        origin: Option<Origin<'_, N>>,
    ) -> Result<CurvatureReport, CurvatureError> {
        let mesh = self.mesh();
        let hats = Lagrange::new(mesh, 1);
        let sums = self.sums(&hats)?;
        let order = sums.order;
        let total = sums.value.total().iter().sum();
        let flat = 4.0 * std::f64::consts::PI * mesh.euler_characteristic() as f64;
        let residual = (N == 2 && mesh.is_closed()).then_some(total - flat);
        Ok(CurvatureReport {
            version: env!("CARGO_PKG_VERSION"),
            mesh: self.file.file.display().to_string(),
            dimension: N,
            cell_count: mesh.cells(),
            closed: mesh.is_closed(),
            degree: self.request.degree,
            interpolant: interpolant.into(),
            quadrature: used(&sums, SUMS_SETTLE),
            boundary: "none",
            total_curvature: total,
            euler_characteristic: mesh.euler_characteristic(),
            gauss_bonnet_residual: residual,
            hm2: self.norm(origin)?,
            vertices: vertex_sums(&hats, &sums.value),
            test_functions: self.test_functions()?,
            hinges: self.hinges(&hats, order),
            faces: self.faces(order),
            cells: cell_integrals(self.g_h, mesh, &Rule::new(N, order)),
        })
    }

    /// The three sums by the order asked for, or by one that is high enough.
    fn sums(&self, space: &Lagrange<'_, N>) -> Result<Settled<Sums<f64>>, CurvatureError> {
        let compute = |order| {
            let rules = Rules::new::<N>(order);
            Ok(distributional_curvature::<Lanes, N, _>(
                self.g_h, space, &rules,
            ))
        };
        let settled = self.settle(SUMS_SETTLE, compute, |a, b| {
            relative_change(entries(a), entries(b))
        });
        let settled = settled.map_err(failed)?;
        let points = Rule::new(N, settled.order);
        self.g_h.check_positive(points.points()).map_err(failed)?;
        let finite = entries(&settled.value).all(|x| x.is_finite());
        match finite {
            true => Ok(settled),
            false => Err(CurvatureError::Failed(
                "a sum is not finite: the metric may be all but degenerate".into(),
            )),
        }
    }

    fn settle<T>(
        &self,
        limit: f64,
        mut compute: impl FnMut(usize) -> Result<T, Error>,
        change: impl Fn(&T, &T) -> f64,
    ) -> Result<Settled<T>, Error> {
        match self.request.quadrature {
            Some(order) => Ok(Settled {
                value: compute(order)?,
                order,
                change: None,
            }),
            None => settle(
                Rules::default_order(self.request.degree),
                limit,
                compute,
                change,
            ),
        }
    }

    /// ‖(Rω)_dist(g_h) − (Rω)(g)‖, if asked for.
    fn norm(&self, origin: Option<Origin<'_, N>>) -> Result<Option<NormError>, CurvatureError> {
        if !self.request.norm {
            return Ok(None);
        }
        let Some((g, exact)) = origin else {
            let reason = "the H^-2 error needs a smooth metric to compare with: give --metric";
            return Err(CurvatureError::Input(reason.into()));
        };
        let degree = self.request.degree + 2;
        let norm = HMinus2::new(self.mesh(), degree).map_err(failed)?;
        let compute = |order| {
            let load = self.load(&norm, g, exact, order);
            if load.iter().any(|f| !f.is_finite()) {
                check_formula(g, &Rule::new(N, order))?;
            }
            norm.norm(&load, None).map(|norm| norm.total())
        };
        let settled = self.settle(NORM_SETTLES, compute, |a, b| {
            relative_change([*a].iter(), [*b].iter())
        });
        let settled = settled.map_err(|error| match error {
            Error::Cell { .. } => input(error),
            error => failed(error),
        })?;
        Ok(Some(NormError {
            error: settled.value,
            degree,
            quadrature: used(&settled, NORM_SETTLES),
        }))
    }

    fn load(
        &self,
        norm: &HMinus2<'_, N>,
        g: &Smooth<'_, FormulaMetric<'_>, N>,
        exact: Option<&Expression>,
        order: usize,
    ) -> Vec<f64> {
        let rules = Rules::new::<N>(order);
        let sums = distributional_curvature::<Lanes, N, _>(self.g_h, norm.space(), &rules);
        let smooth = match exact {
            Some(exact) => stated_curvature(g, exact, norm.space(), &rules.element),
            None => smooth_curvature::<Lanes, N, _>(g, norm.space(), &rules.element),
        };
        let pairs = sums.total().into_iter().zip(smooth);
        pairs.map(|(ours, smooth)| ours - smooth).collect()
    }

    fn test_functions(&self) -> Result<Option<Vec<TestSums>>, CurvatureError> {
        let Some(degree) = self.request.test_degree else {
            return Ok(None);
        };
        let space = Lagrange::new(self.mesh(), degree);
        let sums = self.sums(&space)?.value;
        let of = |dof: usize| {
            let (k, simplex) = space.owner(dof);
            TestSums {
                simplex: self.mesh().vertices(k, simplex).to_vec(),
                element: sums.element[dof],
                face: sums.face[dof],
                hinge: sums.hinge[dof],
                total: sums.element[dof] + sums.face[dof] + sums.hinge[dof],
            }
        };
        let inner = (0..space.len()).filter(|dof| space.vanishes_on_boundary(*dof));
        Ok(Some(inner.map(of).collect()))
    }

    fn hinges(&self, hats: &Lagrange<'_, N>, order: usize) -> Vec<HingeDefect> {
        let all = angle_defects(self.g_h, hats, order).into_iter();
        all.map(|(hinge, defect, volume)| HingeDefect {
            vertices: self.mesh().vertices(N - 2, hinge).to_vec(),
            defect,
            volume,
        })
        .collect()
    }

    fn faces(&self, order: usize) -> Vec<FaceJump> {
        let all = face_integrals(self.g_h, self.mesh(), &Rule::new(N - 1, order)).into_iter();
        all.map(|(face, jump)| FaceJump {
            vertices: self.mesh().vertices(N - 1, face).to_vec(),
            jump,
        })
        .collect()
    }
}

fn entries(sums: &Sums<f64>) -> impl Iterator<Item = &f64> {
    sums.element.iter().chain(&sums.face).chain(&sums.hinge)
}

fn used<T>(settled: &Settled<T>, limit: f64) -> QuadratureUsed {
    QuadratureUsed {
        order: settled.order,
        change: settled.change,
        settled: settled.change.map(|change| change <= limit),
    }
}

/// Hat functions are numbered as the vertices are.
fn vertex_sums<const N: usize>(hats: &Lagrange<'_, N>, sums: &Sums<f64>) -> Vec<VertexSums> {
    let inner = (0..hats.len()).filter(|dof| hats.vanishes_on_boundary(*dof));
    inner
        .map(|vertex| VertexSums {
            vertex,
            element: sums.element[vertex],
            face: sums.face[vertex],
            hinge: sums.hinge[vertex],
            total: sums.element[vertex] + sums.face[vertex] + sums.hinge[vertex],
        })
        .collect()
}

//! A Regge metric's sums, norm and local curvature, gathered in a report.

use super::fields::fields;
use super::given::{Given, Phase, Task};
use super::norm::norm_error;
use super::report::{About, CurvatureReport, VertexSums};
use super::settle::Settled;
use super::simplices::{faces, hinges, is_tested, projected};
use super::sums::{AllSums, sums};
use super::{Boundary, CurvatureError, Request};
use regge_curvature::functional::cell_curvatures;
use regge_curvature::quadrature::Rule;
use regge_curvature::scalar::Lanes;
use regge_curvature::spaces::Lagrange;

/// The whole report.
pub struct Curvature<'a> {
    /// What is asked for.
    pub request: &'a Request,
    /// Is told what begins.
    pub phase: Phase<'a>,
}

impl Task for Curvature<'_> {
    type Output = CurvatureReport;

    fn run<const N: usize>(&self, given: &Given<'_, N>) -> Result<CurvatureReport, CurvatureError> {
        let (request, mesh) = (self.request, given.g_h.space().mesh());
        let hats = Lagrange::new(mesh, 1);
        (self.phase)("summing the curvature");
        let sums = sums(given.g_h, &hats, request.quadrature, request.boundary)?;
        let mut report = self.head(given, &sums);
        report.vertices = vertex_sums(&hats, &sums.value, request.boundary);
        if let Some(name) = request.norm {
            (self.phase)("solving for the norm");
            report.norms.insert(name, norm_error(given, request, name)?);
        }
        if request.details || request.fields {
            (self.phase)("projecting the curvature");
            let (r_h, tested) = projected(given.g_h, &sums.value, request, sums.order)?;
            (report.r_h, report.test_functions) = (Some(r_h), tested);
        }
        (self.phase)("integrating simplex by simplex");
        let rule = Rule::new(N, sums.order);
        let cells = || cell_curvatures::<Lanes, N, _>(given.g_h, mesh, &rule);
        if request.details {
            report.hinges = Some(hinges(given.g_h, &hats, sums.order));
            report.faces = Some(faces(given.g_h, sums.order));
            report.cells = Some(cells());
        }
        if request.fields {
            report.fields = Some(fields(given, &report, &hats, &rule));
        }
        Ok(report)
    }
}

impl Curvature<'_> {
    /// What is said of the whole.
    fn head<const N: usize>(
        &self,
        given: &Given<'_, N>,
        sums: &Settled<AllSums>,
    ) -> CurvatureReport {
        let mesh = given.g_h.space().mesh();
        let total = sums.value.total().iter().sum();
        let flat = 4.0 * std::f64::consts::PI * mesh.euler_characteristic() as f64;
        let complete = mesh.is_closed() || self.request.boundary == Boundary::GaussBonnet;
        CurvatureReport {
            about: About::of(given, sums),
            cell_count: mesh.cell_count(),
            closed: mesh.is_closed(),
            boundary: match self.request.boundary {
                Boundary::None => "none",
                Boundary::GaussBonnet => "gauss-bonnet",
            },
            total_curvature: total,
            euler_characteristic: mesh.euler_characteristic(),
            gauss_bonnet_residual: (N == 2 && complete).then_some(total - flat),
            physical_groups: given.file.groups.clone(),
            ..CurvatureReport::default()
        }
    }
}

/// Hat functions are numbered as the vertices are.
fn vertex_sums<const N: usize>(
    hats: &Lagrange<N>,
    sums: &AllSums,
    boundary: Boundary,
) -> Vec<VertexSums> {
    let tested = is_tested(hats, boundary);
    let all = sums.parts().into_iter().enumerate();
    all.filter(|(vertex, _)| tested(vertex))
        .map(|(vertex, sums)| VertexSums { vertex, sums })
        .collect()
}

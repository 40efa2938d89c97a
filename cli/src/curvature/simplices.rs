//! The curvature simplex by simplex, and as a function: hinges, faces, test functions, R_h.

use super::given::Given;
use super::report::{FaceJump, HingeDefect, Projected, ProjectedCurvature, TestSums};
use super::settle::Settled;
use super::sums::{AllSums, Evaluation, Tests};
use super::{Boundary, CurvatureError, Request, failed};
use regge_curvature::functional::{Sums, angle_defects};
use regge_curvature::project::{Projection, Tested};
use regge_curvature::quadrature::Rule;
use regge_curvature::spaces::{Indicators, Lagrange};

/// Θ_S and |S| of the interior hinges.
pub fn hinges<const N: usize>(given: &Given<'_, N>, order: usize) -> Vec<HingeDefect> {
    let mesh = given.g_h.space().mesh();
    let all = angle_defects(&given.g_h, mesh, order).into_iter();
    all.map(|one| HingeDefect {
        vertices: mesh.vertices(N - 2, one.hinge).to_vec(),
        defect: one.defect,
        volume: one.size,
    })
    .collect()
}

/// ∫R of the cells.
pub fn cells<const N: usize>(each: &Indicators<N>, sums: &Sums<f64>) -> Vec<f64> {
    sums.cells[each.range(0)].to_vec()
}

/// ∫⟦H⟧ of the interior faces, which are half of what they contribute to the sum over faces.
pub fn faces<const N: usize>(
    given: &Given<'_, N>,
    each: &Indicators<N>,
    sums: &Sums<f64>,
) -> Vec<FaceJump> {
    let (jumps, mesh) = (&sums.faces[each.range(1)], given.g_h.space().mesh());
    let all = mesh.interior_faces();
    all.map(|face| FaceJump {
        vertices: mesh.vertices(N - 1, face).to_vec(),
        jump: 0.5 * jumps[face],
    })
    .collect()
}

/// Which test functions are used?
pub fn is_tested<const N: usize>(
    space: &Lagrange<N>,
    boundary: Boundary,
) -> impl Fn(&usize) -> bool {
    move |dof| boundary == Boundary::GaussBonnet || space.vanishes_on_boundary(*dof)
}

/// The sums for every test function of a space.
pub fn test_sums<const N: usize>(
    space: &Lagrange<N>,
    sums: &AllSums,
    boundary: Boundary,
) -> Vec<TestSums> {
    let tested = is_tested(space, boundary);
    let all = sums.parts().into_iter().enumerate();
    all.filter(|(dof, _)| tested(dof))
        .map(|(dof, sums)| {
            let (k, simplex) = space.owner(dof);
            TestSums {
                simplex: space.mesh().vertices(k, simplex).to_vec(),
                sums,
            }
        })
        .collect()
}

/// R_h^(q), with its sums if they were asked for. It is the paper's: the projection of the interior's measures onto functions that
/// vanish on the boundary, whatever is added up there.
pub fn projected<const N: usize>(
    given: &Given<'_, N>,
    tests: &Tests<'_, N>,
    settled: &Settled<Evaluation>,
    request: &Request,
) -> Result<(ProjectedCurvature, Option<Vec<TestSums>>), CurvatureError> {
    let space = tests.finer.as_ref().unwrap_or(&tests.hats);
    let value = &settled.value;
    let sums = value.finer.as_ref().unwrap_or(&value.hats);
    let degree = space.degree();
    // The product of two test functions at the least.
    let rule = Rule::new(N, settled.order.max(2 * degree));
    let projection = Projection::new(&given.g_h, space, Tested::Interior, &rule);
    let projected = projection.and_then(|projection| projection.apply(&sums.inner.total()));
    let coefficients = projected.map_err(failed)?;
    let list = coefficients.iter().enumerate().map(|(dof, &value)| {
        let (k, simplex) = space.owner(dof);
        Projected {
            simplex: space.mesh().vertices(k, simplex).to_vec(),
            value,
        }
    });
    let projected = ProjectedCurvature {
        degree,
        coefficients: list.collect(),
    };
    let asked = request.test_degree.is_some();
    Ok((
        projected,
        asked.then(|| test_sums(space, sums, request.boundary)),
    ))
}

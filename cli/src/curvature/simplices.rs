//! The curvature simplex by simplex, and as a function: hinges, faces, test functions, R_h.

use super::report::{FaceJump, HingeDefect, Projected, ProjectedCurvature, TestSums};
use super::sums::{AllSums, sums};
use super::{Boundary, CurvatureError, Request, failed};
use regge_curvature::functional::{angle_defects, face_jumps};
use regge_curvature::project::{Projection, Tested};
use regge_curvature::quadrature::Rule;
use regge_curvature::scalar::Lanes;
use regge_curvature::spaces::Lagrange;
use regge_curvature::spaces::ReggeFunction;

/// Θ_S and |S| of the interior hinges.
pub fn hinges<const N: usize>(
    g_h: &ReggeFunction<f64, N>,
    hats: &Lagrange<N>,
    order: usize,
) -> Vec<HingeDefect> {
    let mesh = hats.mesh();
    let all = angle_defects(g_h, hats, order).into_iter();
    all.map(|(hinge, defect, volume)| HingeDefect {
        vertices: mesh.vertices(N - 2, hinge).to_vec(),
        defect,
        volume,
    })
    .collect()
}

/// ∫⟦H⟧ of the interior faces.
pub fn faces<const N: usize>(g_h: &ReggeFunction<f64, N>, order: usize) -> Vec<FaceJump> {
    let mesh = g_h.space().mesh();
    let rule = Rule::new(N - 1, order);
    let all = face_jumps::<Lanes, N, _>(g_h, mesh, &rule).into_iter();
    all.map(|(face, jump)| FaceJump {
        vertices: mesh.vertices(N - 1, face).to_vec(),
        jump,
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

/// R_h^(q), with its sums if they were asked for.
pub fn projected<const N: usize>(
    g_h: &ReggeFunction<f64, N>,
    hats: &AllSums,
    request: &Request,
    order: usize,
) -> Result<(ProjectedCurvature, Option<Vec<TestSums>>), CurvatureError> {
    let degree = request.test_degree.unwrap_or(1);
    let space = Lagrange::new(g_h.space().mesh(), degree);
    let finer = match degree {
        1 => None,
        _ => Some(sums(g_h, &space, request.quadrature, request.boundary)?.value),
    };
    let sums = finer.as_ref().unwrap_or(hats);
    let tested = match request.boundary {
        Boundary::None => Tested::Interior,
        Boundary::GaussBonnet => Tested::All,
    };
    // The product of two test functions at the least.
    let rule = Rule::new(N, order.max(2 * degree));
    let projection = Projection::new(g_h, &space, tested, &rule).map_err(failed)?;
    let coefficients = projection.apply(&sums.total());
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
        asked.then(|| test_sums(&space, sums, request.boundary)),
    ))
}

//! A Regge metric's sums, norm and local curvature, gathered in a report.

use super::enclosed::enclosures;
use super::everywhere::everywhere;
use super::fields::fields;
use super::given::{Given, Phase};
use super::norm::Norm;
use super::report::{About, CurvatureReport, OnSurface, ProjectedCurvature, VertexSums};
use super::settle::{Orders, Settled, settle_sums};
use super::simplices::{cells, faces, hinges, is_tested, projected};
use super::smooth::check_formula;
use super::sums::{Evaluation, Tests};
use super::{Boundary, CurvatureError, Request, topology};
use regge_curvature::density::Volume;
use regge_curvature::field::Evaluate;
use regge_curvature::functional::{Rules, integrate};
use regge_curvature::linalg::inverse_and_det;
use regge_curvature::quadrature::Rule;
use regge_curvature::spaces::{Indicators, Lagrange};

/// What is said where R_h is, and there is a boundary.
const OVERSHOOT: &str = "is the projection of the interior's curvature: it vanishes on the boundary and overshoots beside it \
    (docs/surfaces.md)";

/// The whole report. The curvature is evaluated once for each order of quadrature, whatever is asked for.
pub fn report<const N: usize>(
    given: &Given<'_, N>,
    request: &Request,
    phase: Phase<'_>,
) -> Result<CurvatureReport, CurvatureError> {
    let mesh = given.g_h.space().mesh();
    let norm = match request.norm {
        Some(name) => {
            phase("setting up the norm");
            Some((
                name,
                Norm::new(given, request.degree, name, request.trust_stated)?,
            ))
        }
        None => None,
    };
    let each = request.details || request.fields;
    let finer = request.test_degree.filter(|q| each && *q > 1);
    let tests = Tests {
        hats: Lagrange::new(mesh, 1),
        finer: finer.map(|q| Lagrange::new(mesh, q)),
        simplices: each.then(|| Indicators::new(mesh)),
        norm: norm.as_ref().map(|(_, norm)| &*norm.norm),
        boundary: request.boundary == Boundary::GaussBonnet,
    };
    let sums = evaluate(
        given,
        request,
        &tests,
        norm.as_ref().map(|(_, norm)| norm),
        phase,
    )?;
    let mut report = head(given, request, &sums);
    if let Some((name, norm)) = &norm {
        phase("solving for the norm");
        report.norms.insert(name, norm.of(&sums, phase)?);
    }
    if each || request.table {
        phase("projecting the curvature");
        let (r_h, tested) = projected(given, &tests, &sums, request)?;
        (report.r_h, report.test_functions) = (Some(r_h), tested);
        if !mesh.is_closed() {
            // Gauss curvature is a surface's.
            let projected = if N == 2 { "R_h, and K = R_h/2," } else { "R_h" };
            report.about.notes.push(format!("{projected} {OVERSHOOT}"));
        }
    }
    report.vertices = vertex_sums(given, &tests.hats, &sums, report.r_h.as_ref(), request);
    if each {
        phase("integrating simplex by simplex");
        simplex_by_simplex(given, request, &tests, &sums, &mut report);
    }
    // Curved cells have a degree of their own.
    match (request.certified, given.g_h.space().degree()) {
        (false, _) => {}
        (true, 0) => report.enclosures = Some(enclosures(given, phase)?),
        (true, _) => report.everywhere = Some(everywhere(given, phase)?),
    }
    Ok(report)
}

/// By the order asked for, or by rising ones.
fn evaluate<const N: usize>(
    given: &Given<'_, N>,
    request: &Request,
    tests: &Tests<'_, N>,
    norm: Option<&Norm<'_, N>>,
    phase: Phase<'_>,
) -> Result<Settled<Evaluation>, CurvatureError> {
    let smooth = |rules: &Rules| norm.map_or(Vec::new(), |norm| norm.smooth_load(rules));
    let orders = match norm {
        // The curvature of the smooth metric is no polynomial, whatever g_h is.
        Some(_) => Orders::From(Rules::default_order(request.degree)),
        None => Orders::of(&given.g_h, tests.degree()),
    };
    settle_sums(&given.g_h, request.quadrature, orders, &mut |order| {
        phase(&format!("summing the curvature by rules of order {order}"));
        let evaluation = tests.evaluate(&given.g_h, &smooth, &Rules::new(N, order));
        let load = evaluation.load.iter().flatten();
        if let (Some(norm), false) = (norm, load.copied().all(f64::is_finite)) {
            check_formula(&norm.origin.metric, &Rule::new(N, order))?;
        }
        Ok(evaluation)
    })
}

/// Adds what single simplices have.
fn simplex_by_simplex<const N: usize>(
    given: &Given<'_, N>,
    request: &Request,
    tests: &Tests<'_, N>,
    sums: &Settled<Evaluation>,
    report: &mut CurvatureReport,
) {
    let each = tests.simplices.as_ref().zip(sums.value.simplices.as_ref());
    let (simplices, values) = each.expect("simplices are evaluated where they are asked for");
    let cells = cells(simplices, values);
    if request.details {
        report.hinges = Some(hinges(given, sums.order));
        report.faces = Some(faces(given, simplices, values));
    }
    if request.fields {
        let rules = Rules::new(N, sums.order);
        report.fields = Some(fields(given, report, &rules, cells.clone()));
    }
    if request.details {
        report.cells = Some(cells);
    }
}

/// What is said of the whole.
fn head<const N: usize>(
    given: &Given<'_, N>,
    request: &Request,
    sums: &Settled<Evaluation>,
) -> CurvatureReport {
    let mesh = given.g_h.space().mesh();
    let totals = sums.value.hats.total();
    let total = totals.iter().sum();
    let residual = |closed: bool, total: f64, chi: i64| {
        let complete = closed || request.boundary == Boundary::GaussBonnet;
        (N == 2 && complete).then_some(total - 4.0 * std::f64::consts::PI * chi as f64)
    };
    let mut pieces = topology::pieces(mesh, &totals);
    for piece in &mut pieces {
        let (total, chi) = (piece.total_curvature, piece.euler_characteristic);
        piece.gauss_bonnet_residual = residual(piece.closed, total, chi);
    }
    CurvatureReport {
        about: About::of(given, sums),
        cell_count: mesh.cell_count(),
        closed: mesh.is_closed(),
        boundary: match request.boundary {
            Boundary::None => "none",
            Boundary::GaussBonnet => "gauss-bonnet",
        },
        total_curvature: total,
        euler_characteristic: mesh.euler_characteristic(),
        gauss_bonnet_residual: residual(mesh.is_closed(), total, mesh.euler_characteristic()),
        pieces,
        physical_groups: given.file.groups.clone(),
        ..CurvatureReport::default()
    }
}

/// Hat functions are numbered as the vertices are.
fn vertex_sums<const N: usize>(
    given: &Given<'_, N>,
    hats: &Lagrange<N>,
    sums: &Settled<Evaluation>,
    r_h: Option<&ProjectedCurvature>,
    request: &Request,
) -> Vec<VertexSums> {
    let tested = is_tested(hats, request.boundary);
    let areas = (N == 2).then(|| vertex_volumes(given, hats, &Rules::new(N, sums.order.max(1))));
    let surface = |vertex: usize, total: f64| {
        let inside = hats.vanishes_on_boundary(vertex);
        areas.as_ref().map(|areas| OnSurface {
            area: areas[vertex],
            k_integral: 0.5 * total,
            // The coefficients of the vertices come first, and are the values there.
            k: r_h
                .filter(|_| inside)
                .map(|r_h| 0.5 * r_h.coefficients[vertex].value),
        })
    };
    let all = sums.value.hats.parts().into_iter().enumerate();
    all.filter(|(vertex, _)| tested(vertex))
        .map(|(vertex, sums)| VertexSums {
            vertex,
            surface: surface(vertex, sums.total),
            sums,
        })
        .collect()
}

/// ∫ φ ω of every hat function.
fn vertex_volumes<const N: usize>(
    given: &Given<'_, N>,
    hats: &Lagrange<N>,
    rules: &Rules,
) -> Vec<f64> {
    let (g, rule) = (&given.g_h, &rules.cells);
    let table = Evaluate::<f64, N>::tabulate(g, rule.points());
    let cells = 0..hats.mesh().cell_count();
    integrate(hats, N, rule, cells, |cell, _, q| {
        let local = Evaluate::<f64, N>::on_cell(g, cell);
        let (_, det) = inverse_and_det(&g.value(&local, &table, q));
        Volume::from_det(det)
    })
}

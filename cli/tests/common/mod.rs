//! What several test files share.

pub mod files;
pub mod schema;

use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Metric;
use regge_study::{Case, ProjectionKind, Quadrature, Quantity, Row, Study};
use std::ops::RangeInclusive;

/// The seed that the command line uses unless told otherwise.
pub const SEED: u64 = 3;

/// The paper's metric with converged quadrature, averaged as the paper's program averaged.
pub fn study(dimension: usize, degrees: &[usize], levels: RangeInclusive<u32>) -> Study {
    let of_degree = |&degree: &usize| levels.clone().map(move |level| Case { degree, level });
    Study {
        metric: Metric::GraphQuartic,
        dimension,
        quantity: Quantity::CurvatureError,
        interpolants: vec![Interpolant::average_hierarchical()],
        projection: ProjectionKind::Exact,
        quadrature: Quadrature::CONVERGED,
        seed: SEED,
        cases: degrees.iter().flat_map(of_degree).collect(),
    }
}

/// As the paper's program integrated.
pub fn as_printed(study: Study) -> Study {
    Study {
        projection: ProjectionKind::Discrete,
        quadrature: Quadrature::AS_PRINTED,
        ..study
    }
}

pub fn rows(study: &Study) -> Vec<Row> {
    study
        .run(&mut |_| ())
        .expect("a study that can be computed")
}

pub fn errors(study: &Study) -> Vec<f64> {
    rows(study).iter().map(|row| row.error).collect()
}

/// Are these the expected numbers, relatively?
pub fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        assert!(
            (a / b - 1.0).abs() <= tolerance,
            "{a} is not {b} to {tolerance:e}"
        );
    }
}

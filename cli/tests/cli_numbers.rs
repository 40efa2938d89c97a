//! What `reproduce` computes, against the printed numbers and against rows known from elsewhere.
//!
//! The rows of level 0 have no random mesh. Their values with converged quadrature were computed by an unrelated
//! program (NGSolve with ngsdiffgeo); those "as printed" are the paper's.

use crate::common::{as_printed, assert_close, errors, rows, study};
use regge_curvature::interpolate::Interpolant;
use regge_study::{ProjectionKind, Quantity, Row, Study};

#[test]
fn level_zero_with_converged_quadrature() {
    let n2 = errors(&study(2, &[0, 1, 2], 0..=0));
    assert_close(&n2, &[0.191182259, 0.100434416, 0.022599146], 1e-6);
    assert_close(&errors(&study(3, &[0], 0..=0)), &[0.1016332381], 1e-6);
    let canonical = Study {
        interpolants: vec![Interpolant::canonical()],
        ..study(3, &[0, 1], 0..=0)
    };
    assert_close(&errors(&canonical), &[0.4723269878, 0.1039803360], 1e-6);
}

#[test]
fn the_two_averages_agree_on_level_zero() {
    let both = vec![Interpolant::average(), Interpolant::average_hierarchical()];
    let found = errors(&Study {
        interpolants: both,
        ..study(2, &[0, 1, 2], 0..=0)
    });
    for pair in found.chunks(2) {
        assert_close(&pair[..1], &pair[1..], 1e-12);
    }
}

/// The norm by the paper's order 5 is not the exact one where u has degree 4, but nearly.
#[test]
fn the_order_of_the_norm_matters_little() {
    let mut exact = study(2, &[2], 0..=0);
    exact.quadrature.norm = Some(8);
    assert_close(&errors(&exact), &[0.0226024145], 1e-6);
}

#[test]
fn level_zero_as_printed() {
    let n2 = errors(&as_printed(study(2, &[0, 1, 2], 0..=0)));
    assert_close(&n2[..2], &[0.2237456094093, 0.0861267946607], 1e-9);
    // The original's rule of order 8 is not symmetric, and this one is its like, not itself.
    assert_close(&n2[2..], &[0.0271990483398], 1e-3);
    assert_close(
        &errors(&as_printed(study(3, &[0], 0..=0))),
        &[0.0786894677],
        1e-8,
    );
}

fn ratio(row: &Row) -> f64 {
    row.error / row.printed.expect("a printed error")
}

/// Random meshes, and not those of the paper: its own program scatters by up to 8 % from k = 4 on.
#[test]
fn table_1_as_printed() {
    let found = rows(&as_printed(study(2, &[0, 1, 2], 0..=7)));
    assert_eq!(found.len(), 24);
    for row in &found {
        let order = row.order.unwrap_or(0.0);
        assert!(row.level < 4 || (ratio(row) - 1.0).abs() < 0.12, "{row:?}");
        assert!(
            row.level < 5 || (order - (row.degree + 1) as f64).abs() < 0.15,
            "{row:?}"
        );
    }
}

/// The exact projection makes r = 1 about 2.4 times smaller and r = 2 about 10 % larger.
#[test]
fn table_1_converged() {
    let both = vec![Interpolant::average_hierarchical(), Interpolant::average()];
    let found = rows(&Study {
        interpolants: both,
        ..study(2, &[1, 2], 4..=5)
    });
    let expected = [1.0 / 2.4, 1.0 / 2.6, 1.10, 0.77];
    for (index, row) in found.iter().enumerate() {
        let expected = expected[index % 2 + 2 * (row.degree - 1)];
        assert!(
            (ratio(row) / expected - 1.0).abs() < 0.12,
            "{expected}: {row:?}"
        );
    }
}

#[test]
fn table_2_as_printed() {
    for row in rows(&as_printed(study(3, &[0, 1, 2], 2..=3))) {
        assert!((ratio(&row) - 1.0).abs() < 0.2, "{row:?}");
    }
}

#[test]
fn figure_2() {
    let both = vec![
        Interpolant::average_hierarchical(),
        Interpolant::canonical(),
    ];
    let critical = |study: Study| Study {
        quantity: Quantity::CriticalTerm,
        interpolants: both.clone(),
        ..study
    };
    let mut found = rows(&critical(study(3, &[0, 1], 1..=3)));
    found.extend(rows(&critical(study(3, &[2], 1..=2))));
    for row in found {
        let allowed = if row.level == 3 { 0.8..1.2 } else { 0.5..2.0 };
        assert!(allowed.contains(&ratio(&row)), "{row:?}");
    }
    // The canonical interpolant of this metric on the six tetrahedra is the constant α δ + β 11ᵀ for r = 0, and Θ = 0 at the one
    // interior edge; for r = 1 the same is seen. With the hyperbolic metric the term is 2.9e-3 there.
    let zero = rows(&critical(study(3, &[0, 1], 0..=0)));
    assert!(zero.iter().skip(1).step_by(2).all(|row| row.error < 1e-14));
}

/// The averaged curve for r = 1 is that of the discrete local projection, with functional and norm converged: over the
/// seeds 1 to 10 the ratio to the plotted value is 0.97–1.09, with the exact projection 1.19–1.28.
#[test]
fn figure_2_rests_on_the_discrete_projection() {
    for seed in [2, 4] {
        let of = |projection: ProjectionKind| {
            let study = Study {
                quantity: Quantity::CriticalTerm,
                projection,
                seed,
                ..study(3, &[1], 3..=3)
            };
            ratio(&rows(&study)[0])
        };
        let (exact, discrete) = (of(ProjectionKind::Exact), of(ProjectionKind::Discrete));
        assert!((0.9..1.12).contains(&discrete), "seed {seed}: {discrete}");
        assert!((1.15..1.32).contains(&exact), "seed {seed}: {exact}");
    }
}

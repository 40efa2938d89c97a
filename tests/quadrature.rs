//! Every rule against the moments that it must get right, and against one that it need not.

use regge_curvature::quadrature::{Rule, gauss_legendre};
use regge_curvature::simplex::{factorial, multi_indices};

/// ∫ λ^α dμ = α! / (|α| + dim)! on the reference simplex.
fn moment(alpha: &[usize]) -> f64 {
    let dim = alpha.len() - 1;
    alpha.iter().map(|&a| factorial(a)).product::<f64>()
        / factorial(alpha.iter().sum::<usize>() + dim)
}

fn error(rule: &Rule, alpha: &[usize]) -> f64 {
    let value: f64 = (0..rule.len())
        .map(|q| {
            let powers = rule.points().lambda(q).iter().zip(alpha);
            rule.weights()[q] * powers.map(|(l, &a)| l.powi(a as i32)).product::<f64>()
        })
        .sum();
    (value - moment(alpha)).abs()
        / moment(&{
            let mut constant = vec![0; alpha.len()];
            constant[0] = alpha.iter().sum();
            constant
        })
}

/// Positive weights, points inside, all moments to the rule's order: to 1e-13 of the largest moment of the degree.
#[test]
fn rules_are_positive_and_exact() {
    for (dim, largest) in [(1, 41), (2, 34), (3, 20), (4, 10), (5, 7)] {
        for order in 0..=largest {
            let rule = Rule::new(dim, order);
            assert!(
                rule.weights().iter().all(|w| *w > 0.0),
                "dim {dim}, order {order}"
            );
            for q in 0..rule.len() {
                let lambda = rule.points().lambda(q);
                assert!(
                    lambda.iter().all(|l| (0.0..=1.0).contains(l)),
                    "dim {dim}, order {order}"
                );
                assert!((lambda.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            }
            // The highest degrees are the hardest; the lower ones follow from them by Σ λ = 1.
            for alpha in multi_indices(dim + 1, order) {
                let error = error(&rule, &alpha);
                assert!(
                    error < 1e-13,
                    "dim {dim}, order {order}, {alpha:?}: {error:e}"
                );
            }
        }
    }
}

/// The test above can fail: far beyond its order a rule is wrong.
#[test]
fn rules_are_not_exact_beyond_their_order() {
    for (dim, order) in [(1, 4), (2, 4), (3, 4), (4, 4)] {
        let mut alpha = vec![0; dim + 1];
        alpha[0] = 2 * order + 6;
        assert!(error(&Rule::new(dim, order), &alpha) > 1e-6, "dim {dim}");
    }
}

/// Gauss' rule with three points: 1/2, 1/2 ± √15/10, weights 4/9 and 5/18 (any table).
#[test]
fn gauss_with_three_points() {
    let (t, w) = gauss_legendre(3);
    let x = 15f64.sqrt() / 10.0;
    for (ours, known) in t.iter().zip([0.5 - x, 0.5, 0.5 + x]) {
        assert!((ours - known).abs() < 1e-15);
    }
    for (ours, known) in w.iter().zip([5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0]) {
        assert!((ours - known).abs() < 1e-15);
    }
}

use super::*;
use num_dual::Dual64;
use regge_curvature::jet::{Jet1, Jet2};

fn value(text: &str) -> f64 {
    let formula = Expression::parse(text, 2).unwrap_or_else(|e| panic!("{text}: {e}"));
    formula.at(&[3.0, -2.0])
}

#[test]
fn precedence_is_that_of_mathematics() {
    for (text, expected) in [
        ("-x^2", -9.0),
        ("(-x)^2", 9.0),
        ("2^3^2", 512.0),
        ("2^-1", 0.5),
        ("-2^-2", -0.25),
        ("2-3-4", -5.0),
        ("2/4/2", 0.25),
        ("2+3*4", 14.0),
        ("2*-3", -6.0),
        ("--x", 3.0),
        ("+x - +y", 5.0),
        ("y^3", -8.0),
        ("y^-3", -0.125),
        ("y^(1+1)", 4.0),
        ("x2 + x1", 1.0),
        ("1.5e1 + .5", 15.5),
        ("2E-1*10", 2.0),
        ("abs(y)", 2.0),
        ("log(e)", 1.0),
        ("y^0", 1.0),
    ] {
        assert_eq!(value(text), expected, "{text}");
    }
}

#[test]
fn functions_are_the_usual_ones() {
    let close = |text: &str, expected: f64| {
        // Compositions of correctly rounded steps.
        assert!(
            (value(text) - expected).abs() < 1e-14 * expected.abs().max(1.0),
            "{text}"
        );
    };
    close("sin(pi/6)", 0.5);
    close("cos(x)", 3f64.cos());
    close("tan(x)", 3f64.tan());
    close("exp(y)", (-2f64).exp());
    close("ln(x)", 3f64.ln());
    close("sqrt(x)", 3f64.sqrt());
    close("sinh(y)", (-2f64).sinh());
    close("cosh(y)", (-2f64).cosh());
    close("tanh(y)", (-2f64).tanh());
    close("tanh(1000)", 1.0);
    close("tanh(-1000)", -1.0);
    close("atan(x)", 3f64.atan());
    close("x^2.5", 3f64.powf(2.5));
    close("x^y", 1.0 / 9.0);
}

/// f = x^3 y + sin(x y): ∂_x∂_y f = 3x² + cos(xy) − xy sin(xy), by jets, by jets of jets, by dual numbers.
#[test]
fn derivatives_are_exact_at_every_scalar() {
    let formula = Expression::parse("x^3*y + sin(x*y)", 2).expect("a formula");
    let (x, y) = (0.7, -1.3);
    let mixed = 3.0 * x * x + (x * y).cos() - x * y * (x * y).sin();
    let jet = formula.at(&[Jet2::<f64, 2>::coordinate(x, 0), Jet2::coordinate(y, 1)]);
    assert!((jet.dd[0][1] - mixed).abs() < 1e-14);
    let inner = |value, m| Jet1::<f64, 2>::coordinate(value, m);
    let nested = formula.at(&[
        Jet1::<_, 2>::coordinate(inner(x, 0), 0),
        Jet1::coordinate(inner(y, 1), 1),
    ]);
    assert!((nested.d[0].d[1] - mixed).abs() < 1e-14);
    let dual = formula.at(&[Dual64::new(x, 1.0), Dual64::new(y, 0.0)]);
    assert!((dual.eps - (3.0 * x * x * y + y * (x * y).cos())).abs() < 1e-14);
}

#[test]
fn a_whole_power_has_derivatives_at_zero() {
    let formula = Expression::parse("x^2", 2).expect("a formula");
    let jet = formula.at(&[Jet2::<f64, 2>::coordinate(0.0, 0), Jet2::coordinate(0.0, 1)]);
    assert_eq!((jet.value, jet.d[0], jet.dd[0][0]), (0.0, 0.0, 2.0));
}

#[test]
fn what_is_no_formula_is_refused_at_its_column() {
    for (text, column, expected) in [
        ("", 1, "ends"),
        ("1 +", 4, "ends"),
        ("2x", 2, "operator is missing"),
        ("x + sine(y)", 5, "'sin'"),
        ("x3", 1, "'x'"),
        ("z", 1, "dimension 2"),
        ("(x", 3, "closing"),
        ("x)", 2, "never opened"),
        ("sin x", 5, "sin(…)"),
        ("sin(x, y)", 6, "one argument"),
        ("x ** 2", 3, "^"),
        ("* x", 1, "not '*'"),
        ("1.2.3", 1, "no number"),
        ("1e999", 1, "too large"),
        ("x $ y", 3, "'$'"),
        ("é", 1, "unknown"),
        ("2e", 2, "operator is missing"),
    ] {
        let error = Expression::parse(text, 2).expect_err(text);
        assert_eq!(error.column, column, "{text}: {error}");
        assert!(error.reason.contains(expected), "{text}: {error}");
        assert_eq!(error.to_string().lines().count(), 1);
    }
}

#[test]
fn depth_and_length_are_limited() {
    for opening in ["(", "-", "2^", "sin(", "+"] {
        let error = Expression::parse(&opening.repeat(3000), 2).expect_err("too deep");
        assert!(error.reason.contains("levels deep"), "{opening}: {error}");
    }
    let allowed = format!("{}x{}", "(".repeat(90), ")".repeat(90));
    assert!(Expression::parse(&allowed, 2).is_ok());
    let long = vec!["x"; 5000].join("+");
    assert_eq!(
        Expression::parse(&long, 2).expect("long").at(&[1.0, 0.0]),
        5000.0
    );
    let error = Expression::parse(&"x+".repeat(10_000), 2).expect_err("too long");
    assert!(error.reason.contains("bytes"), "{error}");
}

use super::function::FUNCTIONS;
use super::*;
use num_dual::Dual64;
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::scalar::{Lanes, Real};

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
        ("x3", 1, "x1, x2"),
        ("z", 1, "dimension 2"),
        ("(x", 3, "closing"),
        ("x)", 2, "never opened"),
        ("sin x", 5, "sin(a)"),
        ("sin(x, y)", 6, "sin(a)"),
        ("(x, y)", 3, "comma"),
        ("pow(x)", 6, "pow(a, b)"),
        ("pow(x, y, y)", 9, "pow(a, b)"),
        ("atan2(x)", 8, "atan2(a, b)"),
        ("max(x)", 6, "max(a, b, ...)"),
        ("max(x, y", 9, "closing"),
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
    // 200 KB.
    let long = vec!["x"; 100_000].join("+");
    assert_eq!(
        Expression::parse(&long, 2).expect("long").at(&[1.0, 0.0]),
        1e5
    );
    let error = Expression::parse(&"x+".repeat(600_000), 2).expect_err("too long");
    assert!(error.reason.contains("bytes"), "{error}");
}

/// The inverse functions against those of the standard library, on both sides of their kinks.
#[test]
fn functions_of_one_and_two_arguments() {
    let close = |text: &str, expected: f64| {
        // Compositions of a few correctly rounded steps.
        let found = value(text);
        let error = (found - expected).abs();
        assert!(
            error < 2e-15 * expected.abs().max(1.0),
            "{text}: {found} {expected}"
        );
    };
    for a in [-0.9f64, -1e-9, 0.0, 0.3, 0.999_999] {
        close(&format!("asin({a})"), a.asin());
        close(&format!("acos({a})"), a.acos());
        close(&format!("atanh({a})"), a.atanh());
        close(&format!("tanh(atanh({a}))"), a);
    }
    for a in [-1e200f64, -1e8, -2.0, 0.0, 1e-3, 5.0, 1e200] {
        close(&format!("asinh({a:e})"), a.asinh());
        close(&format!("abs({a:e})"), a.abs());
        close(
            &format!("acosh({:e})", 1.0 + a.abs()),
            (1.0 + a.abs()).acosh(),
        );
    }
    // By the logarithm, whose size multiplies rounding.
    close("cbrt(-27)", -3.0);
    close("cbrt(8)", 2.0);
    close("cbrt(0)", 0.0);
    close("log10(1000)", 3.0);
    close("log2(8)", 3.0);
    close("pow(x, 2)", 9.0);
    close("pow(y, 3)", -8.0);
    close("pow(x, 0.5)", 3f64.sqrt());
    close("atan2(y, x)", (-2f64).atan2(3.0));
    close("atan2(y, -x)", (-2f64).atan2(-3.0));
    close("atan2(0, -1)", std::f64::consts::PI);
    close("hypot(x, 4)", 5.0);
    close("hypot(3e200, 4e200)/1e200", 5.0);
    close("hypot(0, 0)", 0.0);
    close("min(x, y, 0)", -2.0);
    close("max(x, y, 0)", 3.0);
    close("min(1, 1e-20)*1e20", 1.0);
    close("sign(y) + 10*sign(x) + 100*sign(x - 3)", 9.0);
    for text in [
        "asin(2)",
        "acos(-2)",
        "acosh(0)",
        "atanh(2)",
        "max(0/0, 1)",
        "abs(0/0)",
        "sign(0/0)",
    ] {
        assert!(value(text).is_nan(), "{text}");
    }
}

/// Every function against difference quotients of its own values, and by lanes: their second derivatives along a line.
#[test]
fn derivatives_of_all_functions_are_right_for_all_scalars() {
    let (x, y) = (0.6, -0.35);
    for (name, callable) in FUNCTIONS {
        // An argument from each domain: acosh needs 1 at the least, roots and logarithms something positive.
        let a = if name == "acosh" {
            "(2 + x*y)"
        } else {
            "(x + y*y/3)"
        };
        let text = match callable.arguments().start() {
            1 => format!("{name}({a})"),
            _ => format!("{name}({a}, 1 + y*x)"),
        };
        let formula = Expression::parse(&text, 2).unwrap_or_else(|e| panic!("{text}: {e}"));
        let jet = formula.at(&[Jet2::<f64, 2>::coordinate(x, 0), Jet2::coordinate(y, 1)]);
        let at = |i: i32, j: i32| formula.at(&[x + H * f64::from(i), y + H * f64::from(j)]);
        const H: f64 = 1e-4;
        let first = (at(1, 0) - at(-1, 0)) / (2.0 * H);
        let mixed = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4.0 * H * H);
        // Differences of the second order in H, of values of size 1: H² and rounding over H².
        assert!(
            (jet.d[0] - first).abs() < 1e-6,
            "{text}: {} {first}",
            jet.d[0]
        );
        assert!(
            (jet.dd[0][1] - mixed).abs() < 1e-6,
            "{text}: {} {mixed}",
            jet.dd[0][1]
        );
        assert!(
            (jet.dd[0][1] - jet.dd[1][0]).abs() < 1e-14,
            "{text}: rounding"
        );
        let dual = formula.at(&[Dual64::new(x, 1.0), Dual64::new(y, 0.0)]);
        assert!((dual.eps - jet.d[0]).abs() < 1e-13, "{text}");
        let lanes = formula.at(&[Lanes::pack(|l| x + l as f64 / 8.0), Lanes::from_f64(y)]);
        for (l, value) in lanes.to_array().into_iter().enumerate() {
            let one = formula.at(&[x + l as f64 / 8.0, y]);
            // The angle of lanes is off by two units in the last place.
            let same = value == one || (value - one).abs() < 1e-15 * one.abs().max(1.0);
            assert!(
                same || (value.is_nan() && one.is_nan()),
                "{text}: {value} {one}"
            );
        }
    }
}

/// The formulas of the derivatives against the chain rule of jets, through both orders, for every function; and 0 and 1
/// are folded.
#[test]
fn gradients_are_the_derivatives() {
    let mut texts: Vec<String> = vec!["x^3*y - y/x".into(), "-x^y + 2".into(), "y".into()];
    for (name, callable) in FUNCTIONS {
        let a = if name == "acosh" {
            "(2 + x*y)"
        } else {
            "(x + y*y/3)"
        };
        texts.push(match callable.arguments().start() {
            1 => format!("{name}({a})"),
            _ => format!("{name}({a}, 1 + y*x)"),
        });
    }
    let parse = |text: &String| Expression::parse(text, 2).expect("a formula");
    let formulas = Expressions::new(texts.iter().map(parse).collect());
    let (x, y) = (0.6, -0.35);
    let at = [Jet2::<f64, 2>::coordinate(x, 0), Jet2::coordinate(y, 1)];
    let mut jets = Vec::new();
    formulas.at(&at, |_, jet| jets.push(jet));
    let once = [Jet1::<f64, 2>::coordinate(x, 0), Jet1::coordinate(y, 1)];
    let mut gradients = Vec::new();
    formulas
        .gradients(2)
        .at(&once, |m, value| gradients.push((m, value)));
    assert_eq!(gradients.len(), 2 * texts.len());
    for ((text, jet), d) in texts.iter().zip(&jets).zip(gradients.chunks(2)) {
        for (m, &(coordinate, derivative)) in d.iter().enumerate() {
            assert_eq!(coordinate, m);
            let parts = [
                (derivative.value, jet.d[m]),
                (derivative.d[0], jet.dd[m][0]),
            ];
            for (ours, theirs) in parts.into_iter().chain([(derivative.d[1], jet.dd[m][1])]) {
                // A few roundings; third powers of 1 / (1 − a²) and the like are below 10.
                let same = (ours - theirs).abs() < 1e-13 * theirs.abs().max(1.0);
                assert!(
                    same || (ours.is_nan() && theirs.is_nan()),
                    "{text}: {ours} {theirs}"
                );
            }
        }
    }
}

#[test]
fn kinks_are_named_and_differentiated_from_one_side() {
    let formula = Expression::parse("abs(x) + max(x, y) + min(x, 1) + abs(y)", 2);
    let formula = formula.expect("a formula");
    assert_eq!(formula.kinks(), ["abs", "min", "max"]);
    let jet = formula.at(&[Jet2::<f64, 2>::coordinate(0.0, 0), Jet2::coordinate(0.0, 1)]);
    assert_eq!((jet.value, jet.d, jet.dd), (0.0, [3.0, 1.0], [[0.0; 2]; 2]));
    let smooth = Expression::parse("hypot(x, y) + atan2(x, y)", 2).expect("a formula");
    assert!(smooth.kinks().is_empty());
}

#[test]
fn near_names_are_suggested_and_far_ones_are_not() {
    for (text, expected) in [
        ("arctan(x)", "'atan'"),
        ("arcsin(x)", "'asin'"),
        ("arctan2(x, y)", "'atan2'"),
        ("sgn(x)", "'sign'"),
        ("signum(x)", "'sign'"),
        ("maximum(x, y)", "'max'"),
        ("Sin(x)", "'sin'"),
        ("squrt(x)", "'sqrt'"),
        ("power(x, y)", "'pow'"),
        ("Pi", "'pi'"),
        ("x7", "the coordinates in dimension 2 are x, y, x1, x2"),
        (
            "bessel(x)",
            "known are x, y, x1, x2, pi, e and the functions sqrt, ",
        ),
        ("q", "known are"),
    ] {
        let error = Expression::parse(text, 2).expect_err(text);
        assert!(error.reason.contains(expected), "{text}: {error}");
    }
}

use super::*;
use regge_curvature::jet::Jet2;
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::SmoothTensor;

fn read(text: &str) -> MetricFile {
    parse_metric(text).unwrap_or_else(|fault| panic!("{text}: {fault:?}"))
}

/// All derivatives to the second order agree with those of the library's own formula, to rounding.
fn agrees<const N: usize>(text: &str, known: Metric) {
    let file = read(text);
    let x: [f64; N] = std::array::from_fn(|i| 0.3 - 0.4 * i as f64);
    let x = std::array::from_fn(|m| Jet2::<f64, N>::coordinate(x[m], m));
    let ours: regge_curvature::linalg::Mat<Jet2<f64, N>, N> = file.metric().at(&x);
    let theirs = known.at(&x);
    for (a, b) in ours.iter().zip(theirs.iter()) {
        let difference = *a - *b;
        let parts = difference.dd.iter().flatten().chain(&difference.d);
        assert!(
            parts.chain([&difference.value]).all(|x| x.abs() < 1e-13),
            "{text}"
        );
    }
}

#[test]
fn four_ways_to_state_a_metric_have_exact_derivatives() {
    let graph = "dimension = 2\ngraph = \"x^2/2 - x^4/12 + y^2/2 - y^4/12\"";
    agrees::<2>(graph, Metric::GraphQuartic);
    agrees::<2>(
        "dimension = 2\nembedding = [\"x\", \"y\", \"x^2/2 - x^4/12 + y^2/2 - y^4/12\"]",
        Metric::GraphQuartic,
    );
    agrees::<3>(
        "dimension = 3\nconformal = \"4/(1 + x^2 + y^2 + z^2)^2\"",
        Metric::Sphere,
    );
    let d = |f: &str| format!("({f} - {f}^3/3)");
    let (x, y) = (d("x"), d("y"));
    let g = format!("dimension = 2\ng = [[\"1+{x}^2\", \"{x}*{y}\"], [\"{y}*{x}\", \"1+{y}^2\"]]");
    agrees::<2>(&g, Metric::GraphQuartic);
}

#[test]
fn what_is_no_metric_is_refused_at_its_line() {
    for (text, line, expected) in [
        (
            "dimension = 2\ngraph = \"sine(x)\"",
            2,
            "graph: column 1: unknown name 'sine'",
        ),
        ("dimension = 2\ngraf = \"x\"", 2, "'graph'"),
        ("dimension = 1\ngraph = \"x\"", 1, "dimension: 1"),
        ("dimension = \"2\"\ngraph = \"x\"", 1, "invalid type"),
        (
            "dimension = 2\ng = [[\"1\", \"x\"], [\"y\", \"1\"]]",
            2,
            "not symmetric",
        ),
        ("dimension = 2\ng = [[\"1\", \"0\"]]", 2, "1 rows"),
        (
            "dimension = 2\ng = [[\"1\", \"0\"],\n[\"0\"]]",
            3,
            "row 2 has 1",
        ),
        ("dimension = 2\nembedding = [\"x\"]", 2, "needs 2"),
        ("dimension = 2\ngraph = \"x", 2, ""),
        ("graph = \"x\"", 1, "dimension"),
        (
            "dimension = 2\n\ngraph = \"x\"\nexact_scalar_curvature = \"1+\"",
            4,
            "exact",
        ),
    ] {
        let fault = parse_metric(text).expect_err(text);
        assert_eq!(fault.place, Place::Line(line), "{text}: {fault:?}");
        assert!(fault.reason.contains(expected), "{text}: {fault:?}");
    }
    for text in [
        "dimension = 2",
        "dimension = 2\ngraph = \"x\"\nconformal = \"1\"",
    ] {
        let fault = parse_metric(text).expect_err(text);
        assert!(fault.reason.contains("exactly one"), "{fault:?}");
    }
}

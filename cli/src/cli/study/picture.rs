//! The picture of a study: our errors as lines, the printed ones as hollow marks, slopes to compare with.

use regge_cli::plot::{Curve, Figure, Guide};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::metrics::Metric;
use regge_study::{Named, Quantity, ROUNDING, Report, Row, Study};

/// The SVG.
pub fn svg(study: &Study, report: &Report, title: &str) -> String {
    figure(study, report, title).svg()
}

fn figure(study: &Study, report: &Report, title: &str) -> Figure {
    let mut curves = Vec::new();
    let mut guides: Vec<Guide> = Vec::new();
    let mut degrees: Vec<usize> = study.cases.iter().map(|case| case.degree).collect();
    degrees.dedup();
    for degree in degrees {
        for (index, &interpolant) in study.interpolants.iter().enumerate() {
            let of = |row: &&Row| row.degree == degree && row.interpolant == interpolant.name_of();
            let rows: Vec<&Row> = report.rows.iter().filter(of).collect();
            let curve = curve(
                degree,
                index,
                interpolant,
                study.interpolants.len() > 1,
                &rows,
            );
            guides.extend(guide(study, degree, interpolant, &curve, &guides));
            curves.push(curve);
        }
    }
    Figure {
        title: title.into(),
        x_label: "degrees of freedom of the Regge metric".into(),
        y_label: "H⁻² norm".into(),
        curves,
        guides,
        if_empty: format!("all errors are below {ROUNDING:e}: zero up to rounding"),
    }
}

fn curve(
    degree: usize,
    dashed: usize,
    interpolant: Interpolant,
    several: bool,
    rows: &[&Row],
) -> Curve {
    let name = match several {
        true => format!("r = {degree}, {}", interpolant.name_of()),
        false => format!("r = {degree}"),
    };
    let seen = |error: f64| error > ROUNDING;
    let ours = rows
        .iter()
        .filter(|row| seen(row.error))
        .map(|row| (row.ndof as f64, row.error));
    let printed = rows
        .iter()
        .filter_map(|row| Some((row.ndof as f64, row.printed?)));
    Curve {
        name,
        color: degree,
        dashed: dashed > 0,
        points: ours.collect(),
        marks: printed.collect(),
    }
}

/// A slope of the expected order under a curve, unless one of that order is there already.
fn guide(
    study: &Study,
    degree: usize,
    interpolant: Interpolant,
    curve: &Curve,
    others: &[Guide],
) -> Option<Guide> {
    let order = expected_order(study, degree, interpolant)?;
    let label = format!("O(h{})", superscript(order));
    let last = curve.points.last()?;
    // Few points are hardly asymptotic: the last two show the slope.
    let back = if curve.points.len() > 5 { 3 } else { 2 };
    let first = curve.points.get(curve.points.len().checked_sub(back)?)?;
    (!others.iter().any(|guide| guide.label == label)).then(|| {
        let slope = -(order as f64) / study.dimension as f64;
        Guide {
            label,
            slope,
            from: first.0,
            to: last.0,
            at_end: 0.45 * last.1,
        }
    })
}

/// The order in h that is to be expected. Paper: cor:conv, section 5 (observed for the canonical interpolant).
fn expected_order(study: &Study, degree: usize, interpolant: Interpolant) -> Option<usize> {
    if study.metric == Metric::Flat {
        return None;
    }
    match study.quantity {
        Quantity::CriticalTerm if interpolant.is(&Interpolant::canonical()) => {
            Some(2 * (degree + 1))
        }
        Quantity::CriticalTerm => (degree > 0).then_some(2 * degree),
        Quantity::CurvatureError | Quantity::BTerm => Some(degree + 1),
        _ => None,
    }
}

fn superscript(order: usize) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match order {
        1 => String::new(),
        _ => order
            .to_string()
            .bytes()
            .map(|digit| DIGITS[usize::from(digit - b'0')])
            .collect(),
    }
}

//! The picture of a claim: its series over the levels, both axes logarithmic; forgeries dashed.

use super::Measured;
use std::fmt::Write;

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 360.0;
/// Around the plot: left, right (for names), top, bottom.
const MARGIN: [f64; 4] = [60.0, 250.0, 12.0, 34.0];
const COLOURS: [&str; 8] = [
    "#1b6ca8", "#c0392b", "#2d8a4e", "#8e44ad", "#d68910", "#117a65", "#7b241c", "#5d6d7e",
];

/// A line of the picture.
struct Line<'a> {
    name: String,
    points: Vec<(f64, f64)>,
    colour: &'a str,
    dashed: bool,
}

/// The mean over the runs, geometric.
fn mean(levels: &[f64], runs: &[Vec<f64>]) -> Vec<(f64, f64)> {
    let at = |i: usize| {
        let logs: f64 = runs.iter().map(|run| run[i].abs().max(1e-300).ln()).sum();
        (logs / runs.len() as f64).exp()
    };
    let all = levels.iter().enumerate().map(|(i, level)| (*level, at(i)));
    all.filter(|(x, y)| *x > 0.0 && y.is_finite() && *y > 1e-200)
        .collect()
}

fn lines(claim: &Measured) -> Vec<Line<'_>> {
    let mut all = Vec::new();
    for (i, finding) in claim.findings.iter().enumerate() {
        let colour = COLOURS[i % COLOURS.len()];
        all.push(Line {
            name: finding.case.clone(),
            points: mean(&finding.levels, &finding.values),
            colour,
            dashed: false,
        });
        for forgery in finding
            .forgeries
            .iter()
            .filter(|f| f.values != finding.values)
        {
            all.push(Line {
                name: String::new(),
                points: mean(&finding.levels, &forgery.values),
                colour,
                dashed: true,
            });
        }
    }
    all
}

/// An interval of logarithms with some room.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (low.min(x.ln()), high.max(x.ln()))
    });
    if low < high {
        (low - 0.1, high + 0.1)
    } else {
        (low - 1.0, low + 1.0)
    }
}

/// The picture as SVG.
pub fn chart(claim: &Measured) -> String {
    let lines = lines(claim);
    let points = || lines.iter().flat_map(|line| &line.points);
    let (xs, ys) = (range(points().map(|p| p.0)), range(points().map(|p| p.1)));
    let [left, right, top, bottom] = MARGIN;
    let place = |x: f64, y: f64| {
        let across = (x.ln() - xs.0) / (xs.1 - xs.0);
        let up = (y.ln() - ys.0) / (ys.1 - ys.0);
        (
            left + across * (WIDTH - left - right),
            HEIGHT - bottom - up * (HEIGHT - top - bottom),
        )
    };
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" \
         font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"white\"/>\n"
    );
    axes(&mut svg, claim, [xs, ys], &place);
    for (i, line) in lines.iter().enumerate() {
        draw(&mut svg, line, &place);
        if !line.dashed {
            let named = lines[..i].iter().filter(|l| !l.dashed).count();
            let (x, y) = (WIDTH - right + 12.0, top + 12.0 + 14.0 * named as f64);
            let _ = writeln!(
                svg,
                "<text x=\"{x}\" y=\"{y}\" fill=\"{}\">{}</text>",
                line.colour,
                escaped(&line.name)
            );
        }
    }
    svg + "</svg>\n"
}

fn axes(
    svg: &mut String,
    claim: &Measured,
    [xs, ys]: [(f64, f64); 2],
    place: &dyn Fn(f64, f64) -> (f64, f64),
) {
    let ((x0, y0), (x1, y1)) = (place(xs.0.exp(), ys.0.exp()), place(xs.1.exp(), ys.1.exp()));
    let _ = writeln!(
        svg,
        "<path d=\"M{x0:.1},{y1:.1} V{y0:.1} H{x1:.1}\" fill=\"none\" stroke=\"#444\"/>"
    );
    for share in [0.0, 0.5, 1.0] {
        let (x, y) = (xs.0 + share * (xs.1 - xs.0), ys.0 + share * (ys.1 - ys.0));
        let (px, py) = place(x.exp(), y.exp());
        let _ = writeln!(
            svg,
            "<text x=\"{px:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{:.2}</text>\
             <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{:.2e}</text>",
            y0 + 13.0,
            x.exp(),
            x0 - 4.0,
            py + 4.0,
            y.exp()
        );
    }
    let axis = claim.findings.first().map_or("", |f| f.axis);
    let _ = writeln!(
        svg,
        "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{axis}; dashed: forgeries</text>",
        0.5 * (x0 + x1),
        y0 + 27.0
    );
}

fn draw(svg: &mut String, line: &Line<'_>, place: &dyn Fn(f64, f64) -> (f64, f64)) {
    let at: Vec<(f64, f64)> = line.points.iter().map(|p| place(p.0, p.1)).collect();
    let path: Vec<String> = at.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    let dash = if line.dashed {
        " stroke-dasharray=\"4 3\""
    } else {
        ""
    };
    let _ = writeln!(
        svg,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\"{dash}/>",
        path.join(" "),
        line.colour
    );
    for (x, y) in at.iter().filter(|_| !line.dashed) {
        let _ = writeln!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{}\"/>",
            line.colour
        );
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

//! The picture of a surface in space: K as colours, shaded, what is hidden hidden.

use super::bar::bar;
use super::range::Range;
use super::scene::{Facet, facets};
use super::view::View;
use crate::curvature::Fields;
use crate::svg::escaped;
use std::fmt::Write;

/// The larger side of the drawing.
const SIDE: f64 = 560.0;
/// The room for the title, for the colour bar, and the margin.
const TITLE: f64 = 56.0;
const BAR: f64 = 150.0;
const MARGIN: f64 = 24.0;
/// More facets than this are drawn without their edges.
const EDGES: usize = 4000;

/// The picture.
pub fn svg(fields: &Fields, title: &str, view: &View) -> String {
    let facets = facets(fields, view);
    let values: Vec<f64> = facets.iter().map(|facet| value(fields, facet)).collect();
    let range = Range::without_outliers(&values);
    let paper = Paper::new(&facets);
    let width = 2.0 * MARGIN + paper.size[0] + BAR;
    let height = 2.0 * MARGIN + TITLE + paper.size[1];
    // A wide sans-serif has letters of 0.6 of its size on the average: a long title gets smaller ones, and fits.
    let letters = title.chars().count().max(1) as f64;
    let font = (0.95 * (width - MARGIN) / (0.6 * letters)).min(17.0);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"sans-serif\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <text x=\"{MARGIN}\" y=\"28\" font-size=\"{font:.1}\">{}</text>\n\
         <g transform=\"translate({MARGIN} {})\">\n\
         <text x=\"0\" y=\"-12\" font-size=\"15\">{}</text>\n",
        escaped(title),
        MARGIN + TITLE,
        heading(&values, &range)
    );
    paper.draw(&facets, &values, &range, &mut text);
    bar(&range, paper.size, &mut text);
    text.push_str("</g>\n</svg>\n");
    text
}

/// What is shown; the true ends where they are beyond the colours.
fn heading(values: &[f64], range: &Range) -> String {
    let mut text = String::from("K = R_h/2, the projected Gauss curvature");
    if range.beyond != [false; 2] {
        let all = Range::new(values);
        let (low, high) = (all.label(all.low), all.label(all.high));
        let _ = write!(text, " (from {low} to {high})");
    }
    text
}

/// K in the middle of a facet; without the corners that have none, on the boundary.
fn value(fields: &Fields, facet: &Facet) -> f64 {
    let k = fields.on_points.iter().find(|field| field.0 == "K");
    let k = &k.expect("a mesh of dimension 2 has K at its vertices").1;
    let corners = &fields.cells[3 * facet.cell..][..3];
    let all = corners.iter().map(|&v| k[v as usize]).zip(facet.middle);
    let known = all.filter(|(k, _)| k.is_finite());
    let (sum, weight) = known.fold((0.0, 0.0), |(s, w), (k, l)| (s + l * k, w + l));
    sum / weight
}

/// From what the viewer sees to the paper.
struct Paper {
    low: [f64; 2],
    scale: f64,
    /// Width and height of the drawing.
    size: [f64; 2],
}

impl Paper {
    fn new(facets: &[Facet]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for corner in facets.iter().flat_map(|facet| &facet.corners) {
            for i in 0..2 {
                low[i] = low[i].min(corner[i]);
                high[i] = high[i].max(corner[i]);
            }
        }
        let size = [high[0] - low[0], high[1] - low[1]];
        let scale = SIDE / size[0].max(size[1]);
        Self {
            low,
            scale,
            // Wide enough for the heading, high enough for the labels of the bar.
            size: [(size[0] * scale).max(420.0), (size[1] * scale).max(200.0)],
        }
    }

    fn draw(&self, facets: &[Facet], values: &[f64], range: &Range, text: &mut String) {
        // Without edges of their own facets get their colour as an edge: gaps of a part of a point would shine through.
        let own = facets.len() > EDGES;
        let edge = match own {
            true => "stroke-width=\"0.5\"",
            false => "stroke=\"#333\" stroke-opacity=\"0.5\" stroke-width=\"0.4\"",
        };
        let _ = writeln!(text, "<g stroke-linejoin=\"round\" {edge}>");
        for (facet, value) in facets.iter().zip(values) {
            let color = range.lit(*value, facet.light);
            let _ = write!(text, "<path fill=\"{color}\" ");
            if own {
                let _ = write!(text, "stroke=\"{color}\" ");
            }
            text.push_str("d=\"");
            for (mark, corner) in ['M', 'L', 'L'].iter().zip(&facet.corners) {
                let x = (corner[0] - self.low[0]) * self.scale;
                let y = self.size[1] - (corner[1] - self.low[1]) * self.scale;
                let _ = write!(text, "{mark}{x:.1} {y:.1}");
            }
            text.push_str("z\"/>\n");
        }
        text.push_str("</g>\n");
    }
}

//! One picture for each claim: how far its residual lies below the tolerance, and its forgeries above it.

use super::summary::Row;
use crate::harness::Entry;
use std::fmt::Write;

const WIDTH: f64 = 720.0;
const LEFT: f64 = 110.0;
const ROW: f64 = 18.0;
/// Decades of residual over tolerance that are shown, on either side of 1.
const RANGE: (f64, f64) = (-6.0, 13.0);

/// Horizontal place of residual/tolerance.
fn place(ratio: f64) -> f64 {
    let decades = ratio.max(1e-300).log10().clamp(RANGE.0, RANGE.1);
    LEFT + (decades - RANGE.0) / (RANGE.1 - RANGE.0) * (WIDTH - LEFT - 10.0)
}

/// Strips, one for each entry that was computed with rounding: the residual (a dot) and the forgeries (ticks), over
/// the tolerance (the line). Nothing, if there is none.
pub fn strips(row: &Row<'_>) -> String {
    let entries: Vec<&Entry> = row
        .entries
        .iter()
        .copied()
        .filter(|e| e.tolerance > 0.0)
        .collect();
    if entries.is_empty() {
        return String::new();
    }
    let height = ROW * (entries.len() as f64 + 1.5);
    let mut svg = format!(
        "<svg viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" role=\"img\" \
         aria-label=\"residuals and forgeries over the tolerance\">"
    );
    let bottom = ROW * entries.len() as f64 + 4.0;
    let one = place(1.0);
    let _ = write!(
        svg,
        "<line class=\"tolerance\" x1=\"{one:.1}\" x2=\"{one:.1}\" y1=\"0\" y2=\"{bottom}\"/>"
    );
    for decade in [-4, 0, 4, 8, 12] {
        let x = place(10f64.powi(decade));
        let y = bottom + 12.0;
        let _ = write!(
            svg,
            "<text x=\"{x:.1}\" y=\"{y}\" text-anchor=\"middle\">10^{decade}</text>"
        );
    }
    for (k, entry) in entries.iter().enumerate() {
        strip(&mut svg, entry, ROW * k as f64 + ROW / 2.0);
    }
    svg + "</svg>"
}

fn strip(svg: &mut String, entry: &Entry, y: f64) {
    let base = y + 4.0;
    let _ = write!(
        svg,
        "<text x=\"0\" y=\"{base}\">N = {}, {}</text>",
        entry.dimension, entry.method
    );
    for margin in entry.forgeries.iter().filter_map(|f| f.margin) {
        let (x, top, end) = (place(margin), y - 5.0, y + 5.0);
        let _ = write!(
            svg,
            "<line class=\"forgery\" x1=\"{x:.1}\" x2=\"{x:.1}\" y1=\"{top}\" y2=\"{end}\"/>"
        );
    }
    let x = place(entry.worst_residual / entry.tolerance);
    let _ = write!(svg, "<circle cx=\"{x:.1}\" cy=\"{y}\" r=\"4\"/>");
}

//! The colour bar to the right of a drawing of this width and height.

use super::range::Range;
use std::fmt::Write;

/// The bar with its labels.
pub fn bar(range: &Range, [width, height]: [f64; 2], text: &mut String) {
    let (left, steps) = (width + 16.0, 100);
    let step = height / f64::from(steps);
    for i in 0..steps {
        let part = (f64::from(i) + 0.5) / f64::from(steps);
        let fill = range.color(range.low + part * (range.high - range.low));
        let _ = writeln!(
            text,
            "<rect x=\"{left:.1}\" y=\"{:.2}\" width=\"18\" height=\"{:.2}\" fill=\"{fill}\"/>",
            height - f64::from(i + 1) * step,
            step + 0.5
        );
    }
    let _ = writeln!(
        text,
        "<rect x=\"{left:.1}\" y=\"0\" width=\"18\" height=\"{height:.2}\" fill=\"none\" stroke=\"#444\"/>"
    );
    labels(range, [width, height], text);
}

/// Five values beside the bar, its ends among them.
fn labels(range: &Range, [width, height]: [f64; 2], text: &mut String) {
    for i in 0..=4 {
        let part = f64::from(i) / 4.0;
        let value = range.low + part * (range.high - range.low);
        // The ends stand for all beyond them where there are such.
        let beyond = match i {
            0 if range.beyond[0] => "≤ ",
            4 if range.beyond[1] => "≥ ",
            _ => "",
        };
        let _ = writeln!(
            text,
            "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"13\">{beyond}{}</text>",
            width + 41.0,
            height * (1.0 - part) + 4.5,
            range.label(value)
        );
    }
}

//! Logarithmic axes.

use super::{Curve, Figure, line};
use crate::svg::escaped;
use std::fmt::{self, Write};
use std::ops::Range;

/// Where the axes are: left, top, right, bottom.
pub const FRAME: [f64; 4] = [98.0, 48.0, 886.0, 558.0];

/// A place in the picture.
pub type Place = (f64, f64);

/// What is to be seen, on logarithmic axes.
pub struct Plane {
    x: Range<f64>,
    y: Range<f64>,
}

impl Plane {
    /// With room for the labels on the right and for the legend below.
    pub fn new(figure: &Figure) -> Self {
        let curves = || {
            let of = |curve: &'_ Curve| curve.points.iter().chain(&curve.marks).copied().collect();
            figure.curves.iter().flat_map::<Vec<(f64, f64)>, _>(of)
        };
        let ends = figure.guides.iter().map(|guide| guide.at_end);
        let x = hull(curves().map(|p| p.0));
        let y = hull(curves().map(|p| p.1).chain(ends));
        Self {
            x: x.start * 0.6..x.end * 3.0,
            y: y.start * 0.4..y.end * 2.5,
        }
    }

    /// Where a point is in the picture.
    pub fn place(&self, (x, y): (f64, f64)) -> Place {
        let [left, top, right, bottom] = FRAME;
        let part =
            |of: f64, range: &Range<f64>| (of / range.start).ln() / (range.end / range.start).ln();
        (
            left + part(x, &self.x) * (right - left),
            bottom - part(y, &self.y) * (bottom - top),
        )
    }

    /// Axes, a grid, labels.
    pub fn axes(&self, text: &mut String, x_label: &str, y_label: &str) -> fmt::Result {
        let [left, top, right, bottom] = FRAME;
        let grid = "stroke=\"black\" stroke-opacity=\"0.15\"";
        for tick in ticks(&self.x) {
            let x = self.place((tick, self.y.start)).0;
            line(text, &[(x, top), (x, bottom)], grid)?;
            let place = format!(
                "x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\"",
                bottom + 20.0
            );
            writeln!(
                text,
                "<text {place} font-size=\"14\">{}</text>",
                power_of_ten(tick)
            )?;
        }
        for tick in ticks(&self.y) {
            let y = self.place((self.x.start, tick)).1;
            line(text, &[(left, y), (right, y)], grid)?;
            let place = format!(
                "x=\"{}\" y=\"{:.1}\" text-anchor=\"end\"",
                left - 8.0,
                y + 5.0
            );
            writeln!(
                text,
                "<text {place} font-size=\"14\">{}</text>",
                power_of_ten(tick)
            )?;
        }
        line(
            text,
            &[(left, top), (left, bottom), (right, bottom)],
            "stroke=\"black\"",
        )?;
        let middle = [(left + right) / 2.0, (top + bottom) / 2.0];
        for (place, label) in [
            (
                format!("translate({} {})", middle[0], bottom + 48.0),
                x_label,
            ),
            (format!("translate(30 {}) rotate(-90)", middle[1]), y_label),
        ] {
            let label = escaped(label);
            writeln!(
                text,
                "<text transform=\"{place}\" font-size=\"17\" text-anchor=\"middle\">{label}</text>"
            )?;
        }
        Ok(())
    }
}

/// Powers of ten, ten at the most; where there are fewer than two, their doubles and quintuples as well.
fn ticks(range: &Range<f64>) -> Vec<f64> {
    let [first, last] = [range.start.log10().floor(), range.end.log10().ceil()].map(|e| e as i32);
    let inside = |list: &[i32], step: usize| -> Vec<f64> {
        let powers = (first..=last).step_by(step);
        let all = powers.flat_map(|e| list.iter().map(move |m| f64::from(*m) * 10f64.powi(e)));
        all.filter(|x| range.contains(x)).collect()
    };
    let powers = inside(&[1], 1);
    match powers.len() {
        0 | 1 => inside(&[1, 2, 5], 1),
        count => inside(&[1], count.div_ceil(10)),
    }
}

/// The least interval around positive numbers; one decade where there is none.
fn hull(values: impl Iterator<Item = f64>) -> Range<f64> {
    let grow = |hull: Range<f64>, x: f64| hull.start.min(x)..hull.end.max(x);
    let hull = values.filter(|x| *x > 0.0).fold(f64::INFINITY..0.0, grow);
    if hull.end > 0.0 { hull } else { 0.1..1.0 }
}

/// 10ⁿ, or digits where ticks are no powers of ten.
fn power_of_ten(x: f64) -> String {
    let exponent = x.log10().round();
    if (x / 10f64.powf(exponent) - 1.0).abs() > 1e-6 {
        return format!("{x:.0e}");
    }
    let raised = |c: char| match c {
        '-' => '⁻',
        digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize - '0' as usize],
    };
    format!(
        "10{}",
        exponent.to_string().chars().map(raised).collect::<String>()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_powers_of_ten_or_few() {
        let near = |found: Vec<f64>, known: &[f64]| {
            assert_eq!(found.len(), known.len(), "{found:?}");
            let pairs = found.iter().zip(known);
            assert!(pairs.into_iter().all(|(a, b)| (a / b - 1.0).abs() < 1e-12));
        };
        near(ticks(&(0.5..200.0)), &[1.0, 10.0, 100.0]);
        near(ticks(&(3.0..30.0)), &[5.0, 10.0, 20.0]);
        assert!((5..=10).contains(&ticks(&(1e-30..1.0)).len()));
        assert_eq!([1e-3, 2e-3].map(power_of_ten), ["10⁻³", "2e-3"]);
    }
}

//! Log-log pictures of convergence as SVG.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;
use std::ops::Range;

/// A sequence of errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// Which colour.
    pub color: usize,
    /// Dashed, to tell it from another curve of the same colour?
    pub dashed: bool,
    /// (x, y), drawn as a line with full marks.
    pub points: Vec<(f64, f64)>,
    /// (x, y) to compare with, drawn as hollow marks.
    pub marks: Vec<(f64, f64)>,
}

/// A straight line of a known slope.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// What is written at its end.
    pub label: String,
    /// d log y / d log x.
    pub slope: f64,
    /// The first x.
    pub from: f64,
    /// The last x.
    pub to: f64,
    /// y at the last x.
    pub at_end: f64,
}

/// A picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Its head.
    pub title: String,
    /// What x is.
    pub x_label: String,
    /// What y is.
    pub y_label: String,
    /// The curves.
    pub curves: Vec<Curve>,
    /// The slopes.
    pub guides: Vec<Guide>,
}

/// Width and height.
const SIZE: (u32, u32) = (900, 620);

/// Colours that differ for the colour-blind too. Source: Okabe and Ito, "Color Universal Design" (2008).
const COLORS: [RGBColor; 6] = [
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];

type Result<T> = std::result::Result<T, Box<dyn Error>>;

type Plane<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>;

impl Figure {
    /// The SVG's text.
    ///
    /// # Errors
    /// If the drawing library gives up.
    pub fn svg(&self) -> std::result::Result<String, String> {
        let mut text = String::new();
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        let drawn = self.draw(&root).map_err(|error| error.to_string());
        drop(root);
        drawn.map(|()| text)
    }

    fn draw(&self, root: &DrawingArea<SVGBackend<'_>, Shift>) -> Result<()> {
        root.fill(&WHITE)?;
        let (x, y) = self.ranges();
        let mut chart = ChartBuilder::on(root)
            .caption(&self.title, ("sans-serif", 20))
            .margin(14)
            .x_label_area_size(48)
            .y_label_area_size(84)
            .build_cartesian_2d(x.log_scale(), y.log_scale())?;
        self.axes(&mut chart)?;
        for guide in &self.guides {
            guide.draw(&mut chart)?;
        }
        for curve in &self.curves {
            curve.draw(&mut chart)?;
        }
        self.legend(&mut chart)?;
        root.present()?;
        Ok(())
    }

    /// What is to be seen, with room for the labels on the right and for the legend below.
    fn ranges(&self) -> (Range<f64>, Range<f64>) {
        let curves = || {
            self.curves
                .iter()
                .flat_map(|c| c.points.iter().chain(&c.marks))
        };
        let ends = self.guides.iter().map(|guide| guide.at_end);
        let x = hull(curves().map(|p| p.0));
        let y = hull(curves().map(|p| p.1).chain(ends));
        (x.start * 0.6..x.end * 3.0, y.start * 0.4..y.end * 2.5)
    }

    fn axes(&self, chart: &mut Plane<'_, '_>) -> Result<()> {
        chart
            .configure_mesh()
            .x_desc(&self.x_label)
            .y_desc(&self.y_label)
            .axis_desc_style(("sans-serif", 17))
            .label_style(("sans-serif", 14))
            .light_line_style(WHITE)
            .bold_line_style(BLACK.mix(0.15))
            .x_labels(8)
            .y_labels(10)
            .x_label_formatter(&power_of_ten)
            .y_label_formatter(&power_of_ten)
            .draw()?;
        Ok(())
    }

    fn legend<'a, 'b: 'a>(&self, chart: &mut Plane<'a, 'b>) -> Result<()> {
        if self.curves.iter().any(|curve| !curve.marks.is_empty()) {
            let hollow = |(x, y)| Circle::new((x + 12, y), 5, BLACK.stroke_width(1));
            chart
                .draw_series(std::iter::empty::<Circle<(f64, f64), i32>>())?
                .label("hollow: printed in the paper")
                .legend(hollow);
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::LowerLeft)
            .margin(12)
            .label_font(("sans-serif", 15))
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .draw()?;
        Ok(())
    }
}

impl Curve {
    fn draw<'a, 'b: 'a>(&self, chart: &mut Plane<'a, 'b>) -> Result<()> {
        let color = COLORS[self.color % COLORS.len()].mix(if self.dashed { 0.7 } else { 1.0 });
        let line = color.stroke_width(2);
        let points = self.points.clone();
        let series = match self.dashed {
            true => chart.draw_series(DashedLineSeries::new(points, 7, 5, line))?,
            false => chart.draw_series(LineSeries::new(points, line))?,
        };
        let gap = if self.dashed { 5 } else { 0 };
        series.label(&self.name).legend(move |(x, y)| {
            let half =
                |from: i32, to: i32| PathElement::new(vec![(x + from, y), (x + to, y)], line);
            let dot = Circle::new((x + 12, y), 3, color.filled());
            EmptyElement::at((0, 0)) + half(0, 12 - gap) + half(12 + gap, 24) + dot
        });
        let dot = |&p: &_| Circle::new(p, 3, color.filled());
        chart.draw_series(self.points.iter().map(dot))?;
        let hollow = |&p: &_| Circle::new(p, 7, color.stroke_width(1));
        chart.draw_series(self.marks.iter().map(hollow))?;
        Ok(())
    }
}

impl Guide {
    fn draw<'a, 'b: 'a>(&self, chart: &mut Plane<'a, 'b>) -> Result<()> {
        let at_start = self.at_end * (self.from / self.to).powf(self.slope);
        let ends = [(self.from, at_start), (self.to, self.at_end)];
        let grey = BLACK.mix(0.55);
        chart.draw_series(DashedLineSeries::new(ends, 4, 4, grey.stroke_width(1)))?;
        let font = ("sans-serif", 15).into_font().color(&grey);
        let style = font.pos(Pos::new(HPos::Left, VPos::Center));
        let label = Text::new(self.label.clone(), (self.to * 1.15, self.at_end), style);
        chart.draw_series(std::iter::once(label))?;
        Ok(())
    }
}

/// The least interval around positive numbers; one decade where there is none.
fn hull(values: impl Iterator<Item = f64>) -> Range<f64> {
    let grow = |hull: Range<f64>, x: f64| hull.start.min(x)..hull.end.max(x);
    let hull = values.filter(|x| *x > 0.0).fold(f64::INFINITY..0.0, grow);
    if hull.end > 0.0 { hull } else { 0.1..1.0 }
}

/// 10ⁿ, or digits where ticks are no powers of ten.
fn power_of_ten(x: &f64) -> String {
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

//! Log-log pictures of convergence as SVG.

mod plane;

use crate::svg::escaped;
use plane::{FRAME, Place, Plane};
use std::fmt::{self, Write};

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
    /// What is written where no curve has a point.
    pub if_empty: String,
}

/// Width and height of the picture.
const SIZE: [f64; 2] = [900.0, 620.0];

/// Colours that differ for the colour-blind too. Source: Okabe and Ito, "Color Universal Design" (2008).
const COLORS: [&str; 6] = [
    "#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
];

impl Figure {
    /// The SVG's text.
    pub fn svg(&self) -> String {
        let mut text = String::new();
        self.draw(&mut text)
            .expect("a string takes whatever is written");
        text
    }

    fn draw(&self, text: &mut String) -> fmt::Result {
        let [width, height] = SIZE;
        // A wide sans-serif has letters of 0.6 of its size on the average: a long title gets smaller ones, and fits.
        let letters = self.title.chars().count().max(1) as f64;
        let font = (0.95 * width / (0.6 * letters)).min(20.0);
        writeln!(
            text,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
             <text x=\"{}\" y=\"32\" font-size=\"{font:.1}\" text-anchor=\"middle\">{}</text>",
            width / 2.0,
            escaped(&self.title)
        )?;
        let plane = Plane::new(self);
        plane.axes(text, &self.x_label, &self.y_label)?;
        for guide in &self.guides {
            guide.draw(text, &plane)?;
        }
        for curve in &self.curves {
            curve.draw(text, &plane)?;
        }
        if self.curves.iter().all(|curve| curve.points.is_empty()) {
            // An empty picture would be taken for a fault.
            writeln!(
                text,
                "<text x=\"{}\" y=\"{}\" font-size=\"18\" text-anchor=\"middle\">{}</text>",
                (FRAME[0] + FRAME[2]) / 2.0,
                (FRAME[1] + FRAME[3]) / 2.0,
                escaped(&self.if_empty)
            )?;
        }
        self.legend(text)?;
        writeln!(text, "</svg>")
    }

    /// The names of the curves in the lower left corner, where errors that fall leave room.
    fn legend(&self, text: &mut String) -> fmt::Result {
        const ROW: f64 = 22.0;
        const HOLLOW: &str = "hollow: printed in the paper";
        let hollow = self.curves.iter().any(|curve| !curve.marks.is_empty());
        let names = self.curves.iter().map(|curve| curve.name.as_str());
        let names: Vec<&str> = names.chain(hollow.then_some(HOLLOW)).collect();
        let longest = names.iter().map(|name| name.chars().count()).max();
        let height = ROW * names.len() as f64 + 10.0;
        let (left, top) = (FRAME[0] + 12.0, FRAME[3] - 12.0 - height);
        writeln!(
            text,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{:.0}\" height=\"{height}\" fill=\"white\" \
             fill-opacity=\"0.85\" stroke=\"#bbb\"/>",
            // Letters of 15 points are 8 wide on average.
            50.0 + 8.0 * longest.unwrap_or(0) as f64
        )?;
        for (row, name) in names.iter().enumerate() {
            let y = top + 5.0 + ROW * (row as f64 + 0.5);
            let sample = [(left + 8.0, y), (left + 32.0, y)];
            match self.curves.get(row) {
                Some(curve) => {
                    curve.line(text, &sample)?;
                    curve.dot(text, (left + 20.0, y))?;
                }
                None => circle(
                    text,
                    (left + 20.0, y),
                    5.0,
                    "fill=\"none\" stroke=\"black\"",
                )?,
            }
            writeln!(
                text,
                "<text x=\"{}\" y=\"{}\" font-size=\"15\">{}</text>",
                left + 42.0,
                y + 5.0,
                escaped(name)
            )?;
        }
        Ok(())
    }
}

impl Curve {
    fn draw(&self, text: &mut String, plane: &Plane) -> fmt::Result {
        let points: Vec<Place> = self.points.iter().map(|&p| plane.place(p)).collect();
        self.line(text, &points)?;
        points.iter().try_for_each(|&place| self.dot(text, place))?;
        let hollow = format!("fill=\"none\" stroke=\"{}\"", self.color());
        self.marks
            .iter()
            .try_for_each(|&mark| circle(text, plane.place(mark), 7.0, &hollow))
    }

    fn color(&self) -> &'static str {
        COLORS[self.color % COLORS.len()]
    }

    fn line(&self, text: &mut String, points: &[Place]) -> fmt::Result {
        let dashes = match self.dashed {
            true => " stroke-dasharray=\"7 5\" stroke-opacity=\"0.7\"",
            false => "",
        };
        line(
            text,
            points,
            &format!("stroke=\"{}\" stroke-width=\"2\"{dashes}", self.color()),
        )
    }

    fn dot(&self, text: &mut String, place: Place) -> fmt::Result {
        circle(text, place, 3.0, &format!("fill=\"{}\"", self.color()))
    }
}

impl Guide {
    fn draw(&self, text: &mut String, plane: &Plane) -> fmt::Result {
        let at_start = self.at_end * (self.from / self.to).powf(self.slope);
        let ends = [(self.from, at_start), (self.to, self.at_end)];
        let ends = ends.map(|end| plane.place(end));
        line(text, &ends, "stroke=\"#777\" stroke-dasharray=\"4 4\"")?;
        let (x, y) = ends[1];
        writeln!(
            text,
            "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"15\" fill=\"#777\">{}</text>",
            x + 8.0,
            y + 5.0,
            escaped(&self.label)
        )
    }
}

fn line(text: &mut String, points: &[Place], style: &str) -> fmt::Result {
    write!(text, "<polyline fill=\"none\" {style} points=\"")?;
    for (x, y) in points {
        write!(text, "{x:.1},{y:.1} ")?;
    }
    writeln!(text, "\"/>")
}

fn circle(text: &mut String, (x, y): Place, radius: f64, style: &str) -> fmt::Result {
    writeln!(
        text,
        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" {style}/>"
    )
}

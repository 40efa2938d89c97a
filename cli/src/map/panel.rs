//! One panel of a plane mesh: a field on the cells or at the vertices, and its colour bar.

use super::bar::bar;
use super::range::Range;
use crate::curvature::Fields;
use std::fmt::Write;

/// The larger side of a drawing.
const SIDE: f64 = 420.0;

/// What a panel shows.
pub enum Shown<'a> {
    /// A number for each cell.
    Cells(Vec<f64>),
    /// A number for each vertex, as a disc; NaN is left out.
    Vertices(&'a [f64]),
}

/// From the mesh to the paper.
pub struct Plane {
    low: [f64; 2],
    scale: f64,
    /// How wide the drawing is.
    pub width: f64,
    /// How high.
    pub height: f64,
}

impl Plane {
    /// That all points fit.
    pub fn new(fields: &Fields) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in fields.points.chunks_exact(3) {
            for i in 0..2 {
                low[i] = low[i].min(point[i]);
                high[i] = high[i].max(point[i]);
            }
        }
        let size = [high[0] - low[0], high[1] - low[1]];
        let scale = SIDE / size[0].max(size[1]);
        Self {
            low,
            scale,
            // A panel is wide enough for its title, and high enough for the labels of its bar.
            width: (size[0] * scale).max(240.0),
            height: (size[1] * scale).max(160.0),
        }
    }

    /// y points upwards in the mesh and downwards on the paper.
    fn place(&self, fields: &Fields, vertex: usize) -> [f64; 2] {
        let x = (fields.points[3 * vertex] - self.low[0]) * self.scale;
        let y = self.height - (fields.points[3 * vertex + 1] - self.low[1]) * self.scale;
        [x, y]
    }

    /// A field with its colour bar.
    pub fn panel(&self, fields: &Fields, shown: &Shown<'_>, text: &mut String) {
        let range = match shown {
            Shown::Cells(values) => {
                let range = Range::new(values);
                self.cells(fields, |cell| range.color(values[cell]), text);
                range
            }
            Shown::Vertices(values) => {
                let range = Range::new(values);
                self.cells(fields, |_| "#ffffff".into(), text);
                self.discs(fields, values, &range, text);
                range
            }
        };
        bar(&range, [self.width, self.height], text);
    }

    fn cells(&self, fields: &Fields, fill: impl Fn(usize) -> String, text: &mut String) {
        let cells = fields.cells.chunks_exact(3);
        // Edges of cells that are hardly larger than a point would hide their colour.
        let (stroke, width) = match cells.len() > 5000 {
            true => ("none", 0.0),
            false => ("#888", 0.4),
        };
        for (cell, vertices) in cells.enumerate() {
            let fill = fill(cell);
            let _ = write!(
                text,
                "<polygon fill=\"{fill}\" stroke-width=\"{width}\" stroke=\"{stroke}\" points=\""
            );
            for &v in vertices {
                let [x, y] = self.place(fields, v as usize);
                let _ = write!(text, "{x:.2},{y:.2} ");
            }
            text.push_str("\"/>\n");
        }
    }

    fn discs(&self, fields: &Fields, values: &[f64], range: &Range, text: &mut String) {
        let cells = fields.cells.len() as f64 / 3.0;
        let radius = (0.35 * (self.width * self.height / cells).sqrt()).clamp(0.8, 9.0);
        for (vertex, value) in values.iter().enumerate().filter(|(_, v)| v.is_finite()) {
            let ([x, y], fill) = (self.place(fields, vertex), range.color(*value));
            let _ = writeln!(
                text,
                "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\" fill=\"{fill}\" \
                 stroke=\"#444\" stroke-width=\"{:.2}\"/>",
                radius.min(3.0) * 0.15
            );
        }
    }
}

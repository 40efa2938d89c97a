//! Colour maps of fields on a plane mesh as SVG: one panel a field, each with its colour bar.

use crate::curvature::Fields;
use std::fmt::Write;

/// More cells than this make no picture, and an SVG that no viewer opens.
pub const LARGEST: usize = 100_000;

/// The side of a panel's drawing, the room for its title, for its colour bar, and the margin.
const SIDE: f64 = 420.0;
const TITLE: f64 = 56.0;
const BAR: f64 = 130.0;
const MARGIN: f64 = 24.0;

/// A diverging map, blue for negative and red for positive values, white at 0. Source: Moreland, "Diverging color maps
/// for scientific visualization" (2009), cool-warm, brightened in the middle.
const NEGATIVE: [f64; 3] = [59.0, 76.0, 192.0];
const POSITIVE: [f64; 3] = [180.0, 4.0, 38.0];
const ZERO: [f64; 3] = [246.0, 246.0, 246.0];

/// For values of one sign: viridis, which is even in lightness. Source: Smith and van der Walt (2015), five of its 256.
const VIRIDIS: [[f64; 3]; 5] = [
    [68.0, 1.0, 84.0],
    [59.0, 82.0, 139.0],
    [33.0, 145.0, 140.0],
    [94.0, 201.0, 98.0],
    [253.0, 231.0, 37.0],
];

/// What a panel shows.
enum Shown<'a> {
    /// A number for each cell.
    Cells(Vec<f64>),
    /// A number for each vertex, as a disc; NaN is left out.
    Vertices(&'a [f64]),
}

/// The picture: R in cells (if there is any), R_h, and Θ at the vertices.
///
/// # Errors
/// If the mesh is not plane or too large, in words.
pub fn svg(fields: &Fields, title: &str) -> Result<String, String> {
    let cells = fields.cells.len() / 3;
    if fields.dimension != 2 {
        return Err(format!(
            "a picture shows triangles, the mesh has dimension {}: write a VTU file",
            fields.dimension
        ));
    }
    if cells > LARGEST {
        return Err(format!(
            "{cells} cells are too many for a picture (the limit is {LARGEST}): write a VTU file"
        ));
    }
    let plane = Plane::new(fields);
    let panels = panels(fields);
    let width = MARGIN + panels.len() as f64 * (plane.width + BAR + MARGIN);
    let height = 2.0 * MARGIN + TITLE + plane.height;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"sans-serif\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <text x=\"{MARGIN}\" y=\"28\" font-size=\"17\">{}</text>\n",
        escaped(title)
    );
    for (i, (name, shown)) in panels.iter().enumerate() {
        let left = MARGIN + i as f64 * (plane.width + BAR + MARGIN);
        let _ = writeln!(
            text,
            "<g transform=\"translate({left:.1} {:.1})\">",
            MARGIN + TITLE
        );
        let _ = writeln!(
            text,
            "<text x=\"0\" y=\"-12\" font-size=\"15\">{}</text>",
            escaped(name)
        );
        plane.panel(fields, shown, &mut text);
        text.push_str("</g>\n");
    }
    text.push_str("</svg>\n");
    Ok(text)
}

/// The same as PNG, twice as large for sharp text, with a font of its own: nothing depends on what is installed.
///
/// # Errors
/// In words, if the picture is too large for memory.
pub fn png(svg: &str) -> Result<Vec<u8>, String> {
    use resvg::{tiny_skia, usvg};
    let mut options = usvg::Options::default();
    let fonts = options.fontdb_mut();
    fonts.load_font_data(epaint_default_fonts::UBUNTU_LIGHT.to_vec());
    fonts.set_sans_serif_family("Ubuntu");
    let tree = usvg::Tree::from_str(svg, &options).map_err(|error| error.to_string())?;
    let [width, height] = [tree.size().width(), tree.size().height()].map(|x| (2.0 * x) as u32);
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or("the picture is too large")?;
    let scale = tiny_skia::Transform::from_scale(2.0, 2.0);
    resvg::render(&tree, scale, &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| error.to_string())
}

/// The fields that are worth a panel.
fn panels(fields: &Fields) -> Vec<(&'static str, Shown<'_>)> {
    let mut panels = Vec::new();
    let on_cells = fields.on_cells.iter().find(|f| f.0 == "R").map(|f| &f.1);
    if let Some(r) = on_cells.filter(|r| r.iter().any(|x| *x != 0.0)) {
        panels.push(("R, mean over each cell", Shown::Cells(r.clone())));
    }
    let on_points = |name: &str| fields.on_points.iter().find(|f| f.0 == name).map(|f| &f.1);
    if let Some(r_h) = on_points("R_h") {
        let mean = |cell: &[u32]| cell.iter().map(|&v| r_h[v as usize]).sum::<f64>() / 3.0;
        let means = fields.cells.chunks_exact(3).map(mean).collect();
        panels.push(("R_h, the projected curvature", Shown::Cells(means)));
    }
    if let Some(theta) = on_points("Theta") {
        panels.push(("Θ, angle defect at inner vertices", Shown::Vertices(theta)));
    }
    panels
}

/// From the mesh to the paper.
struct Plane {
    low: [f64; 2],
    scale: f64,
    width: f64,
    height: f64,
}

impl Plane {
    fn new(fields: &Fields) -> Self {
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

    fn panel(&self, fields: &Fields, shown: &Shown<'_>, text: &mut String) {
        let values: &[f64] = match shown {
            Shown::Cells(list) => list,
            Shown::Vertices(list) => list,
        };
        let range = Range::new(values);
        let cells = fields.cells.len() / 3;
        // Edges of cells that are hardly larger than a point would hide their colour.
        let thin = if cells > 5000 { 0.0 } else { 0.4 };
        for cell in 0..cells {
            let fill = match shown {
                Shown::Cells(list) => range.color(list[cell]),
                Shown::Vertices(_) => "#ffffff".into(),
            };
            let _ = write!(
                text,
                "<polygon fill=\"{fill}\" stroke-width=\"{thin}\" stroke=\""
            );
            text.push_str(if thin > 0.0 {
                "#888\" points=\""
            } else {
                "none\" points=\""
            });
            for &v in &fields.cells[3 * cell..3 * cell + 3] {
                let [x, y] = self.place(fields, v as usize);
                let _ = write!(text, "{x:.2},{y:.2} ");
            }
            text.push_str("\"/>\n");
        }
        if let Shown::Vertices(list) = shown {
            self.discs(fields, list, &range, text);
        }
        self.bar(&range, text);
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

    /// The colour bar to the right of the panel, with the values of its ends, its middle and 0.
    fn bar(&self, range: &Range, text: &mut String) {
        let (left, steps) = (self.width + 16.0, 100);
        for i in 0..steps {
            let part = (f64::from(i) + 0.5) / f64::from(steps);
            let (top, high) = (
                self.height * (1.0 - f64::from(i + 1) / f64::from(steps)),
                self.height / f64::from(steps) + 0.5,
            );
            let fill = range.color(range.low + part * (range.high - range.low));
            let _ = writeln!(
                text,
                "<rect x=\"{left:.1}\" y=\"{top:.2}\" width=\"18\" height=\"{high:.2}\" fill=\"{fill}\"/>"
            );
        }
        let _ = writeln!(
            text,
            "<rect x=\"{left:.1}\" y=\"0\" width=\"18\" height=\"{:.2}\" fill=\"none\" stroke=\"#444\"/>",
            self.height
        );
        for i in 0..=4 {
            let part = f64::from(i) / 4.0;
            let (value, y) = (
                range.low + part * (range.high - range.low),
                self.height * (1.0 - part),
            );
            let _ = writeln!(
                text,
                "<text x=\"{:.1}\" y=\"{:.1}\" font-size=\"13\">{}</text>",
                left + 25.0,
                y + 4.5,
                range.label(value)
            );
        }
    }
}

/// The values that the colours stand for.
struct Range {
    low: f64,
    high: f64,
}

impl Range {
    /// From the least to the largest value; a little around them where they are one.
    fn new(values: &[f64]) -> Self {
        let finite = || values.iter().copied().filter(|x| x.is_finite());
        let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| {
            (l.min(x), h.max(x))
        });
        let size = low.abs().max(high.abs());
        if !size.is_finite() {
            return Self {
                low: -1.0,
                high: 1.0,
            };
        }
        // Differences in the last places are no picture.
        match high - low > 1e-9 * size {
            true => Self { low, high },
            false => Self {
                low: low - 0.5 * size.max(1e-12),
                high: high + 0.5 * size.max(1e-12),
            },
        }
    }

    /// With both signs: white at 0, full colour at the largest absolute value. With one: from end to end.
    fn color(&self, value: f64) -> String {
        if !value.is_finite() {
            return "#bbbbbb".into();
        }
        let [r, g, b] = match self.low < 0.0 && self.high > 0.0 {
            true => {
                let part = (value / self.low.abs().max(self.high.abs())).clamp(-1.0, 1.0);
                let end = if part < 0.0 { NEGATIVE } else { POSITIVE };
                mixed(ZERO, end, part.abs())
            }
            false => {
                let part = ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0) * 4.0;
                let first = (part as usize).min(3);
                mixed(VIRIDIS[first], VIRIDIS[first + 1], part - first as f64)
            }
        };
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// With as many digits as tell the ends apart.
    fn label(&self, value: f64) -> String {
        let (size, width) = (self.low.abs().max(self.high.abs()), self.high - self.low);
        let value = if value.abs() < 1e-9 * size {
            0.0
        } else {
            value
        };
        let digits = ((size / width).log10().ceil().max(0.0) as usize + 2).min(9);
        let text = match (1e-3..1e4).contains(&size) {
            true => format!(
                "{value:.*}",
                (digits as i32 - size.log10().floor() as i32).max(0) as usize
            ),
            false => format!("{value:.digits$e}"),
        };
        // A minus, not a hyphen.
        text.replace('-', "−")
    }
}

/// (1−t) a + t b.
fn mixed(a: [f64; 3], b: [f64; 3], t: f64) -> [u8; 3] {
    std::array::from_fn(|i| (a[i] + t * (b[i] - a[i])).round() as u8)
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

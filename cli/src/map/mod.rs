//! Pictures as SVG: fields on a plane mesh, one panel each, and surfaces in space as they are seen from somewhere.

mod bar;
mod panel;
mod range;
mod scene;
mod surface;
mod view;

use crate::curvature::Fields;
use crate::svg::escaped;
use panel::{Plane, Shown};
use std::fmt::Write;
pub use view::{Up, View};

/// More cells than this make no picture, and an SVG that no viewer opens.
pub const LARGEST: usize = 100_000;

/// The room for a panel's title, for its colour bar, and the margin.
const TITLE: f64 = 56.0;
const BAR: f64 = 130.0;
const MARGIN: f64 = 24.0;

/// The picture: of a plane mesh R in cells (if there is any), R_h, and Θ at the vertices; of a surface in space K.
///
/// # Errors
/// If the mesh is not one of triangles, or too large, in words.
pub fn svg(fields: &Fields, title: &str, view: &View) -> Result<String, String> {
    check(fields)?;
    let mut heights = fields.points.iter().skip(2).step_by(3);
    if heights.any(|z| *z != fields.points[2]) {
        return Ok(surface::svg(fields, title, view));
    }
    let plane = Plane::new(fields);
    let panels = panels(fields);
    let step = plane.width + BAR + MARGIN;
    let width = MARGIN + panels.len() as f64 * step;
    let height = 2.0 * MARGIN + TITLE + plane.height;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" \
         viewBox=\"0 0 {width:.0} {height:.0}\" font-family=\"sans-serif\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <text x=\"{MARGIN}\" y=\"28\" font-size=\"17\">{}</text>\n",
        escaped(title)
    );
    for (i, (name, shown)) in panels.iter().enumerate() {
        let [left, top] = [MARGIN + i as f64 * step, MARGIN + TITLE];
        let _ = writeln!(
            text,
            "<g transform=\"translate({left:.1} {top:.1})\">\n<text x=\"0\" y=\"-12\" font-size=\"15\">{}</text>",
            escaped(name)
        );
        plane.panel(fields, shown, &mut text);
        text.push_str("</g>\n");
    }
    text.push_str("</svg>\n");
    Ok(text)
}

fn check(fields: &Fields) -> Result<(), String> {
    let cells = fields.cells.len() / 3;
    if fields.dimension != 2 {
        return Err(format!(
            "a picture shows triangles, the mesh has dimension {}: write a VTU file",
            fields.dimension
        ));
    }
    match cells > LARGEST {
        true => Err(format!(
            "{cells} cells are too many for a picture (the limit is {LARGEST}): write a VTU file"
        )),
        false => Ok(()),
    }
}

/// The same as PNG, twice as large for sharp text, with a font of its own: nothing depends on what is installed.
///
/// # Errors
/// In words, if the picture is too large for memory.
#[cfg(feature = "png")]
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

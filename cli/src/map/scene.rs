//! A surface as its viewer sees it: which of its triangles, in which order, in which light.

use super::view::View;
use crate::curvature::Fields;

/// Where the light comes from, as the viewer has it: right, up, towards the viewer. Normalised below.
const LIGHT: [f64; 3] = [-0.4, 0.55, 0.8];
/// How bright the darkest side is; colours must still be told apart there.
const AMBIENT: f64 = 0.5;

/// A triangle to be drawn.
pub struct Facet {
    /// Its cell.
    pub cell: usize,
    /// Its middle, by barycentric coordinates in the cell.
    pub middle: [f64; 3],
    /// Its corners: right, up, towards the viewer.
    pub corners: [[f64; 3]; 3],
    /// Between 0 and 1.
    pub light: f64,
}

/// The facets from back to front (the painter's order); of a closed surface whose triangles have one orientation those alone
/// that show the viewer their outer side.
pub fn facets(fields: &Fields, view: &View) -> Vec<Facet> {
    let seen: Vec<[f64; 3]> = fields
        .points
        .chunks_exact(3)
        .map(|x| view.seen(x))
        .collect();
    let outwards = outward(&fields.cells, &seen);
    let mut all = Vec::new();
    for piece in &fields.pieces {
        let corners = piece.corners.map(|x| view.seen(&x));
        all.extend(facet(piece.cell, piece.middle, corners, outwards));
    }
    if fields.pieces.is_empty() {
        for (cell, vertices) in fields.cells.chunks_exact(3).enumerate() {
            let corners = [0, 1, 2].map(|i| seen[vertices[i] as usize]);
            all.extend(facet(cell, [1.0 / 3.0; 3], corners, outwards));
        }
    }
    let depth = |facet: &Facet| facet.corners.iter().map(|c| c[2]).sum::<f64>();
    all.sort_by(|a, b| depth(a).total_cmp(&depth(b)));
    all
}

/// None if it shows its inner side.
fn facet(
    cell: usize,
    middle: [f64; 3],
    corners: [[f64; 3]; 3],
    outwards: Option<f64>,
) -> Option<Facet> {
    let normal = normal(&corners);
    let size = dot(&normal, &normal).sqrt();
    let turned = match outwards {
        Some(sign) if sign * normal[2] <= 0.0 => return None,
        Some(sign) => sign,
        // Both sides are looked at, and lit from the viewer's side.
        None => normal[2].signum(),
    };
    let bright = turned * dot(&normal, &LIGHT) / (size * dot(&LIGHT, &LIGHT).sqrt());
    Some(Facet {
        cell,
        middle,
        corners,
        light: AMBIENT + (1.0 - AMBIENT) * bright.clamp(0.0, 1.0),
    })
}

/// Twice the area, along the normal.
fn normal([a, b, c]: &[[f64; 3]; 3]) -> [f64; 3] {
    let (u, v) = (minus(b, a), minus(c, a));
    [
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    ]
}

fn minus(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Of a closed surface with one orientation: do the corners run counterclockwise seen from outside (1) or from inside (−1)?
fn outward(cells: &[u32], points: &[[f64; 3]]) -> Option<f64> {
    let mut edges: Vec<(u32, u32, bool)> = Vec::with_capacity(cells.len());
    for cell in cells.chunks_exact(3) {
        for i in 0..3 {
            let (a, b) = (cell[i], cell[(i + 1) % 3]);
            edges.push((a.min(b), a.max(b), a < b));
        }
    }
    edges.sort_unstable();
    let mut both = edges.chunk_by(|e, f| (e.0, e.1) == (f.0, f.1));
    // Two triangles that run along their edge in opposite directions.
    if !both.all(|edge| edge.len() == 2 && edge[0].2 != edge[1].2) {
        return None;
    }
    let volume = |cell: &[u32]| {
        let [a, b, c] = [0, 1, 2].map(|i| minus(&points[cell[i] as usize], &points[0]));
        dot(&a, &normal(&[[0.0; 3], b, c]))
    };
    let sign = cells.chunks_exact(3).map(volume).sum::<f64>().signum();
    (sign != 0.0).then_some(sign)
}

//! The geodesic interpolant: the piecewise constant metric whose edge lengths are geodesic distances.
//!
//! The geodesic of an edge is the one reached from the straight edge by continuation along (1−τ)δ + τg for τ in
//! [0, 1]. The curve is a polynomial of degree m+1 in its parameter; its energy is made stationary by Newton's method
//! with exact first and second derivatives, and m is doubled until the length stands still.

use super::curve::Curve;
use crate::Error;
use crate::field::Ambient;
use crate::linalg::Vector;
use crate::mesh::Mesh;
use crate::simplex::subsets;
use crate::spaces::ReggeSpace;

/// The change of the length under doubling of the degree that ends the refinement, relative.
const SETTLED: f64 = 1e-13;
/// Curves of higher degree are not tried: the edge is then too long for its metric.
const LARGEST_DEGREE: usize = 64;

/// The squared geodesic distances between the ends of the edges, which are the coefficients of degree 0.
///
/// # Errors
/// If the mesh lies not in ℝ^N; names the first edge whose geodesic leaves the formula's domain or is not found.
pub(super) fn coefficients<const N: usize>(
    space: &ReggeSpace<N>,
    g: &dyn Ambient<N>,
) -> Result<Vec<f64>, Error> {
    let mesh = space.mesh();
    if !mesh.has_coordinates() {
        return Err(Error::NoCoordinates("a geodesic"));
    }
    let mut coefficients = Ok(Vec::with_capacity(space.len()));
    let on_edge = |edge: usize| {
        let [a, b] = ends(mesh, edge);
        geodesic_length(g, a, b)
    };
    crate::parallel::in_order(mesh.count(1), on_edge, |edge, length| {
        if let Ok(found) = &mut coefficients {
            match length {
                Ok(length) => found.push(length * length),
                Err(reason) => coefficients = Err(no_length(mesh, edge, reason)),
            }
        }
    });
    coefficients
}

fn no_length<const N: usize>(mesh: &Mesh<N>, edge: usize, reason: String) -> Error {
    let ends = mesh.vertices(1, edge);
    Error::Edge {
        vertices: [ends[0] as usize, ends[1] as usize],
        reason,
    }
}

/// The two ends of an edge in ℝ^N, as its first cell sees them.
fn ends<const N: usize>(mesh: &Mesh<N>, edge: usize) -> [Vector<f64, N>; 2] {
    let side = mesh.first_side(1, edge);
    let local = &subsets(N + 1, 2)[side.place];
    [0, 1].map(|i| {
        mesh.corner(side.cell, local[i])
            .expect("the mesh has coordinates: this was asked before")
    })
}

/// The length of the geodesic of g from a to b that continues the straight line, to a relative 1e-12.
///
/// # Errors
/// In words, if the curve leaves the domain of g or no geodesic is found.
///
/// ```
/// use nalgebra::vector;
/// use regge_curvature::interpolate::geodesic_length;
/// use regge_curvature::metrics::Metric;
///
/// // The unit sphere in stereographic coordinates: from the pole to the equator it is a quarter of a great circle.
/// let length = geodesic_length(&Metric::Sphere, vector![0.0, 0.0], vector![0.6, 0.8]);
/// assert!((length.expect("a geodesic") - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
/// ```
pub fn geodesic_length<const N: usize>(
    g: &dyn Ambient<N>,
    a: Vector<f64, N>,
    b: Vector<f64, N>,
) -> Result<f64, String> {
    let mut degree = 4;
    let mut before = Curve::new(a, b, degree).settle(g)?;
    while degree < LARGEST_DEGREE {
        degree *= 2;
        let length = Curve::new(a, b, degree).settle(g)?;
        if (length - before).abs() <= SETTLED * length {
            return Ok(length);
        }
        before = length;
    }
    Err(format!(
        "its geodesic has no polynomial of degree {LARGEST_DEGREE}: refine the mesh"
    ))
}

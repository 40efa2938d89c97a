//! Curvature bounded over whole simplices: R on cells, ⟦H⟧ on faces, Θ on hinges.

use super::bound::{Effort, enclose};
use super::boxes::{OnCell, View, exponents};
use super::metric::proven_metric;
use crate::Error;
use crate::density::{Corner, Side};
use crate::formulas::PAPER;
use crate::jet::{Jet1, lower};
use crate::linalg::inverse_and_det;
use crate::mesh::{self, Mesh};
use crate::parallel::collect;
use crate::riemann::{Connection, Curvature};
use crate::scalar::{Field, Interval};
use crate::simplex::subsets;
use crate::spaces::ReggeFunction;

/// Bounds that hold at every point of a simplex; undefined where none were found.
#[derive(Clone, Debug, PartialEq)]
pub struct EnclosedCurvature {
    /// By cell: R.
    pub scalar: Vec<Interval>,
    /// By face: ⟦H⟧, the sum of H from both sides; on the boundary H.
    pub jumps: Vec<Interval>,
    /// By hinge: Θ = 2π − Σ_T θ_T, in radians; π − Σ_T θ_T on the boundary.
    pub defects: Vec<Interval>,
}

/// Bounds need not be closer than a tenth of the larger one. Their sign is known then.
const EFFORT: Effort = Effort {
    relative: 0.1,
    parts: 64,
};

/// Bounds of R, ⟦H⟧ and Θ over whole cells, faces and hinges, of a metric of any degree whose coefficients are taken to be exact.
///
/// # Errors
/// If it cannot be shown that g is positive definite everywhere: see [`proven_metric`].
pub fn enclosed_curvature<const N: usize>(
    g: &ReggeFunction<f64, N>,
) -> Result<EnclosedCurvature, Error> {
    proven_metric(g)?;
    let (mesh, degree) = (g.space().mesh(), g.space().degree());
    let on_cells = exponents(N + 1, degree);
    let cells: Vec<OnCell<N>> = collect(mesh.cell_count(), |cell| OnCell::new(g, cell, &on_cells));
    let views = |k: usize, simplex: usize, on: &_| -> Vec<View<N>> {
        let places = subsets(N + 1, k + 1);
        let see = |side: mesh::Side| cells[side.cell].on(&places[side.place], &on_cells, on);
        mesh.star(k, simplex).map(see).collect()
    };
    let (on_faces, on_hinges) = (exponents(N, degree), exponents(N - 1, degree));
    Ok(EnclosedCurvature {
        scalar: collect(mesh.cell_count(), |cell| {
            enclose(vec![cells[cell].whole.clone()], &on_cells, EFFORT, &scalar)
        }),
        jumps: collect(mesh.count(N - 1), |face| {
            enclose(views(N - 1, face, &on_faces), &on_faces, EFFORT, &jump)
        }),
        defects: collect(mesh.count(N - 2), |hinge| {
            let full = full_angle(mesh, hinge);
            let defect = |views: &[View<N>]| full - angles(views);
            enclose(views(N - 2, hinge, &on_hinges), &on_hinges, EFFORT, &defect)
        }),
    })
}

fn full_angle<const N: usize>(mesh: &Mesh<N>, hinge: usize) -> Interval {
    match mesh.is_interior(N - 2, hinge) {
        true => Interval::pi() + Interval::pi(),
        false => Interval::pi(),
    }
}

fn scalar<const N: usize>(views: &[View<N>]) -> Interval {
    let g = views[0].jet2();
    Curvature::new(&g, &Connection::new(&lower(&g))).scalar()
}

fn jump<const N: usize>(views: &[View<N>]) -> Interval {
    let of = |view: &View<N>| {
        let connection = Connection::new(&view.jet1());
        Side::new(&PAPER, &connection, &view.nu[0].map(Jet1::constant)).mean_curvature
    };
    views
        .iter()
        .fold(Interval::zero(), |sum, view| sum + of(view))
}

/// Σ_T θ_T.
fn angles<const N: usize>(views: &[View<N>]) -> Interval {
    let of = |view: &View<N>| {
        let (inverse, det) = inverse_and_det(&view.value());
        let (sin, cos) = Corner::new(&PAPER, &inverse, det, [&view.nu[0], &view.nu[1]]).dihedral();
        Interval::angle(sin, cos)
    };
    views
        .iter()
        .fold(Interval::zero(), |sum, view| sum + of(view))
}

//! ‖·‖_{0,h,g}.

use super::{Faces, indefinite, rules};
use crate::best::Form;
use crate::local::{Gram, frame_of, push_components, tensors};
use crate::pieces::{Pieces, Unknowns, diameter};
use regge_curvature::Error;
use regge_curvature::density::{Normal, omega, outward};
use regge_curvature::field::Evaluate;
use regge_curvature::formulas::PAPER;
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, inverse_and_det};
use regge_curvature::quadrature::Rule;
use regge_curvature::riemann::reverse_trace;
use regge_curvature::simplex::subsets;

/// ‖𝕊_g σ‖²_{0,h,g} over the σ of these unknowns; the paper's with [`Faces::all`]`(1)`.
///
/// # Errors
/// As [`tensors`], and if g is not positive definite.
pub fn zero_norm<const N: usize, G: Evaluate<f64, N>>(
    pieces: &Pieces<N>,
    u: &Unknowns<N>,
    g: &G,
    faces: Faces,
    order: usize,
) -> Result<Form, Error> {
    let [cells, sides] = rules::<N>(order);
    let apart = pieces.regge_apart(u.tensors.degree());
    let (basis, table) = (tensors(&apart, cells.points())?, g.tabulate(cells.points()));
    let mut form = Form::zero(u.len());
    for cell in 0..pieces.mesh.cell_count() {
        let (local, mut gram) = (g.on_cell(cell), Gram::new(basis[0].len()));
        for (point, weight) in cells.weights().iter().enumerate() {
            let g = g.value(&local, &table, point);
            let (inverse, det) = inverse_and_det(&g);
            let frame = frame_of(&g).ok_or_else(indefinite)?;
            let of = |psi: &Mat<_, N>| {
                let mut all = Vec::new();
                let value = psi.map(|x: Jet2<f64, N>| x.value);
                push_components(
                    &reverse_trace(&PAPER, &g, &inverse, &value),
                    &frame,
                    &mut all,
                );
                all
            };
            let all: Vec<_> = basis[point].iter().map(of).collect();
            gram.add(weight * omega(&PAPER, det), &all);
        }
        form.add(&u.of_tensors(cell), &gram.matrix());
    }
    add_normal_components(pieces, u, g, faces, &sides, &mut form)?;
    Ok(form)
}

/// Adds Σ_F h_F^power ‖𝕊σ(n,n)‖².
fn add_normal_components<const N: usize, G: Evaluate<f64, N>>(
    pieces: &Pieces<N>,
    u: &Unknowns<N>,
    g: &G,
    faces: Faces,
    sides: &Rule,
    form: &mut Form,
) -> Result<(), Error> {
    let apart = pieces.regge_apart(u.tensors.degree());
    for (place, vertices) in subsets(N + 1, N).iter().enumerate() {
        let points = sides.points().embed(vertices, N + 1);
        let (basis, table) = (tensors(&apart, &points)?, g.tabulate(&points));
        for face in 0..pieces.mesh.count(N - 1) {
            let side = pieces.mesh.first_side(N - 1, face);
            if side.place != place || !faces.has(pieces.mesh.is_interior(N - 1, face)) {
                continue;
            }
            let (local, mut gram) = (g.on_cell(side.cell), Gram::new(basis[0].len()));
            let h = diameter(&pieces.mesh, side.cell, vertices).powi(faces.power);
            for (point, weight) in sides.weights().iter().enumerate() {
                let g = g.value(&local, &table, point);
                let (inverse, det) = inverse_and_det(&g);
                let normal = Normal::new(&PAPER, &inverse, det, &outward(N - place));
                let of = |psi: &Mat<_, N>| {
                    let value = psi.map(|x: Jet2<f64, N>| x.value);
                    vec![normal.normal_normal(&reverse_trace(&PAPER, &g, &inverse, &value))]
                };
                let all: Vec<_> = basis[point].iter().map(of).collect();
                gram.add(weight * normal.omega * h, &all);
            }
            form.add(&u.of_tensors(side.cell), &gram.matrix());
        }
    }
    Ok(())
}

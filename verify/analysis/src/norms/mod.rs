//! Floor 2. The norms of section 4 as quadratic forms on V_h and on Regge spaces.

mod two;
mod zero;

pub use two::{Basis, two_norm};
pub use zero::zero_norm;

use crate::best::Form;
use crate::local::{Gram, function_components, functions, tensor_components, tensors};
use crate::pieces::{Pieces, Unknowns, stretch};
use nalgebra::DMatrix;
use regge_curvature::Error;
use regge_curvature::linalg::Mat;
use regge_curvature::quadrature::Rule;

/// Terms Σ_T h_T^power |·|²_{H^order(T)}.
pub type Terms<'a> = &'a [(usize, i32)];

/// Σ_T h_T^power |σ|²_{H^order(T)}, Euclidean, over the σ of these unknowns.
///
/// # Errors
/// As [`tensors`].
pub fn of_tensors<const N: usize>(
    pieces: &Pieces<N>,
    u: &Unknowns<N>,
    terms: Terms<'_>,
) -> Result<Form, Error> {
    let degree = u.tensors.degree();
    let rule = Rule::new(N, 2 * degree);
    let basis = tensors(&pieces.regge_apart(degree), rule.points())?;
    let mut form = Form::zero(u.len());
    for cell in 0..pieces.mesh.cell_count() {
        let gram = seminorms(pieces, cell, &rule, terms, &basis, tensor_components);
        form.add(&u.of_tensors(cell), &gram);
    }
    Ok(form)
}

/// Σ_T h_T^power |v|²_{H^order(T)}, Euclidean, over the v of these unknowns.
pub fn of_functions<const N: usize>(pieces: &Pieces<N>, u: &Unknowns<N>, terms: Terms<'_>) -> Form {
    let rule = Rule::new(N, 2 * u.functions.degree());
    let basis = functions(u.functions.degree(), rule.points());
    let mut form = Form::zero(u.len());
    for cell in 0..pieces.mesh.cell_count() {
        let gram = seminorms(pieces, cell, &rule, terms, &basis, function_components);
        form.add(&u.of_functions(cell), &gram);
    }
    form
}

/// The matrix of a sum of seminorms on one cell, over a basis at the points of a rule; `components` has the derivatives of an order in a frame.
fn seminorms<X, const N: usize>(
    pieces: &Pieces<N>,
    cell: usize,
    rule: &Rule,
    terms: Terms<'_>,
    basis: &[Vec<X>],
    components: fn(&X, &Mat<f64, N>, usize) -> Vec<f64>,
) -> DMatrix<f64> {
    let (frame, h) = (pieces.euclidean_frame(cell), pieces.diameter(cell));
    let volume = stretch(&pieces.mesh, cell);
    let mut gram = Gram::new(basis[0].len());
    for (weight, here) in rule.weights().iter().zip(basis) {
        for &(order, power) in terms {
            let all: Vec<_> = (here.iter())
                .map(|x| components(x, &frame, order))
                .collect();
            gram.add(weight * volume * h.powi(power), &all);
        }
    }
    gram.matrix()
}

/// Which faces a norm of section 4 sums over, and with which power of h_F.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Faces {
    /// Those inside.
    pub interior: bool,
    /// Those of the boundary.
    pub boundary: bool,
    /// The power of h_F.
    pub power: i32,
}

impl Faces {
    /// All, with this power.
    pub const fn all(power: i32) -> Self {
        Self {
            interior: true,
            boundary: true,
            power,
        }
    }

    fn has(&self, interior: bool) -> bool {
        if interior {
            self.interior
        } else {
            self.boundary
        }
    }
}

/// The rules of cells and faces: of one order, so that the inequality of Cauchy and Schwarz for b_h, whose points have the same
/// positive weights, holds for the sums as it does for the integrals.
fn rules<const N: usize>(order: usize) -> [Rule; 2] {
    [Rule::new(N, order), Rule::new(N - 1, order)]
}

fn indefinite() -> Error {
    Error::Solver("a metric of the analysis is not positive definite".into())
}

//! Is a Regge function a metric, everywhere?

use super::bound::Part;
use super::boxes::{OnCell, exponents};
use super::polynomial::Exponents;
use crate::Error;
use crate::linalg::{Mat, ldlt};
use crate::parallel::in_order;
use crate::scalar::Interval;
use crate::spaces::ReggeFunction;

/// More parts of a cell are not looked at.
const MOST: usize = 4096;

/// That g is positive definite at every point of every cell, as a theorem about its coefficients.
///
/// On a simplex g = Σ_α B_α C_α with B_α ≥ 0: it is positive definite where all of its Bernstein coefficients C_α are. A cell on
/// which they are not is halved, and so on. Coefficients are intervals with outward rounding.
///
/// # Errors
/// Names the first cell with a point where g is not positive definite, or of which it could not be told.
pub fn proven_metric<const N: usize>(g: &ReggeFunction<f64, N>) -> Result<(), Error> {
    let mesh = g.space().mesh();
    let exponents = exponents(N + 1, g.space().degree());
    let mut first = Ok(());
    let on_cell = |cell: usize| {
        let whole = OnCell::new(g, cell, &exponents).whole;
        positive(cell, Part::whole(vec![whole], N + 1), &exponents)
    };
    in_order(mesh.cell_count(), on_cell, |_, found| {
        if first.is_ok() {
            first = found;
        }
    });
    first
}

/// What is known of a symmetric matrix.
enum Sign {
    Positive,
    /// With a pivot that is not positive.
    NotPositive(f64),
    Unknown,
}

fn sign<const N: usize>(matrix: &Mat<Interval, N>) -> Sign {
    for pivot in ldlt(matrix).factors.diagonal().iter() {
        if pivot.high() <= 0.0 {
            return Sign::NotPositive(pivot.high());
        }
        if !pivot.is_positive() {
            return Sign::Unknown;
        }
    }
    Sign::Positive
}

fn positive<const N: usize>(
    cell: usize,
    whole: Part<N>,
    exponents: &[Exponents; 3],
) -> Result<(), Error> {
    let (mut open, mut seen) = (vec![whole], 0);
    while let Some(part) = open.pop() {
        seen += 1;
        let mut proven = true;
        for (matrix, alpha) in part.views[0].coefficients().zip(&exponents[0].all) {
            let sign = sign(&matrix);
            // At a vertex the coefficient is the value.
            let vertex = alpha.iter().position(|e| *e == exponents[0].degree);
            if let (Sign::NotPositive(pivot), Some(vertex)) = (&sign, vertex) {
                return Err(Error::Indefinite {
                    cell,
                    point: part.corners[vertex].clone(),
                    pivot: *pivot,
                });
            }
            proven &= matches!(sign, Sign::Positive);
        }
        if !proven && (seen > MOST || exponents[0].degree == 0) {
            return Err(Error::Cell {
                cell,
                reason:
                    "it cannot be told whether the metric is positive definite everywhere on it"
                        .to_owned(),
            });
        }
        if !proven {
            open.extend(part.halves(exponents));
        }
    }
    Ok(())
}

//! Floor 4. What a metric puts on cells, faces and hinges: the densities R ω, G ω, H ω_F, II‾ ω_F, Θ ω_S and what they are
//! made of, each in one place.
//!
//! | where | type | from | has |
//! |---|---|---|---|
//! | in a cell T | [`Inside`] | g's second-order jets | R, G, ω |
//! | on a face F, from one side | [`Side`] | g's first-order jets and ν | n, II, H, II‾, ω_F |
//! | at a hinge S, in one cell | [`Corner`] | g and two ν | θ, conormals, Tr on S, ω_S |
//!
//! A density is evaluated from a [`Connection`] that stands where it was made: to move one made of wide scalars costs as much
//! as to compute it. [`Volume`] and [`Corner`] are the only places that know that g is positive definite.

mod corner;
mod side;

pub use corner::Corner;
pub use side::{Normal, Side, surface_div};

use crate::formulas::{Formulas, times};
use crate::jet::Jet2;
use crate::linalg::{Mat, Vector, vector};
use crate::riemann::{Connection, Curvature};
use crate::scalar::{Algebraic, Field};

/// Volumes and lengths of a positive definite metric.
#[derive(Clone, Copy, Debug)]
pub struct Volume;

impl Volume {
    /// √det: the volume of the reference measure's unit, from the determinant of the metric on the simplex.
    #[inline]
    pub fn from_det<F: Algebraic>(det: F) -> F {
        det.sqrt()
    }

    /// The length of a vector or covector, from its product with itself.
    #[inline]
    pub fn length<F: Algebraic>(square: F) -> F {
        square.sqrt()
    }
}

/// A metric at a point of a cell.
#[derive(Clone, Copy, Debug)]
pub struct Inside<'c, F: Field, const N: usize> {
    formulas: &'c Formulas,
    connection: &'c Connection<F, N>,
    curvature: Curvature<'c, F, N>,
}

impl<'c, F: Algebraic, const N: usize> Inside<'c, F, N> {
    /// From jets of g and their connection.
    #[inline]
    pub fn new(
        formulas: &'c Formulas,
        g: &'c Mat<Jet2<F, N>, N>,
        connection: &'c Connection<F, N>,
    ) -> Self {
        Self {
            formulas,
            connection,
            curvature: Curvature::new(g, connection),
        }
    }

    /// R ω relative to the reference measure of the cell. Paper: def:distcurv.
    #[inline]
    pub fn scalar(&self) -> F {
        let r = times(self.formulas.scalar, self.curvature.scalar());
        r * omega(self.formulas, self.connection.det)
    }

    /// (G, ω), G_ij with lower indices. Paper: def:distein.
    #[inline]
    pub fn einstein(&self) -> (Mat<F, N>, F) {
        (
            self.curvature.einstein(self.formulas),
            omega(self.formulas, self.connection.det),
        )
    }
}

/// ω = √det g relative to the reference measure of the cell.
#[inline]
pub fn omega<F: Algebraic>(formulas: &Formulas, det: F) -> F {
    times(formulas.omega, Volume::from_det(det))
}

/// −dλ_f in reference coordinates, which points out of the cell across the face opposite to vertex f.
#[inline]
pub fn outward<F: Field, const N: usize>(opposite: usize) -> Vector<F, N> {
    vector(|i| match opposite {
        0 => F::one(),
        f if f == i + 1 => -F::one(),
        _ => F::zero(),
    })
}

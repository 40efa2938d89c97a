//! Identities between exact integrals.

use super::fields::Fields;
use crate::exact::Fp;
use crate::harness::{
    Cases, Catalogue, Check, Equation, Excuses, Judgement, Kind, Method, OnNumbers, Record,
};
use regge_curvature::formulas::Formulas;

/// An identity between integrals of polynomials.
pub trait ByParts: 'static {
    /// That of the claim.
    const RECORD: Record;

    /// The equations between the integrals of the fields that these numbers make, the library computing by these formulas.
    fn equations<const N: usize>(numbers: &[Fp], formulas: &Formulas) -> Vec<Equation<Fp>>;
}

/// Adds an identity in dimension N.
pub fn add<C: ByParts, const N: usize>(all: &mut Catalogue) {
    all.push(Check {
        record: &C::RECORD,
        dimension: N,
        method: Method::Exact,
        excuses: Excuses::NONE,
        kind: Kind::Exact(OnNumbers {
            // One identity of integrals in the coefficients of the fields: degree ≤ 2 · 40 in L's, 1 in σ's and w's.
            judgement: Judgement::Exact { degree: 100.0 },
            cases: cases(N),
            count: Fields::<N>::COUNT,
            equations: C::equations::<N>,
            shrinks: false,
        }),
    });
}

/// 2⁻⁵⁴ a draw: two are enough; on the tetrahedron each takes seconds.
fn cases(dimension: usize) -> Cases {
    if dimension == 2 {
        Cases { full: 4, quick: 2 }
    } else {
        Cases { full: 2, quick: 1 }
    }
}

//! Identities between exact integrals.

use super::fields::Fields;
use super::integrals::Exactly;
use crate::exact::{Recorded, Step, degrees, record};
use crate::harness::{
    Bound, Cases, Catalogue, Check, Equation, Excuses, Ground, Integrals, Kind, Method, Record,
};
use regge_curvature::formulas::Formulas;

/// An identity between integrals of polynomials.
pub trait ByParts: 'static {
    /// That of the claim.
    const RECORD: Record;
    /// On a simplex that is cut at an inner point, or on a single one?
    const CUT: bool = false;

    /// The equations between the integrals of the fields that these numbers make, the library computing by these formulas.
    fn equations<F: Ground, const N: usize>(numbers: &[F], formulas: &Formulas)
    -> Vec<Equation<F>>;
}

/// Adds an identity in dimension N.
pub fn add<C: ByParts, const N: usize>(all: &mut Catalogue) {
    all.push(Check {
        record: &C::RECORD,
        dimension: N,
        method: Method::Exact,
        excuses: Excuses::NONE,
        kind: Kind::Integrals(Integrals {
            cases: cases(N),
            count: Fields::<Recorded, N>::COUNT,
            in_p: C::equations::<_, N>,
            in_q: C::equations::<_, N>,
            bound: bound::<C, N>,
        }),
    });
}

/// Half of them over either field; on the tetrahedron each takes seconds.
fn cases(dimension: usize) -> Cases {
    if dimension == 2 {
        Cases { full: 4, quick: 2 }
    } else {
        Cases { full: 2, quick: 2 }
    }
}

/// Every integral is a combination of densities at points, with weights that do not depend on the fields: its degree in their
/// coefficients is at most that of the densities. The points' coordinates are inputs of a group of their own.
///
/// The integrals have no roots: the densities are polynomials, or else the rules would not integrate them, and the claims
/// would fail. A draw must have the roots that are the same at all points of a simplex; elsewhere points are taken that have
/// them.
fn bound<C: ByParts, const N: usize>(formulas: &Formulas) -> Bound {
    let on = if C::CUT {
        Exactly::on_cut
    } else {
        Exactly::<Recorded, N>::on_single
    };
    let count = Fields::<Recorded, N>::COUNT;
    let (program, densities) = record(count + N + 1, |inputs| {
        let (numbers, lambda) = inputs.split_at(count);
        on(numbers, formulas).densities(lambda)
    });
    let mut groups = vec![0; count];
    groups.resize(count + N + 1, 1);
    let degree = degrees(&program, &groups, &densities).by_group[0];
    let needed = program.needed(densities);
    let varies = program.depending(&|k| k >= count);
    let constant = |k: &usize| needed[*k] && !varies[*k];
    let roots = (0..needed.len()).filter(constant);
    let roots = roots.filter(|k| matches!(program.steps()[*k], Step::Root(_)));
    Bound {
        degree,
        by_group: vec![("coefficients".to_owned(), degree)],
        roots: 0,
        roots_drawn: roots.count() as u32,
    }
}

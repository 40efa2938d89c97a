//! Identities between exact integrals.

use super::fields::Fields;
use super::integrals::Exactly;
use super::roots::{Suspect, roots};
use crate::exact::{Recorded, degrees, record};
use crate::harness::{
    Bound, Cases, Catalogue, Check, Equation, Excuses, Ground, Integrals, Key, Kind, Method, Record,
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
/// How many roots a density contains is counted: none, or else the rules would not integrate it. A draw must have the roots that are the same at all points of a simplex;
/// elsewhere points are taken that have them.
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
    let varies = program.depending(&|k| k >= count);
    let key = Key {
        seed: 0,
        label: C::RECORD.label,
        dimension: N,
        method: Method::Exact.name(),
        case: 0,
    };
    let in_one = |density: &Recorded| {
        let mut roots = roots(&program, &[*density]);
        roots.retain(|k| varies[*k]);
        let suspect = Suspect {
            program: &program,
            result: *density,
            roots,
            inputs: count + N + 1,
        };
        suspect.contained(key)
    };
    let in_all = roots(&program, &densities);
    Bound {
        degree,
        by_group: vec![("coefficients".to_owned(), degree)],
        roots: densities.iter().map(in_one).max().unwrap_or(0),
        roots_drawn: in_all.iter().filter(|k| !varies[**k]).count() as u32,
    }
}

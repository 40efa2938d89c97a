//! Claims that hold at a point: one body for floating point numbers and for the prime field.

use super::instance::Instance;
use super::reduced::{FORMS, Form, extra, is_second, moved, reduced, variables};
use crate::exact::Recorded;
use crate::harness::{
    AtPoints, Cases, Catalogue, Check, Equation, Excuses, Judgement, Kind, Method, Moved,
    OnNumbers, OnPrograms, Proofs, Record, Timed, Variable, has, list,
};
use num_dual::Dual64;
use regge_curvature::formulas::Formulas;
use regge_curvature::jet::Jet1;
use regge_curvature::scalar::Field;

/// The scalars that a pointwise claim runs over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// Floating point numbers with derivatives, and the prime fields.
    Both,
    /// The same; in floating point numbers it is an oracle, a formula with a source outside this project.
    Oracle,
    /// Integers only: over the prime fields.
    Integers,
    /// Inequalities (see [`Equation::at_most`]): not over a field without order.
    Ordered,
}

/// One statement that holds at every point, for any jets of the metric.
///
/// The body is written once. Over `Dual64` it differentiates in time through the library's own code; over
/// `Jet1<Recorded, 1>` the same code leaves its program, which is exact over prime fields. Densities are computed by [`Instance::formulas`].
pub trait Pointwise: 'static {
    /// What the page says.
    const RECORD: Record;
    /// Where it is meaningful.
    const DIMENSIONS: &'static [usize] = &[2, 3, 4, 5];
    /// |left − right| over the sum of the terms' magnitudes. Terms are sums of up to N⁴ products through g⁻¹ and
    /// ∂g⁻¹; the instances' condition numbers are below 10², so that rounding is amplified by less than 10⁴.
    const TOLERANCE: f64 = 1e-11;
    /// Where it is proved at points that determine it, where it is meaningful; elsewhere, or if its degree is too large, it is
    /// tested.
    const PROVED: &'static [usize] = &[2, 3, 4, 5];
    /// By which scalars.
    const OVER: Over = Over::Both;
    /// Why there is one method only.
    const EXCUSES: Excuses = Excuses::NONE;

    /// The equations at one instance.
    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>>;
}

/// So many instances in each of four dimensions.
const REAL: Cases = Cases { full: 24, quick: 6 };
/// The same over the field, where one instance is proof enough.
const EXACT: Cases = Cases { full: 8, quick: 4 };

/// A claim in one or two dimensions has as many instances as one in four.
fn over_all(cases: Cases, dimensions: &[usize]) -> Cases {
    let times = 4 / dimensions.len().min(4);
    Cases {
        full: cases.full * times,
        quick: cases.quick * times,
    }
}

/// Adds a claim in dimension N by both methods, as far as it is meaningful there.
///
/// The conditions are constants, so that nothing is compiled for dimensions and scalars that a claim does not have. There
/// is one caller for each claim and dimension: inlined, it is no function of its own.
#[inline(always)]
pub fn add<C: Pointwise, const N: usize>(all: &mut Catalogue) {
    if const { has(C::DIMENSIONS, N) && !matches!(C::OVER, Over::Integers) } {
        let method = match C::OVER {
            Over::Oracle => Method::Oracle,
            _ => Method::Ad,
        };
        let judgement = match C::OVER {
            Over::Ordered => Judgement::Bound,
            _ => Judgement::Rounding {
                tolerance: C::TOLERANCE,
            },
        };
        let check = on_numbers::<C, Dual64, N>(REAL, judgement);
        all.push(of_claim::<C>(N, method, Kind::Real(check)));
    }
    if const { has(C::DIMENSIONS, N) && !matches!(C::OVER, Over::Ordered) } {
        let check = OnPrograms {
            cases: over_all(EXACT, C::DIMENSIONS),
            groups: groups::<N>,
            claim: recorded::<C, N>(),
        };
        all.push(of_claim::<C>(N, Method::Exact, Kind::Programs(check)));
        if const { has(C::PROVED, N) } {
            let proof = Proofs {
                claim: recorded::<C, N>(),
                forms: FORMS.len(),
                describe,
                second: is_second,
                allows,
                groups: groups::<N>,
                variables: variables_of::<N>,
                changes: changes::<N>,
            };
            all.push(of_claim::<C>(N, Method::Proof, Kind::Proof(proof)));
        }
    }
}

#[inline(always)]
fn of_claim<C: Pointwise>(dimension: usize, method: Method, kind: Kind) -> Check {
    Check {
        record: &C::RECORD,
        dimension,
        method,
        excuses: C::EXCUSES,
        kind,
    }
}

#[inline(always)]
fn on_numbers<C: Pointwise, S: Timed, const N: usize>(
    cases: Cases,
    judgement: Judgement,
) -> OnNumbers<S::Base> {
    OnNumbers {
        judgement,
        cases: over_all(cases, C::DIMENSIONS),
        count: Instance::<S, N>::count(),
        equations: equations::<C, S, N>,
        shrinks: true,
    }
}

// No closures: of those, each claim would have its own.

fn describe(form: usize) -> &'static str {
    Form::of(form).describe()
}

fn allows(form: usize, group: &str) -> bool {
    Form::of(form).allows(group)
}

fn variables_of<const N: usize>(form: usize) -> Vec<Variable> {
    variables::<N>(Form::of(form))
}

fn changes<const N: usize>(form: usize) -> usize {
    match Form::of(form).is_free() {
        true => 0,
        false => extra::<N>(),
    }
}

/// A scalar whose use is recorded, with a derivative in time.
type Recording = Jet1<Recorded, 1>;

/// A claim in one dimension, recorded. What is asked of it is compiled once for each dimension and not for each claim.
#[derive(Debug)]
struct Claim<const N: usize> {
    equations: fn(&Instance<Recording, N>) -> Vec<Equation<Recorded>>,
}

#[inline(always)]
fn recorded<C: Pointwise, const N: usize>() -> &'static Claim<N> {
    const {
        &Claim {
            equations: C::equations::<Recording, N>,
        }
    }
}

impl<const N: usize> AtPoints for Claim<N> {
    fn equations(&self, numbers: &[Recorded], formulas: &Formulas) -> Vec<Equation<Recorded>> {
        (self.equations)(&Instance::from_numbers(numbers, formulas))
    }

    fn reduced(
        &self,
        form: usize,
        numbers: &[Recorded],
        formulas: &Formulas,
    ) -> (Vec<Equation<Recorded>>, Vec<Recorded>) {
        let (instance, roots) = reduced(Form::of(form), numbers, formulas);
        ((self.equations)(&instance), roots)
    }

    /// The coordinates are x = A y, A upper triangular and all ones.
    fn elsewhere(
        &self,
        form: usize,
        numbers: &[Recorded],
        formulas: &Formulas,
    ) -> Vec<Equation<Recorded>> {
        let form = Form::of(form);
        let (instance, _) = reduced(form, numbers, formulas);
        if form.is_free() {
            return (self.equations)(&instance);
        }
        let below = |k: usize| k < N * N && k / N > k % N;
        let ones = list(extra::<N>(), |k| Recorded::from_int(i64::from(!below(k))));
        (self.equations)(&moved(form, &instance, &ones).0)
    }

    fn moved(&self, form: usize, numbers: &[Recorded], formulas: &Formulas) -> Moved {
        let count = numbers.len() - extra::<N>();
        let instance = Instance::from_numbers(&numbers[..count], formulas);
        let (other, moves) = moved(Form::of(form), &instance, &numbers[count..]);
        Moved {
            before: (self.equations)(&instance),
            after: (self.equations)(&other),
            moves,
        }
    }
}

/// What the numbers of an instance are.
fn groups<const N: usize>() -> Vec<String> {
    Instance::<Dual64, N>::groups()
}

/// What the harness calls: all that is compiled for each claim, scalar and dimension.
fn equations<C: Pointwise, S: Timed, const N: usize>(
    numbers: &[S::Base],
    formulas: &Formulas,
) -> Vec<Equation<S::Base>> {
    C::equations::<S, N>(&Instance::from_numbers(numbers, formulas))
}

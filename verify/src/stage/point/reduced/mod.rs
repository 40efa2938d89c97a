//! Instances in a normal position, to which every instance is brought by a constant linear change of coordinates.
//!
//! Where g(x) = δ and n(x) = e_N, the library's formulas are polynomials in the jets. A [`Form`] is such a position; what a
//! claim must not depend on in order to be brought there, and which changes of coordinates do it, is said with each.

mod form;
mod moved;
mod slots;

pub(super) use form::{FORMS, Form, is_second};
pub(super) use moved::{extra, moved};

use super::draw::vary2;
use super::instance::Instance;
use crate::harness::{Ground, Timed, Variable, list};
use num_dual::Dual64;
use regge_curvature::formulas::{Formulas, PAPER};
use regge_curvature::jet::{Jet1, Jet2, lower};
use regge_curvature::linalg::{Mat, Vector, identity, matrix, symmetric, vector, zeros};
use regge_curvature::scalar::Field;
use slots::Slots;

/// What the numbers of an instance in this form are.
pub(super) fn variables<const N: usize>(form: Form) -> Vec<Variable> {
    let mut slots = Slots::new(None);
    arrange::<Dual64, N>(form, &mut slots, &PAPER);
    slots.variables
}

/// The instance in this form with these numbers, and what can be under a root there: products of these.
#[inline(never)]
pub(super) fn reduced<S: Timed, const N: usize>(
    form: Form,
    numbers: &[S::Base],
    formulas: &Formulas,
) -> (Instance<S, N>, Vec<S::Base>) {
    arrange(form, &mut Slots::new(Some(numbers)), formulas)
}

/// The k-th unit vector, times p.
fn unit<B: Ground, const N: usize>(k: usize, p: B) -> Vector<B, N> {
    vector(|i| if i == k { p } else { B::zero() })
}

fn arrange<S: Timed, const N: usize>(
    form: Form,
    slots: &mut Slots<'_, S::Base>,
    formulas: &Formulas,
) -> (Instance<S, N>, Vec<S::Base>) {
    let mut roots = Vec::new();
    let place = match form {
        Form::Place => list(12, |k| slots.parameter(format!("x{}", k + 1))),
        Form::Functions => list(12, |k| match (k / 3, k % 3 + 1) {
            (0, i) => slots.parameter(format!("x{i}")),
            (1, i) => slots.parameter(format!("f{i}")),
            (2, i) => slots.jet("f′", format!("f{i}′")),
            (_, i) => slots.jet("f″", format!("f{i}″")),
        }),
        _ => vec![S::Base::zero(); 12],
    };
    let (one, nu_bar) = angle(form, slots, &mut roots);
    let undefined = || -> Mat<S::Base, N> { matrix(|_, _| S::Base::from_real(f64::NAN)) };
    let g = if form == Form::Other {
        undefined().map(Jet2::constant)
    } else {
        slots.tensor(Some(&one), "g")
    };
    let sigma: Mat<Jet2<S::Base, N>, N> = slots.tensor(None, "σ");
    let other_inverse = (form == Form::Inverse).then(|| other_inverse(slots, &mut roots));
    let other = match form {
        Form::Inverse => undefined(),
        Form::Pair => diagonal(slots),
        _ => identity(),
    };
    let other = lower(&slots.tensor(Some(&other), "g̃"));
    let torn =
        (form == Form::Torn).then(|| torn::<_, N>(slots, &mut roots, Instance::<S, N>::tear()));
    let x = (form == Form::Vector).then(|| {
        roots.push(slots.parameter("p".to_owned()));
        unit(N - 1, roots[0])
    });
    let slope: Vector<S::Base, N> = unit(N - 1, S::Base::one());
    let phi = slots.second(
        Jet1 {
            value: S::Base::zero(),
            d: slope.into(),
        },
        "φ",
        "",
    );
    let v = (form == Form::Conformal).then(|| slots.parameter("v".to_owned()));
    let instance = Instance {
        moving_g: g.zip_map(&sigma, vary2::<S, N>),
        g,
        sigma,
        phi,
        fields: [slots.field(x.as_ref(), "X", ""), slots.field(None, "Y", "")],
        v: slots.jet2(v, "v", ""),
        alpha: Vector::from_fn(|k, _| slots.jet1(torn.map(|a| a[k]), "α", &format!("{}", k + 1))),
        nu_bar,
        nu_rate: Vector::from_fn(|k, _| slots.jet1::<0>(None, "ν̇", &format!("{}", k + 1)).value),
        seeds: list(N - 1, |k| {
            slots.field(Some(&unit(k, S::Base::one())), "τ", &format!("{}_", k + 1))
        }),
        other,
        other_inverse,
        any: (form == Form::Other).then(|| ["n¹", "n²"].map(|name| slots.vector(name))),
        spare: std::array::from_fn(|k| place[k]),
        formulas: *formulas,
    };
    (instance, roots)
}

/// g, and the covector of the other face of a hinge. With s = 2u and c = 1 − u², √(s² + c²) is 1 + u².
fn angle<B: Ground, const N: usize>(
    form: Form,
    slots: &mut Slots<'_, B>,
    roots: &mut Vec<B>,
) -> (Mat<B, N>, Vector<B, N>) {
    let mut g = identity::<B, N>();
    if !matches!(form, Form::Normal | Form::Hinge | Form::Other | Form::Torn) {
        return (g, unit(N - 2, B::one()));
    }
    let u = slots.parameter("u".to_owned());
    let (sin, cos, length) = (u + u, B::one() - u * u, B::one() + u * u);
    roots.extend([u, length]);
    if form == Form::Hinge {
        g[(N - 2, N - 1)] = cos / length;
        g[(N - 1, N - 2)] = cos / length;
    }
    (g, unit::<B, N>(N - 2, sin) + unit::<B, N>(N - 1, cos))
}

/// A metric with positive numbers on its diagonal.
fn diagonal<B: Ground, const N: usize>(slots: &mut Slots<'_, B>) -> Mat<B, N> {
    let mut metric = zeros();
    for k in 0..N {
        metric[(k, k)] = slots.parameter(format!("l{}", k + 1));
    }
    metric
}

/// g̃⁻¹, by which e_N has the length q.
fn other_inverse<B: Ground, const N: usize>(
    slots: &mut Slots<'_, B>,
    roots: &mut Vec<B>,
) -> Mat<B, N> {
    let q = slots.parameter("q".to_owned());
    roots.push(q);
    symmetric(|i, j| match (i + 1, j + 1) {
        (i, j) if i == N && j == N => q * q,
        (i, j) => slots.jet("g̃⁻¹", format!("g̃^{i}{j}")),
    })
}

/// α = (0, …, b, b′, c) with 1 + 2sc − s²(b² + b′²) = d².
fn torn<B: Ground, const N: usize>(
    slots: &mut Slots<'_, B>,
    roots: &mut Vec<B>,
    s: B,
) -> Vector<B, N> {
    let d = slots.parameter("d".to_owned());
    roots.push(d);
    let mut alpha = Vector::from_element(B::zero());
    let mut square = d * d - B::one();
    for k in N.saturating_sub(3)..N - 1 {
        alpha[k] = slots.parameter(format!("b{}", k + 1));
        square += s * s * alpha[k] * alpha[k];
    }
    alpha[N - 1] = square / (s + s);
    alpha
}

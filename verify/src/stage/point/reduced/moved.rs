//! Constant linear changes of coordinates, x = A y, and what they make of an instance.

use super::form::Form;
use crate::harness::{Ground, Moves, Timed, list};
use crate::stage::point::draw::vary2;
use crate::stage::point::instance::Instance;
use crate::stage::reference::leading_minor;
use regge_curvature::jet::{Jet1, Jet2, lower};
use regge_curvature::linalg::{Mat, Vector, apply, inverse_and_det, matrix, symmetric, vector};
use regge_curvature::scalar::Field;

/// How many numbers a change of coordinates takes: A, two factors, the frame's triangular matrix and its normal parts.
pub(in crate::stage::point) fn extra<const N: usize>() -> usize {
    N * N + 2 + (N - 1) * (N - 1) + (N - 1)
}

/// The instance in other coordinates, with other covectors and vectors for the same faces and frame; and what was changed.
#[inline(never)]
pub(in crate::stage::point) fn moved<S: Timed, const N: usize>(
    form: Form,
    i: &Instance<S, N>,
    numbers: &[S::Base],
) -> (Instance<S, N>, Moves<S::Base>) {
    let (entries, rest) = numbers.split_at(N * N);
    let (factors, rest) = rest.split_at(2);
    // Squares are what stands for positive numbers.
    let mut scales = [factors[0] * factors[0], factors[1] * factors[1]];
    let a = coordinates::<S::Base, N>(form, entries, scales);
    let gram: Mat<S::Base, N> = symmetric(|m, n| sum::<_, N>(|k| a[(k, m)] * a[(k, n)]));
    let inverse = inverse_and_det(&gram).0;
    let inverse: Mat<S::Base, N> = matrix(|m, n| sum::<_, N>(|k| inverse[(m, k)] * a[(n, k)]));
    let face = if form == Form::Hinge {
        [S::Base::one(); 2]
    } else {
        scales
    };
    let change = Change { a, inverse };
    let mut instance = change.of(i, face, rest);
    if form == Form::Torn {
        // What is added to g and σ, multiples of dφ ⊗ α and dφ ⊗ ν̇, stays the same.
        let less = S::Base::one() / face[0];
        instance.alpha = instance.alpha.map(|x| x * Jet1::constant(less));
        instance.nu_rate = instance.nu_rate.map(|x| x * less * less);
    }
    if form == Form::Hinge {
        scales = [a[(N - 2, N - 2)], a[(N - 1, N - 1)]];
    }
    let moves = Moves {
        matrix: list(N * N, |k| a[(k / N, k % N)]),
        inverse: list(N * N, |k| inverse[(k / N, k % N)]),
        scales: vec![leading_minor(&a, N), scales[0], scales[1]],
    };
    (instance, moves)
}

fn sum<B: Field, const N: usize>(term: impl Fn(usize) -> B) -> B {
    (0..N).fold(B::zero(), |sum, k| sum + term(k))
}

/// A with a determinant that is a square. At a hinge it maps the hinge and both faces to themselves; of a product it changes
/// either factor.
fn coordinates<B: Ground, const N: usize>(
    form: Form,
    entries: &[B],
    diagonal: [B; 2],
) -> Mat<B, N> {
    let split = N.div_ceil(2);
    let mut a: Mat<B, N> = matrix(|i, j| {
        let keeps = match form {
            Form::Hinge => i + 2 < N || i == j,
            Form::Split => (i < split) == (j < split),
            _ => true,
        };
        if keeps { entries[i * N + j] } else { B::zero() }
    });
    if form == Form::Hinge {
        a[(N - 2, N - 2)] = diagonal[0];
        a[(N - 1, N - 1)] = diagonal[1];
    }
    let det = leading_minor(&a, N);
    for i in 0..N {
        a[(i, 0)] *= det;
    }
    a
}

/// x = A y.
struct Change<B: Ground, const N: usize> {
    a: Mat<B, N>,
    inverse: Mat<B, N>,
}

impl<B: Ground, const N: usize> Change<B, N> {
    fn jet1<S: Timed<Base = B>>(&self, jet: &Jet1<S, N>) -> Jet1<S, N> {
        Jet1 {
            value: jet.value,
            d: std::array::from_fn(|m| {
                (0..N).fold(S::zero(), |sum, k| {
                    sum + S::fixed(self.a[(k, m)]) * jet.d[k]
                })
            }),
        }
    }

    fn jet2(&self, jet: &Jet2<B, N>) -> Jet2<B, N> {
        let d = vector(|k| jet.d[k]);
        let dd = matrix(|m, n| jet.dd[m][n]);
        let dd = self.sandwich(&dd);
        let mut turned = Jet2::constant(jet.value);
        turned.d = apply(&self.a.transpose(), &d).into();
        for m in 0..N {
            turned.dd[m] = std::array::from_fn(|n| dd[(m, n)]);
        }
        turned
    }

    /// Aᵀ T A.
    fn sandwich(&self, t: &Mat<B, N>) -> Mat<B, N> {
        let right: Mat<B, N> = matrix(|i, n| sum::<_, N>(|j| t[(i, j)] * self.a[(j, n)]));
        matrix(|m, n| sum::<_, N>(|i| self.a[(i, m)] * right[(i, n)]))
    }

    /// A⁻¹ T A⁻ᵀ.
    fn sandwich_up(&self, t: &Mat<B, N>) -> Mat<B, N> {
        let (up, turned) = (&self.inverse, self.inverse.transpose());
        let right: Mat<B, N> = matrix(|i, n| sum::<_, N>(|j| t[(i, j)] * turned[(j, n)]));
        matrix(|m, n| sum::<_, N>(|i| up[(m, i)] * right[(i, n)]))
    }

    fn tensor(&self, t: &Mat<Jet2<B, N>, N>) -> Mat<Jet2<B, N>, N> {
        let turned: Mat<Jet2<B, N>, N> = symmetric(|i, j| self.jet2(&t[(i, j)]));
        let a = self.a.map(Jet2::constant);
        let right: Mat<Jet2<B, N>, N> =
            matrix(|i, n| (0..N).fold(Jet2::zero(), |s, j| s + turned[(i, j)] * a[(j, n)]));
        symmetric(|m, n| (0..N).fold(Jet2::zero(), |s, i| s + a[(i, m)] * right[(i, n)]))
    }

    fn covector(&self, alpha: &Vector<B, N>) -> Vector<B, N> {
        apply(&self.a.transpose(), alpha)
    }

    fn field<S: Timed<Base = B>>(&self, x: &Vector<Jet1<S, N>, N>) -> Vector<Jet1<S, N>, N> {
        let turned = x.map(|x| self.jet1(&x));
        vector(|k| {
            (0..N).fold(Jet1::zero(), |sum, l| {
                sum + Jet1::constant(S::fixed(self.inverse[(k, l)])) * turned[l]
            })
        })
    }

    /// φ and ν̄ multiplied by positive factors, the frame's seeds by a triangular matrix.
    fn of<S: Timed<Base = B>>(
        &self,
        i: &Instance<S, N>,
        [face, other_face]: [B; 2],
        frame: &[B],
    ) -> Instance<S, N> {
        let (g, sigma) = (self.tensor(&i.g), self.tensor(&i.sigma));
        let of_field = |x: &Vector<Jet1<S, N>, N>| self.field(x);
        let alpha = i.alpha.map(|x| Jet1 {
            value: S::fixed(x.value),
            d: x.d.map(S::fixed),
        });
        let turned = alpha.map(|x| self.jet1(&x));
        let alpha = self.a.map(|x| Jet1::constant(S::fixed(x))).transpose();
        let alpha = apply(&alpha, &turned).map(|x| x.map(S::value));
        let other = i.other.map(|x| {
            let mut jet = Jet2::constant(x.value);
            jet.d = x.d;
            jet
        });
        Instance {
            moving_g: g.zip_map(&sigma, vary2::<S, N>),
            g,
            sigma,
            fields: [of_field(&i.fields[0]), of_field(&i.fields[1])],
            v: self.jet2(&i.v),
            alpha,
            phi: self.jet2(&i.phi) * Jet2::constant(face),
            nu_bar: self.covector(&i.nu_bar).map(|x| x * other_face),
            nu_rate: self.covector(&i.nu_rate).map(|x| x * face),
            seeds: mixed(i, frame).iter().map(of_field).collect(),
            other: lower(&self.tensor(&other)),
            other_inverse: i.other_inverse.map(|m| self.sandwich_up(&m)),
            any: i.any.map(|v| v.map(|x| apply(&self.inverse, &x))),
            spare: i.spare,
            formulas: i.formulas,
        }
    }
}

/// Seeds of the same frame: combinations with those before, and with n.
fn mixed<S: Timed, const N: usize>(
    i: &Instance<S, N>,
    numbers: &[S::Base],
) -> Vec<Vector<Jet1<S, N>, N>> {
    let (triangle, normal) = numbers.split_at((N - 1) * (N - 1));
    let n = i.frame().n;
    let times = |x: S::Base| move |jet: Jet1<S, N>| jet * Jet1::constant(S::fixed(x));
    list(N - 1, |k| {
        let own = triangle[k * N];
        let mut seed = i.seeds[k].map(times(own * own)) + n.map(times(normal[k]));
        for l in 0..k {
            seed += i.seeds[l].map(times(triangle[k * (N - 1) + l]));
        }
        seed
    })
}

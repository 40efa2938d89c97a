//! Arranges random numbers into jets.

use crate::harness::{Ground, Timed, list};
use regge_curvature::jet::{Jet1, Jet2};
use regge_curvature::linalg::{Mat, Vector, zeros};
use regge_curvature::scalar::Field;

/// Hands out numbers one by one.
pub(super) struct Source<'a, B> {
    numbers: Option<&'a [B]>,
    taken: usize,
    /// What the next numbers are.
    name: &'static str,
    /// What all were, where they are only counted.
    groups: Vec<String>,
}

impl<'a, B: Ground> Source<'a, B> {
    pub fn new(numbers: &'a [B]) -> Self {
        Self {
            numbers: Some(numbers),
            taken: 0,
            name: "",
            groups: Vec::new(),
        }
    }

    /// Hands out ones and counts.
    pub fn counting() -> Self {
        Self {
            numbers: None,
            ..Self::new(&[])
        }
    }

    /// By name, of a source that counts.
    pub fn groups(self) -> Vec<String> {
        self.groups
    }

    /// The next numbers are of this.
    pub fn of(&mut self, name: &'static str) -> &mut Self {
        self.name = name;
        self
    }

    pub fn next(&mut self) -> B {
        self.derivative("")
    }

    fn derivative(&mut self, order: &str) -> B {
        let Some(numbers) = self.numbers else {
            self.groups.push(format!("{order}{}", self.name));
            return B::one();
        };
        self.taken += 1;
        numbers[self.taken - 1]
    }

    pub fn jet1<const N: usize>(&mut self) -> Jet1<B, N> {
        Jet1 {
            value: self.next(),
            d: std::array::from_fn(|_| self.derivative("∂")),
        }
    }

    pub fn jet2<const N: usize>(&mut self) -> Jet2<B, N> {
        let mut seen = 0;
        Jet2::from_numbers(|| {
            seen += 1;
            self.derivative(match seen {
                1 => "",
                k if k <= N + 1 => "∂",
                _ => "∂²",
            })
        })
    }
}

/// A symmetric tensor with independent components.
pub(super) fn tensor<B: Ground, const N: usize>(source: &mut Source<'_, B>) -> Mat<Jet2<B, N>, N> {
    let mut a = zeros();
    for i in 0..N {
        for j in i..N {
            a[(i, j)] = source.jet2();
            a[(j, i)] = a[(i, j)];
        }
    }
    a
}

/// A metric with the value A Aᵀ + ½ δ: its eigenvalues lie between ½ and N² + ½.
pub(super) fn metric<B: Ground, const N: usize>(source: &mut Source<'_, B>) -> Mat<Jet2<B, N>, N> {
    let mut g = tensor(source);
    // (In the name of the tensor itself: g is of degree two in A.)
    let a = Mat::<B, N>::from_fn(|_, _| source.next());
    for i in 0..N {
        for j in 0..N {
            let mut value = if i == j { B::half() } else { B::zero() };
            for k in 0..N {
                value += a[(i, k)] * a[(j, k)];
            }
            g[(i, j)].value = value;
        }
    }
    g
}

/// A time-dependent vector field.
pub(super) fn field<S: Timed, const N: usize>(
    source: &mut Source<'_, S::Base>,
) -> Vector<Jet1<S, N>, N> {
    let name = source.name;
    let field = Vector::from_fn(|_, _| {
        let (still, rate) = (source.of(name).jet1(), source.of("rates").jet1());
        vary1(still, rate)
    });
    source.of(name);
    field
}

/// |∂_k φ|; NaN in a field without order, where no slope is then less than another.
fn slope<B: Ground, const N: usize>(phi: &Jet2<B, N>, k: usize) -> f64 {
    phi.d[k].to_real().abs()
}

/// The direction in which φ grows fastest.
fn steepest<B: Ground, const N: usize>(phi: &Jet2<B, N>) -> usize {
    (1..N).fold(0, |best, k| {
        if slope(phi, k) > slope(phi, best) {
            k
        } else {
            best
        }
    })
}

/// A function with |dφ| ≥ 1: the curvature of its level sets is of the size of its second derivatives.
pub(super) fn level_function<B: Ground, const N: usize>(source: &mut Source<'_, B>) -> Jet2<B, N> {
    let mut phi: Jet2<B, N> = source.jet2();
    let k = steepest(&phi);
    let sign = phi.d[k].to_real().signum();
    if !sign.is_nan() {
        phi.d[k] += B::from_real(sign);
    }
    phi
}

/// A covector that is not nearly parallel to dφ: near the direction in which φ grows least.
pub(super) fn other_face<B: Ground, const N: usize>(
    source: &mut Source<'_, B>,
    phi: &Jet2<B, N>,
) -> Vector<B, N> {
    let least = (1..N).fold(0, |best, k| {
        if slope(phi, k) < slope(phi, best) {
            k
        } else {
            best
        }
    });
    let quarter = B::ratio(1, 4);
    Vector::from_fn(|k, _| source.next() * quarter + if k == least { B::one() } else { B::zero() })
}

/// Vector fields near all coordinate directions but the one in which φ grows fastest: together with the normal of
/// {φ = 0} they are a well-conditioned basis, where Gram and Schmidt lose no digits.
pub(super) fn transversal<S: Timed, const N: usize>(
    source: &mut Source<'_, S::Base>,
    phi: &Jet2<S::Base, N>,
) -> Vec<Vector<Jet1<S, N>, N>> {
    let left_out = steepest(phi);
    let eighth = S::fixed(S::Base::ratio(1, 8));
    let near = |k: usize, source: &mut Source<'_, S::Base>| {
        let mut field = field::<S, N>(source);
        for j in 0..N {
            let unit = if j == k { S::one() } else { S::zero() };
            field[j].value = unit + field[j].value * eighth;
        }
        field
    };
    list(N - 1, |k| {
        near(if k < left_out { k } else { k + 1 }, source)
    })
}

/// a + t b.
pub fn vary1<S: Timed, const N: usize>(a: Jet1<S::Base, N>, b: Jet1<S::Base, N>) -> Jet1<S, N> {
    Jet1 {
        value: S::new(a.value, b.value),
        d: std::array::from_fn(|m| S::new(a.d[m], b.d[m])),
    }
}

/// a + t b.
pub fn vary2<S: Timed, const N: usize>(a: Jet2<S::Base, N>, b: Jet2<S::Base, N>) -> Jet2<S, N> {
    Jet2 {
        value: S::new(a.value, b.value),
        d: std::array::from_fn(|m| S::new(a.d[m], b.d[m])),
        dd: std::array::from_fn(|m| std::array::from_fn(|n| S::new(a.dd[m][n], b.dd[m][n]))),
    }
}

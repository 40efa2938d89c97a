//! I01–I03: the unit normals of two metrics.

use crate::harness::{Equation, Excuses, Ground, Record, Timed};
use crate::stage::point::{Instance, Over, Pointwise};
use nalgebra::DMatrix;
use regge_curvature::density::Normal;
use regge_curvature::linalg::{Mat, Vector, apply, contract};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::{Algebraic, Field};

/// A covector and two inverse metrics.
struct Pair<B: Ground, const N: usize> {
    nu: Vector<B, N>,
    normals: [Normal<B, N>; 2],
    metrics: [Mat<B, N>; 2],
    inverses: [Mat<B, N>; 2],
    /// νᵀ g⁻¹ ν.
    squares: [B; 2],
}

impl<B: Ground, const N: usize> Pair<B, N> {
    fn new<S: Timed<Base = B>>(i: &Instance<S, N>) -> Self {
        let nu = i.nu().map(|x| x.value);
        let (one, two) = (i.still0(), i.other0());
        let square = |c: &Connection<B, N>| contract(&nu, &apply(&c.inverse, &nu));
        Self {
            normals: [i.normal(&one, &nu), i.normal(&two, &nu)],
            squares: [square(&one), square(&two)],
            metrics: [one.g, two.g],
            inverses: [one.inverse, two.inverse],
            nu,
        }
    }

    /// n_1 − n_2.
    fn difference(&self) -> Vector<B, N> {
        self.normals[0].n - self.normals[1].n
    }

    /// (b − a)/(a√b + b√a) with the squares a and b.
    fn fraction(&self) -> B {
        let [a, b] = self.squares;
        (b - a) / (a * b.sqrt() + b * a.sqrt())
    }
}

/// eq. (sqrtdiff).
pub struct I01;

impl Pointwise for I01 {
    const RECORD: Record = Record {
        label: "I01",
        paper: &["sqrtdiff"],
        title: "The difference of two reciprocal roots",
        statement: r"\frac{1}{\sqrt a} - \frac{1}{\sqrt b} = \frac{b-a}{a\sqrt b + b\sqrt a},\qquad
            a = \nu^Tg_1^{-1}\nu,\ b = \nu^Tg_2^{-1}\nu",
        sides: "Left: the lengths of ν in two metrics by the library. Right: the closed form.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let pair = Pair::new(i);
        let [one, two] = &pair.normals;
        let (a, b) = (S::Base::one() / one.length, S::Base::one() / two.length);
        vec![
            Equation::new("1/√a − 1/√b")
                .left("1/√a", a)
                .left("−1/√b", -b)
                .right("(b−a)/(a√b+b√a)", pair.fraction()),
        ]
    }
}

/// The decomposition of n_1 − n_2.
pub struct I02;

impl Pointwise for I02 {
    const RECORD: Record = Record {
        label: "I02",
        paper: &["lemma:ndiff"],
        title: "The difference of two unit normals",
        statement: r"n_1 - n_2 = \frac{b-a}{a\sqrt b + b\sqrt a}\,g_1^{-1}\nu
            + \frac{1}{\sqrt b}(g_1^{-1} - g_2^{-1})\nu,\qquad g_1^{-1} - g_2^{-1} = g_1^{-1}(g_2 - g_1)g_2^{-1}",
        sides: "Left: the library's normals and inverses. Right: products of matrices.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let pair = Pair::new(i);
        let [one, two] = &pair.inverses;
        let scale = S::Base::one() / pair.squares[1].sqrt();
        let fraction = pair.fraction();
        let between = Mat::<S::Base, N>::from_fn(|a, b| {
            let mut sum = S::Base::zero();
            for k in 0..N {
                for l in 0..N {
                    let difference = pair.metrics[1][(k, l)] - pair.metrics[0][(k, l)];
                    sum += one[(a, k)] * difference * two[(l, b)];
                }
            }
            sum
        });
        vec![
            Equation::new("n_1 − n_2")
                .left("n_1−n_2", pair.difference())
                .right(
                    "fraction g_1⁻¹ν",
                    apply(one, &pair.nu).map(|x| x * fraction),
                )
                .right("g_1⁻¹ν/√b", apply(one, &pair.nu).map(|x| x * scale))
                .right("−g_2⁻¹ν/√b", apply(two, &pair.nu).map(|x| -x * scale)),
            Equation::new("inverses")
                .left("g_1⁻¹", *one)
                .left("−g_2⁻¹", -two)
                .right("g_1⁻¹(g_2−g_1)g_2⁻¹", between),
        ]
    }
}

/// lemma:ndiff with a constant.
pub struct I03;

/// The greatest |eigenvalue| of a symmetric matrix of real numbers.
fn spectral<B: Ground, const N: usize>(a: &Mat<B, N>) -> f64 {
    let real = DMatrix::from_fn(N, N, |i, j| a[(i, j)].to_real());
    real.symmetric_eigenvalues()
        .iter()
        .fold(0.0, |max, x| f64::max(max, x.abs()))
}

impl Pointwise for I03 {
    const RECORD: Record = Record {
        label: "I03",
        paper: &["lemma:ndiff", "ndiffLinf"],
        title: "The unit normals of two metrics differ by the metrics' difference, with a constant",
        statement: r"|n_1 - n_2| \le \left(\tfrac12\mu^3M^{3/2} + \mu^2M^{1/2}\right)|g_1 - g_2|,\qquad
            M = \max|g_i|,\ \mu = \max|g_i^{-1}|",
        sides: "Left: the library's normals. Right: eigenvalues by nalgebra. The constant follows from the proof's \
            decomposition, term by term; a thousandth of it is refuted. It is far from the best one.",
    };
    const OVER: Over = Over::Ordered;
    const EXCUSES: Excuses = Excuses::one_method("an inequality: a finite field has no order");

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let pair = Pair::new(i);
        let most = |a: &[Mat<S::Base, N>; 2]| f64::max(spectral(&a[0]), spectral(&a[1]));
        let (m, mu) = (most(&pair.metrics), most(&pair.inverses));
        let c = mu.powi(3) * m.powf(1.5) / 2.0 + mu * mu * m.sqrt();
        let bound = c * spectral(&(pair.metrics[0] - pair.metrics[1]));
        let length = pair
            .difference()
            .map(|x| x.to_real() * x.to_real())
            .sum()
            .sqrt();
        vec![
            Equation::at_most("|n_1 − n_2|")
                .left("|n_1−n_2|", S::Base::from_real(length))
                .right("c|g_1−g_2|", S::Base::from_real(bound))
                .forge("no g_1 − g_2", "c|g_1−g_2|", S::Base::from_real(0.0))
                .forge(
                    "a thousandth of c",
                    "c|g_1−g_2|",
                    S::Base::from_real(bound / 1000.0),
                )
                .somewhere(),
        ]
    }
}

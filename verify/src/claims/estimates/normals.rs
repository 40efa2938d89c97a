//! I01–I03: the unit normals of two metrics.

use crate::harness::{Equation, Excuses, Ground, Record, Timed};
use crate::stage::point::{Instance, Over, Pointwise};
use nalgebra::DMatrix;
use regge_curvature::density::Normal;
use regge_curvature::linalg::{Mat, Vector, apply, contract, identity, inverse_and_det, symmetric};
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

/// A covector and two metrics, and what the lemma compares.
struct Two<B: Ground, const N: usize> {
    metrics: [Mat<B, N>; 2],
    normals: [Normal<B, N>; 2],
    inverses: [Mat<B, N>; 2],
}

impl<B: Ground, const N: usize> Two<B, N> {
    fn new<S: Timed<Base = B>>(
        i: &Instance<S, N>,
        nu: Vector<B, N>,
        metrics: [Mat<B, N>; 2],
    ) -> Self {
        let inverted = metrics.map(|g| inverse_and_det(&g));
        let normal = |(inverse, det): (Mat<B, N>, B)| Normal::new(&i.formulas, &inverse, det, &nu);
        Self {
            metrics,
            normals: inverted.map(normal),
            inverses: inverted.map(|(inverse, _)| inverse),
        }
    }

    /// Multiples of δ that differ by little, and nothing but in the plane of ν and a tangent: there the constant is attained, up to
    /// a few times what they differ by.
    fn extremal<S: Timed<Base = B>>(i: &Instance<S, N>, multiple: f64) -> Self {
        let nu = i.nu().map(|x| x.value.to_real());
        let unit = nu / nu.norm();
        // Across ν, in the plane of the first two coordinates or of what is left of the first.
        let mut tangent = Vector::<f64, N>::zeros();
        tangent[0] = 1.0;
        tangent -= unit * unit[0];
        if tangent.norm() < 0.5 {
            tangent = Vector::zeros();
            tangent[1] = 1.0;
            tangent -= unit * unit[1];
        }
        let tangent = tangent / tangent.norm();
        let by = 1e-3 * multiple;
        let metric = |by: f64| {
            symmetric(|a, b| {
                let delta = if a == b { multiple } else { 0.0 };
                let off = unit[a] * tangent[b] + unit[b] * tangent[a];
                B::from_real(delta + by * off)
            })
        };
        Self::new(i, unit.map(B::from_real), [metric(0.0), metric(by)])
    }

    /// δ and a sixteenth of it.
    fn multiples<S: Timed<Base = B>>(i: &Instance<S, N>) -> Self {
        let nu = i.nu().map(|x| x.value);
        let less = identity::<B, N>().map(|x| x * B::ratio(1, 16));
        Self::new(i, nu, [identity(), less])
    }

    /// |n_1 − n_2| ≤ μ^{3/2}|g_1 − g_2|.
    fn equation(&self, name: &'static str) -> Equation<B> {
        let difference = self.normals[0].n - self.normals[1].n;
        let length = difference.map(|x| x.to_real()).norm();
        Equation::at_most(name)
            .left(DIFFERENCE, B::from_real(length))
            .right(BOUND, B::from_real(self.bound(1.5, self.mu())))
    }

    /// max|g_i⁻¹|.
    fn mu(&self) -> f64 {
        f64::max(spectral(&self.inverses[0]), spectral(&self.inverses[1]))
    }

    /// A power of μ times |g_1 − g_2|.
    fn bound(&self, power: f64, mu: f64) -> f64 {
        mu.powf(power) * spectral(&(self.metrics[0] - self.metrics[1]))
    }
}

const DIFFERENCE: &str = "|n_1−n_2|";
const BOUND: &str = "μ^{3/2}|g_1−g_2|";

impl Pointwise for I03 {
    const RECORD: Record = Record {
        label: "I03",
        paper: &["lemma:ndiff", "ndiffLinf"],
        title: "The unit normals of two metrics differ by the metrics' difference, with the best constant",
        statement: r"|n_1 - n_2| \le \mu^{3/2}|g_1 - g_2|,\qquad \mu = \max|g_i^{-1}|",
        sides: "Left: the library's normals. Right: eigenvalues by nalgebra. The paper has a constant that depends on the metrics' \
            bounds; along the segment of metrics ṅ = −g⁻¹σn + ½σ(n,n)n with g(n,n) = 1, which is at most |g⁻¹|^{3/2}|σ|, and |g⁻¹| is at most μ there. It is the \
            best one, whatever μ: 99 % of it is refuted by metrics near δ/4 and 4δ that differ in σ(n,τ) alone, and so are the powers μ \
            and μ² by one of them.",
    };
    const OVER: Over = Over::Ordered;
    const EXCUSES: Excuses = Excuses::one_method("an inequality: a finite field has no order");

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let real = S::Base::from_real;
        let nu = i.nu().map(|x| x.value);
        let random = Two::new(i, nu, [i.still0().g, i.other0().g]);
        let [small, large] = [0.25, 4.0].map(|multiple| Two::extremal(i, multiple));
        let multiples = Two::multiples(i);
        let attained = |name, two: &Two<S::Base, N>, wrong: &'static str, power: f64| {
            two.equation(name)
                .forge(
                    "a hundredth less",
                    BOUND,
                    real(0.99 * two.bound(1.5, two.mu())),
                )
                .forge(wrong, BOUND, real(two.bound(power, two.mu())))
        };
        let of_one = multiples.bound(1.5, spectral(&multiples.inverses[0]));
        vec![
            random.equation("random metrics"),
            attained("near δ/4", &small, "μ for μ^{3/2}", 1.0),
            attained("near 4δ", &large, "μ² for μ^{3/2}", 2.0),
            multiples
                .equation("multiples")
                .forge("μ of g_1 alone", BOUND, real(of_one)),
        ]
    }
}

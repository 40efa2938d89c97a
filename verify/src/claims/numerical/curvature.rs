//! N01, N02: the curvature of the paper's example.

use crate::harness::{Equation, Ground, Record, Timed};
use crate::stage::point::{Instance, Over, Pointwise};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::Field;

/// f_i = x_i − x_i³/3 with jets at the point x.
fn slopes<B: Ground, const N: usize>(x: &[B; N]) -> [Jet2<B, N>; N] {
    let third = Jet2::ratio(1, 3);
    std::array::from_fn(|i| {
        let x = Jet2::coordinate(x[i], i);
        x - x * x * x * third
    })
}

/// The metric of the graph of a function with the differential (f_1, …, f_N): δ + f ⊗ f.
fn graph<B: Ground, const N: usize>(f: &[Jet2<B, N>; N]) -> Mat<Jet2<B, N>, N> {
    symmetric(|i, j| f[i] * f[j] + if i == j { Jet2::one() } else { Jet2::zero() })
}

/// q(x) = x²(x²−3)².
fn q<B: Field>(x: B) -> B {
    let (square, three) = (x * x, B::from_int(3));
    square * (square - three) * (square - three)
}

/// R of the graph metric against the paper's closed form with this numerator.
fn graph_equation<B: Ground, const N: usize>(
    x: &[B; N],
    factor: i64,
    numerator: B,
    wrong: B,
) -> Vec<Equation<B>> {
    let mut w = B::from_int(9);
    for x in x {
        w += q(*x);
    }
    let closed = |numerator: B| B::from_int(factor) * numerator / (w * w);
    vec![
        Equation::new("R")
            .left("R", Connection::new(&graph(&slopes(x))).scalar())
            .right("closed form", closed(numerator))
            .forge("another numerator", "closed form", closed(wrong)),
    ]
}

/// R(g) of the paper's example, N = 2.
pub struct N01;

impl Pointwise for N01 {
    const RECORD: Record = Record {
        label: "N01",
        paper: &["sec:numerical"],
        title: "The curvature of the example in two dimensions",
        statement: r"R(g) = \frac{162(1-x^2)(1-y^2)}{(9+x^2(x^2-3)^2+y^2(y^2-3)^2)^2}",
        sides: "Left: the library's R of the graph metric, from jets. Right: the closed form as the paper prints it.",
    };
    const OVER: Over = Over::Oracle;
    const DIMENSIONS: &'static [usize] = &[2];

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let x = i.position();
        let k = x.map(|x| S::Base::one() - x * x);
        graph_equation(&x, 162, k[0] * k[1], k[0] * k[0])
    }
}

/// R(g) of the paper's example, N = 3.
///
/// At a point x the two sides are of degree 124 in it: too many digits for a proof. But where f_i depends on x_i alone, R is a
/// rational function of f and f′, which is of low degree; and the printed form is this function at f_i = x_i − x_i³/3.
pub struct N02;

/// 2 Σ_{a<b} f_a′ f_b′ (1 + f_c²)/(1 + Σ f²)², from (f, f′); wrong with f_a for f_c.
fn in_slopes<B: Field>(f: [B; 3], slope: [B; 3]) -> [B; 2] {
    let one = B::one();
    let term = |a: usize, b: usize, c: usize| slope[a] * slope[b] * (one + f[c] * f[c]);
    let w = one + f[0] * f[0] + f[1] * f[1] + f[2] * f[2];
    let of = |sum: B| (sum + sum) / (w * w);
    let right = of(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1));
    [right, of(term(0, 1, 0) + term(1, 2, 1) + term(2, 0, 2))]
}

/// As the paper prints it; wrong with q(x) for q(z), and so on.
fn printed<B: Field>(x: [B; 3]) -> [B; 2] {
    let (k, nine) = (x.map(|x| B::one() - x * x), B::from_int(9));
    let term = |a: usize, b: usize, c: usize| k[a] * k[b] * (nine + q(x[c]));
    let w = nine + q(x[0]) + q(x[1]) + q(x[2]);
    let of = |sum: B| B::from_int(18) * sum / (w * w);
    let right = of(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1));
    [right, of(term(0, 1, 0) + term(1, 2, 1) + term(2, 0, 2))]
}

impl Pointwise for N02 {
    const RECORD: Record = Record {
        label: "N02",
        paper: &["sec:numerical"],
        title: "The curvature of the example in three dimensions",
        statement: r"R(g) = \frac{18\left((1-x^2)(1-y^2)(9+q(z)) + (1-y^2)(1-z^2)(9+q(x))
            + (1-z^2)(1-x^2)(9+q(y))\right)}{(9+q(x)+q(y)+q(z))^2},\qquad q(x) = x^2(x^2-3)^2",
        sides: "First equation: the library's R of the metric δ + f ⊗ f, from jets, for any f_i of x_i alone, and a closed form in f and f′. \
            Second: this form at f_i = x_i − x_i³/3, whose derivatives are those of the library's jets, and the form that the paper prints.",
    };
    const OVER: Over = Over::Oracle;
    const DIMENSIONS: &'static [usize] = &[3];

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let three = |of: &dyn Fn(usize) -> S::Base| [of(0), of(1), of(2)];
        let (any, at) = (i.functions(), slopes(&i.position()));
        let form =
            |f: &[Jet2<S::Base, N>; N]| in_slopes(three(&|k| f[k].value), three(&|k| f[k].d[k]));
        let ([closed, wrong], x) = (form(&any), i.position());
        let [as_printed, misprinted] = printed(three(&|k| x[k]));
        vec![
            Equation::new("R")
                .left("R", Connection::new(&graph(&any)).scalar())
                .right("in f and f′", closed)
                .forge("another numerator", "in f and f′", wrong),
            Equation::new("f = x − x³/3")
                .left("in f and f′", form(&at)[0])
                .right("closed form", as_printed)
                .forge("another numerator", "closed form", misprinted),
        ]
    }
}

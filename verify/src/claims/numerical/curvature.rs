//! N01, N02: the curvature of the paper's example.

use crate::harness::{Equation, Ground, Record, Timed};
use crate::stage::point::{Instance, Over, Pointwise};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, symmetric};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::Field;

/// The metric of the graph of f = Σ x²/2 − x⁴/12, with jets at the point x: δ + df ⊗ df, f_i = x_i − x_i³/3.
fn graph<B: Ground, const N: usize>(x: &[B; N]) -> Mat<Jet2<B, N>, N> {
    let third = Jet2::ratio(1, 3);
    let f: [Jet2<B, N>; N] = std::array::from_fn(|i| {
        let x = Jet2::coordinate(x[i], i);
        x - x * x * x * third
    });
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
            .left("R", Connection::new(&graph(x)).scalar())
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
pub struct N02;

impl Pointwise for N02 {
    const RECORD: Record = Record {
        label: "N02",
        paper: &["sec:numerical"],
        title: "The curvature of the example in three dimensions",
        statement: r"R(g) = \frac{18\left((1-x^2)(1-y^2)(9+q(z)) + (1-y^2)(1-z^2)(9+q(x))
            + (1-z^2)(1-x^2)(9+q(y))\right)}{(9+q(x)+q(y)+q(z))^2},\qquad q(x) = x^2(x^2-3)^2",
        sides: "Left: the library's R of the graph metric, from jets. Right: the closed form as the paper prints it.",
    };
    const OVER: Over = Over::Oracle;
    const DIMENSIONS: &'static [usize] = &[3];
    // Of degree 124 in three numbers: at that many points they have too many digits.
    const PROVED: &'static [usize] = &[];

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let x = i.position();
        let k = x.map(|x| S::Base::one() - x * x);
        let nine = S::Base::from_int(9);
        let term = |a: usize, b: usize, c: usize| k[a] * k[b] * (nine + q(x[c]));
        let wrong = term(0, 1, 0) + term(1, 2, 1) + term(2, 0, 2);
        graph_equation(&x, 18, term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1), wrong)
    }
}

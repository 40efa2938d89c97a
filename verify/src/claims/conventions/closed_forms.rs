//! N01, N02 and O01–O03: scalar curvatures in closed form.

use crate::harness::{Equation, Ground, Record, Timed};
use crate::stage::point::{Instance, Over, Pointwise};
use regge_curvature::jet::Jet2;
use regge_curvature::linalg::{Mat, apply, contract, symmetric};
use regge_curvature::riemann::{Connection, differential};
use regge_curvature::scalar::Field;

/// Products.
pub struct O01;

/// The metric on the first `split` coordinates, or on the others, with derivatives in these coordinates only.
fn block<B: Ground, const N: usize>(
    g: &Mat<Jet2<B, N>, N>,
    split: usize,
) -> (Mat<Jet2<B, N>, N>, Mat<Jet2<B, N>, N>) {
    let first = |i: usize| i < split;
    let within = |i: usize, j: usize, side: bool| {
        if first(i) != first(j) {
            return Jet2::zero();
        }
        if first(i) != side {
            return if i == j { Jet2::one() } else { Jet2::zero() };
        }
        let mut jet = g[(i, j)];
        for m in (0..N).filter(|&m| first(m) != side) {
            jet.d[m] = B::zero();
            for n in 0..N {
                jet.dd[m][n] = B::zero();
                jet.dd[n][m] = B::zero();
            }
        }
        jet
    };
    (
        symmetric(|i, j| within(i, j, true)),
        symmetric(|i, j| within(i, j, false)),
    )
}

impl Pointwise for O01 {
    const RECORD: Record = Record {
        label: "O01",
        paper: &[],
        title: "Products of metrics",
        statement: r"R(g_1\oplus g_2) = R(g_1) + R(g_2)",
        sides: "Left: the product. Right: each factor times a flat space, by the same R, which O03 pins down. A textbook identity (O'Neill, \
            Semi-Riemannian Geometry, corollary 3.58).",
    };
    const OVER: Over = Over::Oracle;

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let split = N.div_ceil(2);
        let (one, two) = block(&i.g, split);
        let product = symmetric(|a, b| if a < split { one[(a, b)] } else { two[(a, b)] });
        let r = |g: &Mat<_, N>| Connection::new(g).scalar();
        vec![
            Equation::new("R")
                .left("R(g_1⊕g_2)", r(&product))
                .vanishes(N == 2, "curves are flat")
                .right("R(g_1)", r(&one))
                .vanishes(N == 2, "curves are flat")
                .right("R(g_2)", r(&two))
                .vanishes(N < 4, "curves are flat")
                .magnitude(S::Base::one()),
        ]
    }
}

/// Conformal metrics.
pub struct O02;

impl Pointwise for O02 {
    const RECORD: Record = Record {
        label: "O02",
        paper: &[],
        title: "Conformal metrics",
        statement: r"R(ug) = \frac1u\left(R(g) - (N-1)\frac{\Delta u}{u}
            - \frac{(N-1)(N-6)}{4}\frac{|\nabla u|^2}{u^2}\right)",
        sides: "Left: the library's R of ug. Right: R, Δ and |∇u|² of g. The textbook's formula for e^{2f}g (Besse, \
            Einstein Manifolds, theorem 1.159) with u = e^{2f}.",
    };
    const OVER: Over = Over::Oracle;

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        // In 1…3, where the numbers have an order.
        let u = i.v + Jet2::from_int(2);
        let still = i.still();
        let base = still.lower();
        let du = differential(&u).map(|d| d.value);
        let square = contract(&du, &apply(&base.inverse, &du));
        let (n, over) = (N as i64, S::Base::one() / u.value);
        let scaled = i.g.map(|x| x * u);
        let last = S::Base::ratio((n - 1) * (n - 6), 4) * square * over * over * over;
        vec![
            Equation::new("R")
                .left("R(ug)", Connection::new(&scaled).scalar())
                .right("R/u", still.scalar() * over)
                .right(
                    "−(N−1)Δu/u²",
                    S::Base::from_int(1 - n) * still.laplacian(&u) * over * over,
                )
                .right("−(N−1)(N−6)|∇u|²/4u³", -last),
        ]
    }
}

/// Constant curvature.
pub struct O03;

impl Pointwise for O03 {
    const RECORD: Record = Record {
        label: "O03",
        paper: &[],
        title: "Spaces of constant curvature",
        statement: r"g = \frac{\delta}{(1+\kappa|x|^2/4)^2}:\quad R = N(N-1)\kappa,\quad
            \operatorname{Ric} = (N-1)\kappa\,g",
        sides: "Left: the library's R and Ric. Right: Riemann's metric of constant sectional curvature κ (1854).",
    };
    const OVER: Over = Over::Oracle;

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let x = i.position();
        // |κ| ≤ ½ and |x|² ≤ 5: the denominator stays away from zero.
        let kappa = i.spare[N] * S::Base::half();
        let mut w = Jet2::<S::Base, N>::one();
        for k in 0..N {
            let x = Jet2::coordinate(x[k], k);
            w += x * x * Jet2::constant(kappa * S::Base::ratio(1, 4));
        }
        let factor = Jet2::one() / (w * w);
        let g = symmetric(|a, b| if a == b { factor } else { Jet2::zero() });
        let connection = Connection::new(&g);
        let n = N as i64;
        let times = |k: i64| S::Base::from_int(k) * kappa;
        let ricci = connection.lower().g.map(|x| x * times(n - 1));
        vec![
            Equation::new("R")
                .left("R", connection.scalar())
                .right("N(N−1)κ", times(n * (n - 1))),
            Equation::new("Ric")
                .left("Ric", connection.ricci())
                .right("(N−1)κg", ricci),
        ]
    }
}

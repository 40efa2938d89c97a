//! P05, P06, I12: how the connection changes, and how two connections differ.

use crate::harness::{Components, Equation, Record, Timed, list};
use crate::stage::point::{Instance, Pointwise, along};
use regge_curvature::linalg::{Mat, Vector, apply, form, symmetric};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::Field;

/// Γ̇.
pub struct P05;

/// `[l][i][j]` = factor g^lm a(m, i, j), as a list.
fn raise<B: Field, const N: usize>(
    inverse: &Mat<B, N>,
    factor: B,
    a: impl Fn(usize, usize, usize) -> B,
) -> Vec<B> {
    let mut raised = Vec::with_capacity(N * N * N);
    for l in 0..N {
        for i in 0..N {
            for j in 0..N {
                let mut sum = B::zero();
                for m in 0..N {
                    sum += inverse[(l, m)] * a(m, i, j);
                }
                raised.push(factor * sum);
            }
        }
    }
    raised
}

impl Pointwise for P05 {
    const RECORD: Record = Record {
        label: "P05",
        paper: &["lemma:covdot"],
        title: "The rate of change of the Christoffel symbols",
        statement: r"\dot\Gamma^\ell_{ij} = \tfrac12 g^{\ell m}\left((\nabla_i\sigma)_{jm}
            + (\nabla_j\sigma)_{im} - (\nabla_m\sigma)_{ij}\right)",
        sides: "Left: Γ of g + tσ, differentiated in t. Right: covariant derivatives of σ. Both use Γ, the left its change and the right its value, which D03 and O03 pin down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let base = i.still0();
        let mut rate = Vec::new();
        for gamma in &i.moving0().gamma {
            rate.extend(gamma.map(S::rate).components());
        }
        let (covariant, sigma) = (base.nabla_tensor(&i.sigma1()), i.sigma1());
        let half = S::Base::half();
        let terms = |d: &dyn Fn(usize, usize, usize) -> S::Base| {
            [
                raise(&base.inverse, half, |m, i, j| d(i, j, m)),
                raise(&base.inverse, half, |m, i, j| d(j, i, m)),
                raise(&base.inverse, -half, d),
            ]
        };
        let [a, b, c] = terms(&|m, i, j| covariant[m][(i, j)]);
        let [a0, b0, c0] = terms(&|m, i, j| sigma[(i, j)].d[m]);
        let names = ["½(∇_iσ)_j^ℓ", "½(∇_jσ)_i^ℓ", "−½(∇^ℓσ)_ij"];
        vec![
            Equation::new("Γ̇")
                .left("Γ̇", rate)
                .right(names[0], a)
                .right(names[1], b)
                .right(names[2], c)
                .forge_terms(
                    "∂σ for ∇σ",
                    vec![(names[0], a0), (names[1], b0), (names[2], c0)],
                ),
        ]
    }
}

/// ∂_t ∇_Y X.
pub struct P06;

impl Pointwise for P06 {
    const RECORD: Record = Record {
        label: "P06",
        paper: &["lemma:covdot"],
        title: "The rate of change of a covariant derivative",
        statement: r"\frac{\partial}{\partial t}\nabla_Y X = \nabla_{\dot Y}X + \nabla_Y\dot X
            + \tfrac12\left((\nabla_X\sigma)Y + (\nabla_Y\sigma)X - (\nabla\sigma)(X,Y)\right)^\sharp",
        sides: "Left: ∇_Y X with the connection of g + tσ and moving X, Y, differentiated in t. Right: covariant \
            derivatives at t = 0. (The last lines of the printed proof omit the ♯.) Both use Γ, the left its change and the right its value, which D03 and O03 pin down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let base = i.still0();
        let [x, y] = &i.fields;
        let moving = along(&i.moving0().nabla_vector(x), &y.map(|y| y.value));
        let (x1, x1_dot) = (x.map(|x| x.map(S::value)), x.map(|x| x.map(S::rate)));
        let (x0, y0) = (x.map(|x| x.value.value()), y.map(|y| y.value.value()));
        let nabla = base.nabla_tensor(&i.sigma1());
        // Z ↦ ½ (∇_U σ)(W, Z).
        let half = S::Base::half();
        let one = |u: &Vector<S::Base, N>, w: &Vector<S::Base, N>| {
            let mut form = Vector::from_element(S::Base::zero());
            for m in 0..N {
                form += apply(&nabla[m], w).map(|z| z * u[m] * half);
            }
            form
        };
        let last = Vector::from_fn(|m, _| -half * form(&nabla[m], &x0, &y0));
        let lowered = [one(&x0, &y0), one(&y0, &x0), last];
        let names = ["½((∇_Xσ)Y)^♯", "½((∇_Yσ)X)^♯", "−½((∇σ)(X,Y))^♯"];
        let unraised = list(3, |k| (names[k], lowered[k].components()));
        vec![
            Equation::new("∂_t ∇_Y X")
                .left("∂_t ∇_Y X", moving.map(S::rate))
                .right(
                    "∇_Ẏ X",
                    along(&base.nabla_vector(&x1), &y.map(|y| y.value.rate())),
                )
                .right("∇_Y Ẋ", along(&base.nabla_vector(&x1_dot), &y0))
                .right(names[0], base.sharp(&lowered[0]))
                .right(names[1], base.sharp(&lowered[1]))
                .right(names[2], base.sharp(&lowered[2]))
                .forge_terms("no ♯", unraised),
        ]
    }
}

/// The Hessians of two metrics.
pub struct I12;

impl Pointwise for I12 {
    const RECORD: Record = Record {
        label: "I12",
        paper: &["normv"],
        title: "The Hessians of two metrics",
        statement: r"\nabla_{\tilde g}\nabla_{\tilde g}v = \nabla_g\nabla_g v
            + (\Gamma^k_{ij} - \tilde\Gamma^k_{ij})\,\partial_k v",
        sides: "Left: the difference of the library's two Hessians. Right: Christoffel symbols and dv, no second derivatives of v.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (one, two) = (i.still0(), i.other0());
        let pair = |c: &Connection<S::Base, N>, sign: i64| -> Mat<S::Base, N> {
            symmetric(|a, b| {
                let mut sum = S::Base::zero();
                for k in 0..N {
                    sum += S::Base::from_int(sign) * c.gamma[k][(a, b)] * i.v.d[k];
                }
                sum
            })
        };
        vec![
            Equation::new("∇∇v")
                .left("∇̃∇̃v", two.hessian(&i.v))
                .right("∇∇v", one.hessian(&i.v))
                .right("Γ dv", pair(&one, 1))
                .right("−Γ̃ dv", pair(&two, -1)),
        ]
    }
}

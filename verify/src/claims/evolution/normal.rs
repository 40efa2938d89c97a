//! D12, P07, P08, P09: the unit normal, and how it and a frame change.

use crate::harness::{Equation, Record, Timed, each, table};
use crate::stage::point::{Instance, Pointwise};
use regge_curvature::density::Normal;
use regge_curvature::linalg::{Mat, Vector, apply, contract, form, identity};
use regge_curvature::scalar::Field;

/// n.
pub struct D12;

impl Pointwise for D12 {
    const RECORD: Record = Record {
        label: "D12",
        paper: &["normal"],
        title: "The unit normal",
        statement: r"n_g = \frac{g^{-1}\nu}{\sqrt{\nu^T g^{-1}\nu}}:\quad g(n,n) = 1,\quad
            |\nu|_g\, g(n,Z) = \nu(Z) \text{ for all } Z",
        sides: "Left: products with the library's normal. Right: numbers and the covector itself.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let base = i.still0();
        let nu = i.nu().map(|x| x.value);
        let normal = i.normal(&base, &nu);
        let z = i.fields[0].map(|x| x.value.value());
        let euclidean = Normal::new(&i.formulas, &identity(), S::Base::one(), &nu).n;
        let on_z = normal.length * form(&base.g, &normal.n, &z);
        vec![
            Equation::new("length")
                .left("g(n,n)", form(&base.g, &normal.n, &normal.n))
                .right("1", S::Base::one())
                .forge(
                    "Euclidean normal",
                    "g(n,n)",
                    form(&base.g, &euclidean, &euclidean),
                ),
            Equation::new("direction")
                .left("|ν| g(n,Z)", on_z)
                .right("ν(Z)", contract(&nu, &z))
                .forge(
                    "Euclidean normal",
                    "|ν| g(n,Z)",
                    normal.length * form(&base.g, &euclidean, &z),
                ),
        ]
    }
}

/// ∂_t g(n, X).
pub struct P07;

impl Pointwise for P07 {
    const RECORD: Record = Record {
        label: "P07",
        paper: &["lemma:ndot"],
        title: "The rate of change of a normal component",
        statement: r"\frac{\partial}{\partial t}g(n,X) = \tfrac12\sigma(n,n)\,g(n,X) + g(n,\dot X)",
        sides: "Left: g + tσ, its normal and a moving X, differentiated in t. Right: products at t = 0.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (moving, base) = (i.moving0(), i.still0());
        let nu = i.nu().map(|x| x.value);
        let x = i.fields[0].map(|x| x.value);
        let rate = |nu: Vector<S, N>| form(&moving.g, &i.normal(&moving, &nu).n, &x).rate();
        let n = i.normal(&base, &nu).n;
        let half_nn = S::Base::half() * form(&i.sigma0(), &n, &n);
        let turning = Vector::from_fn(|k, _| S::new(nu[k], i.nu_rate[k]));
        vec![
            Equation::new("∂_t g(n,X)")
                .left("∂_t g(n,X)", rate(nu.map(S::fixed)))
                .right(
                    "½σ(n,n) g(n,X)",
                    half_nn * form(&base.g, &n, &x.map(S::value)),
                )
                .right("g(n,Ẋ)", form(&base.g, &n, &x.map(S::rate)))
                .forge("F moves", "∂_t g(n,X)", rate(turning)),
        ]
    }
}

/// ṅ.
pub struct P08;

impl Pointwise for P08 {
    const RECORD: Record = Record {
        label: "P08",
        paper: &["lemma:ndot"],
        title: "The rate of change of the unit normal",
        statement: r"g(\dot n,\tau_i) = -\sigma(n,\tau_i),\quad 2g(n,\dot n) = -\sigma(n,n),\quad
            \dot n = -\tfrac12\sigma(n,n)\,n - \sum_i\sigma(n,\tau_i)\,\tau_i",
        sides: "Left: the library's normal of g + tσ, differentiated in t. Right: σ on a frame at t = 0.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (moving, base, sigma) = (i.moving0(), i.still0(), i.sigma0());
        let nu = i.nu().map(|x| S::fixed(x.value));
        let rate = i.normal(&moving, &nu).n.map(S::rate);
        let frame = i.frame();
        let (n, tau) = (frame.n0(), frame.tau0());
        let s_n = apply(&sigma, &n);
        let half = S::Base::half();
        let mut tangential = Vector::from_element(S::Base::zero());
        for t in &tau {
            tangential -= t.map(|x| x * contract(&s_n, t));
        }
        let on_rate = each(&tau, |t| form(&base.g, &rate, t));
        let s_on = each(&tau, |t| -contract(&s_n, t));
        vec![
            Equation::new("tangential")
                .left("g(ṅ,τ)", on_rate)
                .right("−σ(n,τ)", s_on),
            Equation::new("normal")
                .left("2g(n,ṅ)", S::Base::from_int(2) * form(&base.g, &n, &rate))
                .right("−σ(n,n)", -contract(&s_n, &n)),
            Equation::new("ṅ")
                .left("ṅ", rate)
                .right("−½σ(n,n)n", n.map(|x| -half * contract(&s_n, &n) * x))
                .right("−Σσ(n,τ)τ", tangential),
        ]
    }
}

/// Orthonormal frames.
pub struct P09;

impl Pointwise for P09 {
    const RECORD: Record = Record {
        label: "P09",
        paper: &["Hdot"],
        title: "The rate of change of an orthonormal frame",
        statement: r"0 = \sigma(\tau_j,\tau_i) + g(\tau_j,\dot\tau_i) + g(\dot\tau_j,\tau_i)",
        sides: "The frame is made by Gram and Schmidt in g + tσ and differentiated in t; σ is the given one.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (sigma, g): (Mat<S::Base, N>, Mat<S::Base, N>) = (i.sigma0(), i.still0().g);
        let frame = i.frame();
        let (tau, rate) = (frame.tau0(), frame.tau_rate());
        vec![
            Equation::new("frame")
                .left(
                    "σ(τ_j,τ_i)",
                    table(N - 1, |i, j| form(&sigma, &tau[j], &tau[i])),
                )
                .right(
                    "−g(τ_j,τ̇_i)",
                    table(N - 1, |i, j| -form(&g, &tau[j], &rate[i])),
                )
                .right(
                    "−g(τ̇_j,τ_i)",
                    table(N - 1, |i, j| -form(&g, &rate[j], &tau[i])),
                ),
        ]
    }
}

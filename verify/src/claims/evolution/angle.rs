//! P22–P24: how angles change.

use crate::harness::{Equation, Ground, Record, Timed};
use crate::stage::point::{Instance, Pointwise};
use regge_curvature::linalg::{Vector, form};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::Field;

/// (n, τ) and (n̄, τ̄) with τ = τ̄ cos θ + n̄ sin θ, n = −τ̄ sin θ + n̄ cos θ, and θ's cosine and sine.
struct Turned<B: Ground, const N: usize> {
    n: Vector<B, N>,
    tau: Vector<B, N>,
    n_bar: Vector<B, N>,
    tau_bar: Vector<B, N>,
    cos: B,
    sin: B,
}

impl<B: Ground, const N: usize> Turned<B, N> {
    /// n ⊥ ν and n̄ ⊥ ν̄; sin θ > 0.
    fn new<S: Timed<Base = B>>(
        i: &Instance<S, N>,
        base: &Connection<B, N>,
        nu: &Vector<B, N>,
    ) -> Self {
        let n = i.normal(base, nu).n;
        let n_bar = i.normal(base, &i.nu_bar).n;
        let cos = form(&base.g, &n_bar, &n);
        let sin = (B::one() - cos * cos).sqrt();
        let over = B::one() / sin;
        let tau_bar = Vector::from_fn(|k, _| (n_bar[k] * cos - n[k]) * over);
        let tau = Vector::from_fn(|k, _| (n_bar[k] - n[k] * cos) * over);
        Self {
            n,
            tau,
            n_bar,
            tau_bar,
            cos,
            sin,
        }
    }
}

/// θ̇ between the normals of two hypersurfaces: of the dihedral angle of the wedge with these outward covectors.
fn rate<S: Timed, const N: usize>(i: &Instance<S, N>, nu: [&Vector<S, N>; 2]) -> S::Base {
    let (sin, cos) = i.corner(&i.moving0(), nu).dihedral();
    S::angle_rate(sin, cos)
}

/// θ̇.
pub struct P22;

impl Pointwise for P22 {
    const RECORD: Record = Record {
        label: "P22",
        paper: &["lemma:angledot", "angledot"],
        title: "The rate of change of an angle",
        statement: r"\dot\theta = \tfrac12\sigma(n,\tau) - \tfrac12\sigma(\bar n,\bar\tau)",
        sides: "Left: the library's dihedral angle in g + tσ, differentiated in t. Right: σ on the two pairs, made of \
            the normals at t = 0. There is no angle on the right.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, sigma) = (i.still0(), i.sigma0());
        let nu = i.nu().map(|x| x.value);
        let pairs = Turned::new(i, &base, &nu);
        // The wedge with outward covectors ν̄ and −ν.
        let (nu_t, bar_t) = (nu.map(|x| S::fixed(-x)), i.nu_bar.map(S::fixed));
        let turning = Vector::from_fn(|k, _| S::new(-nu[k], -i.nu_rate[k]));
        let half = S::Base::half();
        let left = rate(i, [&bar_t, &nu_t]);
        vec![
            Equation::new("θ̇")
                .left("θ̇", left)
                .right("½σ(n,τ)", half * form(&sigma, &pairs.n, &pairs.tau))
                .right(
                    "−½σ(n̄,τ̄)",
                    -half * form(&sigma, &pairs.n_bar, &pairs.tau_bar),
                )
                .forge("F moves", "θ̇", rate(i, [&bar_t, &turning]))
                .forge("cos θ = +g(n⁺,n⁻)", "θ̇", -left),
        ]
    }
}

/// The steps of its proof.
pub struct P23;

impl Pointwise for P23 {
    const RECORD: Record = Record {
        label: "P23",
        paper: &["lemma:angledot"],
        title: "The rate of change of an angle: the steps of the proof",
        statement: r"-\dot\theta\sin\theta = \tfrac12\sigma(\bar n,\bar n\cos\theta - n)
            + \tfrac12\sigma(n\cos\theta - \bar n,n),\quad \bar n\cos\theta - n = \bar\tau\sin\theta,\quad
            n\cos\theta - \bar n = -\tau\sin\theta",
        sides: "Left: the library's dihedral angle in g + tσ, differentiated in t; combinations of normals. Right: σ \
            at t = 0; the library's conormals.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, sigma) = (i.still0(), i.sigma0());
        let nu = i.nu().map(|x| x.value);
        let Turned {
            n, n_bar, cos, sin, ..
        } = Turned::new(i, &base, &nu);
        let half = S::Base::half();
        let opposite = -nu;
        let theta = rate(i, [&i.nu_bar.map(S::fixed), &opposite.map(S::fixed)]);
        let corner = i.corner(&base, [&i.nu_bar, &opposite]);
        let first = Vector::from_fn(|k, _| n_bar[k] * cos - n[k]);
        let second = Vector::from_fn(|k, _| n[k] * cos - n_bar[k]);
        // The wedge's conormals point into the faces: −τ̄ and −τ.
        let (tau_bar, tau) = (-corner.conormal(0), -corner.conormal(1));
        vec![
            Equation::new("θ̇ sin θ")
                .left("−θ̇ sin θ", -theta * sin)
                .right("½σ(n̄,n̄cosθ−n)", half * form(&sigma, &n_bar, &first))
                .right("½σ(ncosθ−n̄,n)", half * form(&sigma, &second, &n)),
            Equation::new("τ̄")
                .left("n̄ cos θ", n_bar.map(|x| x * cos))
                .left("−n", -n)
                .right("τ̄ sin θ", tau_bar.map(|x| x * sin)),
            Equation::new("τ")
                .left("n cos θ", n.map(|x| x * cos))
                .left("−n̄", -n_bar)
                .right("−τ sin θ", tau.map(|x| -x * sin)),
        ]
    }
}

/// θ̇_ST of a dihedral angle.
pub struct P24;

impl Pointwise for P24 {
    const RECORD: Record = Record {
        label: "P24",
        paper: &["lemma:angledefectdot", "angledefectdot"],
        title: "The rate of change of a dihedral angle (corrected sign)",
        statement: r"\dot\theta_{ST} = \tfrac12\sum_{F\supset S}\sigma(n_F,\tau_F)
            = -\tfrac12\sum_{F\supset S}\sigma(n_F,\nu_F), \qquad \tau_F \text{ into } F,\ \nu_F = -\tau_F",
        sides: "Left: the library's dihedral angle in g + tσ, differentiated in t. Right: σ on outward normals and \
            conormals. The paper's sum for −θ̇ has the opposite sign with the τ it describes: a forgery here.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let nu = i.nu().map(|x| x.value);
        // Of the two wedges on either side of a face, one is obtuse.
        vec![
            dihedral::<S, N>("wedge", i, nu),
            dihedral::<S, N>("neighbouring wedge", i, -nu),
        ]
    }
}

fn dihedral<S: Timed, const N: usize>(
    name: &'static str,
    i: &Instance<S, N>,
    nu: Vector<S::Base, N>,
) -> Equation<S::Base> {
    let (base, sigma) = (i.still0(), i.sigma0());
    let corner = i.corner(&base, [&nu, &i.nu_bar]);
    let left = rate(i, [&nu.map(S::fixed), &i.nu_bar.map(S::fixed)]);
    let on = |f: usize| S::Base::half() * form(&sigma, &corner.normal(f), &corner.conormal(f));
    let names = ["½σ(n_a,τ_a)", "½σ(n_b,τ_b)"];
    let equation = Equation::new(name)
        .left("θ̇_ST", left)
        .right(names[0], on(0))
        .right(names[1], on(1))
        .forge_terms(
            "conormal as printed",
            vec![(names[0], vec![-on(0)]), (names[1], vec![-on(1)])],
        )
        .forge("cos θ = +g(n⁺,n⁻)", "θ̇_ST", -left);
    // θ = arcsin(…) is right for acute angles only.
    let cos = (-corner.product).to_real();
    if cos.is_nan() {
        return equation;
    }
    equation
        .forge(
            "angle by arcsine",
            "θ̇_ST",
            if cos < 0.0 { -left } else { left },
        )
        .somewhere()
}

//! P10–P13: the mean curvature in a moving frame.

use crate::harness::{Equation, Record, Timed, each, list};
use crate::stage::point::{Frame, Instance, Pointwise, along, sum};
use regge_curvature::linalg::{Vector, form};
use regge_curvature::scalar::Field;

/// ∇_{τ_i} τ_i in the metric g + tσ.
fn accelerations<S: Timed, const N: usize>(
    i: &Instance<S, N>,
    frame: &Frame<S, N>,
) -> Vec<Vector<S, N>> {
    let moving = i.moving0();
    each(&frame.tau, |t| {
        along(&moving.nabla_vector(t), &t.map(|x| x.value))
    })
}

/// All components of these vectors. Their tangential parts cancel in products with n: rounding is relative to them.
fn components<S: Timed, const N: usize>(
    vectors: &[Vector<S, N>],
    part: fn(S) -> S::Base,
) -> Vec<S::Base> {
    list(vectors.len() * N, |k| part(vectors[k / N][k % N]))
}

/// H in a frame.
pub struct P10;

impl Pointwise for P10 {
    const RECORD: Record = Record {
        label: "P10",
        paper: &["Hdot"],
        title: "The mean curvature in a frame",
        statement: r"H = -\sum_i g(n,\nabla_{\tau_i}\tau_i)",
        sides: "Left: the trace of the library's II, made of ∇ν. Right: covariant derivatives of frame fields.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, g) = (i.frame(), i.still0().g);
        let n = frame.n0();
        let bend = accelerations(i, &frame);
        vec![
            Equation::new("H")
                .left("H", i.moving_h().value())
                .right(
                    "−Σg(n,∇_ττ)",
                    -sum(&bend, |a| form(&g, &n, &a.map(S::value))),
                )
                .magnitude(components(&bend, S::value)),
        ]
    }
}

/// Ḣ, first step.
pub struct P11;

impl Pointwise for P11 {
    const RECORD: Record = Record {
        label: "P11",
        paper: &["Hdot0"],
        title: "The rate of change of the mean curvature, first step",
        statement: r"\dot H = \tfrac12 H\sigma(n,n)
            - \sum_i g\!\left(n,\frac{\partial}{\partial t}\nabla_{\tau_i}\tau_i\right)",
        sides: "Left: the trace of the library's II in g + tσ, differentiated in t. Right: a frame that turns and \
            stretches, differentiated in t. Both use H, the left its change and the right its value, which D04 pins down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let n = frame.n0();
        let bend = accelerations(i, &frame);
        let rate = |a: &Vector<S, N>| form(&scene.base.g, &n, &a.map(S::rate));
        vec![
            Equation::new("Ḣ")
                .left("Ḣ", i.moving_h().rate())
                .right("½Hσ(n,n)", S::Base::half() * scene.face.h * scene.s_nn)
                .right("−Σg(n,∂_t∇_ττ)", -sum(&bend, rate))
                .magnitude(components(&bend, S::rate)),
        ]
    }
}

/// The frame's rate and II.
pub struct P12;

impl Pointwise for P12 {
    const RECORD: Record = Record {
        label: "P12",
        paper: &["Hdot"],
        title: "The frame's own motion gives the second fundamental form",
        statement: r"2\sum_i g(n,\nabla_{\dot\tau_i}\tau_i) = \langle\mathrm{II},\sigma|_F\rangle",
        sides: "Left: the rates of a moving frame. Right: the library's II against σ.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let n = frame.n0();
        let (mut left, mut size) = (S::Base::zero(), Vec::new());
        for (tau, rate) in frame.tau1().iter().zip(frame.tau_rate()) {
            let bend = along(&scene.base.nabla_vector(tau), &rate);
            left += form(&scene.base.g, &n, &bend);
            size.extend(bend.iter().copied());
        }
        vec![
            Equation::new("frame and II")
                .left("2Σg(n,∇_τ̇ τ)", left + left)
                .right("⟨II,σ⟩", scene.ii_sigma)
                .magnitude(size),
        ]
    }
}

/// Ḣ, second step.
pub struct P13;

impl Pointwise for P13 {
    const RECORD: Record = Record {
        label: "P13",
        paper: &["Hdot"],
        title: "The rate of change of the mean curvature",
        statement: r"\dot H = \tfrac12 H\sigma(n,n) - \langle\mathrm{II},\sigma|_F\rangle
            + \sum_i\left[\tfrac12(\nabla_n\sigma)(\tau_i,\tau_i) - (\nabla_{\tau_i}\sigma)(n,\tau_i)\right]",
        sides: "Left: the trace of the library's II in g + tσ, differentiated in t. Right: covariant derivatives of \
            σ on a frame at t = 0. Both use II, the left its change and the right its value, which D03 and D04 pin down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let (n, tau) = (frame.n0(), frame.tau0());
        let half = S::Base::half();
        vec![
            Equation::new("Ḣ")
                .left("Ḣ", i.moving_h().rate())
                .right("½Hσ(n,n)", half * scene.face.h * scene.s_nn)
                .right("−⟨II,σ⟩", -scene.ii_sigma)
                .right(
                    "½Σ(∇_nσ)(τ,τ)",
                    half * sum(&tau, |t| scene.nabla_sigma(&n, t, t)),
                )
                .right("−Σ(∇_τσ)(n,τ)", -sum(&tau, |t| scene.nabla_sigma(t, &n, t))),
        ]
    }
}

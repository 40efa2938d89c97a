//! P14–P19: from frames to invariant expressions.

use crate::harness::{Equation, Record, Timed};
use crate::stage::point::{Instance, Pointwise, along, derivative, sum};
use regge_curvature::linalg::form;
use regge_curvature::scalar::Field;

/// ⟨II, σ⟩ in a frame.
pub struct P14;

impl Pointwise for P14 {
    const RECORD: Record = Record {
        label: "P14",
        paper: &["sffsigma"],
        title: "The second fundamental form against σ",
        statement: r"\langle\mathrm{II},\sigma|_F\rangle = \sum_i\sigma(\nabla_{\tau_i}n,\tau_i)",
        sides: "Left: the library's II with the tangential part of g⁻¹. Right: derivatives of the field n on a frame.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let nabla_n = scene.base.nabla_vector(&frame.n1());
        let right = sum(&frame.tau0(), |t| {
            form(&scene.sigma, &along(&nabla_n, t), t)
        });
        vec![
            Equation::new("⟨II,σ⟩")
                .left("⟨II,σ⟩", scene.ii_sigma)
                .right("Σσ(∇_τ n,τ)", right),
        ]
    }
}

/// (div 𝕊σ)(n) in a frame.
pub struct P15;

impl Pointwise for P15 {
    const RECORD: Record = Record {
        label: "P15",
        paper: &["divSsigman"],
        title: "The normal component of div 𝕊σ",
        statement: r"(\operatorname{div}\mathbb{S}\sigma)(n) = \sum_i\left[(\nabla_{\tau_i}\sigma)(n,\tau_i)
            - (\nabla_n\sigma)(\tau_i,\tau_i)\right]",
        sides: "Left: the divergence of the jets of 𝕊σ with g⁻¹. Right: covariant derivatives of σ on a frame. Both use ∇σ, which P05 and O02 pin down: contracted with g⁻¹ on the left, in a frame on the right.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let (n, tau) = (frame.n0(), frame.tau0());
        vec![
            Equation::new("(div 𝕊σ)(n)")
                .left("(div 𝕊σ)(n)", scene.div_s_n)
                .right("Σ(∇_τσ)(n,τ)", sum(&tau, |t| scene.nabla_sigma(t, &n, t)))
                .right("−Σ(∇_nσ)(τ,τ)", -sum(&tau, |t| scene.nabla_sigma(&n, t, t)))
                .forge("div for div 𝕊", "(div 𝕊σ)(n)", scene.div_n())
                .forge("𝕊 with ½", "(div 𝕊σ)(n)", scene.div_half_n()),
        ]
    }
}

/// div_F(σ(n,·)) in a frame.
pub struct P16;

impl Pointwise for P16 {
    const RECORD: Record = Record {
        label: "P16",
        paper: &["divFsigman"],
        title: "The surface divergence of σ(n,·)",
        statement: r"\operatorname{div}_F(\sigma(n,\cdot)) = \sum_i\left[\nabla_{\tau_i}(\sigma(n,\tau_i))
            - \sigma(n,\nabla_{\tau_i}\tau_i)\right]",
        sides: "Left: the library's surface divergence of the jets of σ(n,·). Right: derivatives of functions along a \
            frame field.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let (n1, n) = (frame.n1(), frame.n0());
        let (mut first, mut second) = (S::Base::zero(), S::Base::zero());
        for t in &frame.tau1() {
            let at = t.map(|x| x.value);
            first += derivative(&form(&scene.sigma1, &n1, t), &at);
            second += form(&scene.sigma, &n, &along(&scene.base.nabla_vector(t), &at));
        }
        vec![
            Equation::new("div_F(σ(n,·))")
                .left("div_F(σ(n,·))", scene.div_f)
                .right("Σ∇_τ(σ(n,τ))", first)
                .right("−Σσ(n,∇_ττ)", -second),
        ]
    }
}

/// lemma:rewritten.
pub struct P17;

impl Pointwise for P17 {
    const RECORD: Record = Record {
        label: "P17",
        paper: &["lemma:rewritten", "rewritten"],
        title: "Frame derivatives rewritten",
        statement: r"\sum_i\left[\tfrac12(\nabla_n\sigma)(\tau_i,\tau_i) - (\nabla_{\tau_i}\sigma)(n,\tau_i)\right]
            = \tfrac12\left(\langle\mathrm{II},\sigma|_F\rangle - (\operatorname{div}\mathbb{S}\sigma)(n)
            - \operatorname{div}_F(\sigma(n,\cdot))\right)",
        sides: "Left: covariant derivatives of σ on a frame. Right: the library's II, div 𝕊 and div_F. The library's ∇σ is in both: in a frame on the left, contracted with g⁻¹ on the right.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let (n, tau) = (frame.n0(), frame.tau0());
        let half = S::Base::half();
        vec![
            Equation::new("rewritten")
                .left(
                    "½Σ(∇_nσ)(τ,τ)",
                    half * sum(&tau, |t| scene.nabla_sigma(&n, t, t)),
                )
                .left("−Σ(∇_τσ)(n,τ)", -sum(&tau, |t| scene.nabla_sigma(t, &n, t)))
                .right("½⟨II,σ⟩", half * scene.ii_sigma)
                .right("−½(div 𝕊σ)(n)", -half * scene.div_s_n)
                .right("−½div_F(σ(n,·))", -half * scene.div_f)
                .forge("div for div 𝕊", "−½(div 𝕊σ)(n)", -half * scene.div_n()),
        ]
    }
}

/// Ḣ, invariantly.
pub struct P18;

impl Pointwise for P18 {
    const RECORD: Record = Record {
        label: "P18",
        paper: &["Hdot2"],
        title: "The rate of change of the mean curvature, invariantly",
        statement: r"\dot H = \tfrac12\left(-\langle\mathrm{II},\sigma|_F\rangle - (\operatorname{div}\mathbb{S}\sigma)(n)
            - \operatorname{div}_F(\sigma(n,\cdot)) + H\sigma(n,n)\right)",
        sides: "Left: the trace of the library's II in g + tσ, differentiated in t. Right: II, div 𝕊 and div_F at \
            t = 0. Both use II, the left its change and the right its value, which D03 and D04 pin down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let scene = i.scene();
        let half = S::Base::half();
        vec![
            Equation::new("Ḣ")
                .left("Ḣ", i.moving_h().rate())
                .right("−½⟨II,σ⟩", -half * scene.ii_sigma)
                .right("−½(div 𝕊σ)(n)", -half * scene.div_s_n)
                .right("−½div_F(σ(n,·))", -half * scene.div_f)
                .right("½Hσ(n,n)", half * scene.face.h * scene.s_nn)
                .forge("div for div 𝕊", "−½(div 𝕊σ)(n)", -half * scene.div_n())
                .forge("𝕊 with ½", "−½(div 𝕊σ)(n)", -half * scene.div_half_n()),
        ]
    }
}

/// ⟨II‾, σ⟩.
pub struct P19;

impl Pointwise for P19 {
    const RECORD: Record = Record {
        label: "P19",
        paper: &["prop:Homegadot"],
        title: "The trace-reversed second fundamental form against σ",
        statement: r"\langle\mathrm{II},\sigma|_F\rangle - H\operatorname{Tr}(\sigma|_F)
            = \langle\overline{\mathrm{II}},\sigma|_F\rangle",
        sides: "Left: II on a frame. Right: the library's II‾ with the tangential part of g⁻¹. II itself is pinned down by D03 and D04.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let scene = i.scene();
        let tau = i.frame().tau0();
        let mut against = S::Base::zero();
        for a in &tau {
            against += sum(&tau, |b| {
                form(&scene.face.second_form, a, b) * form(&scene.sigma, a, b)
            });
        }
        let trace = sum(&tau, |t| form(&scene.sigma, t, t));
        let reversed = scene
            .face
            .normal
            .inner(&scene.face.trace_reversed, &scene.sigma);
        vec![
            Equation::new("⟨II‾,σ⟩")
                .left("⟨II,σ⟩", against)
                .left("−H Tr(σ|_F)", -scene.face.h * trace)
                .right("⟨II‾,σ⟩", reversed)
                .vanishes(N == 2, "II‾ = 0 when N = 2")
                .forge("II for II‾", "⟨II‾,σ⟩", scene.ii_sigma),
        ]
    }
}

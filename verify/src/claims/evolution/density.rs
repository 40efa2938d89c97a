//! P20, P21: how the densitized mean curvature changes.

use crate::harness::{Equation, Record, Timed};
use crate::stage::point::{Instance, Pointwise, Scene, along, derivative, mean_curvature_density};
use regge_curvature::jet::Jet1;
use regge_curvature::linalg::{Vector, form};
use regge_curvature::scalar::Field;

/// ∂_t(Hω_F).
pub struct P20;

impl Pointwise for P20 {
    const RECORD: Record = Record {
        label: "P20",
        paper: &["prop:Homegadot", "Homegadot"],
        title: "The rate of change of the densitized mean curvature",
        statement: r"\frac{\partial}{\partial t}(H\omega_F) = -\tfrac12\left(\langle\overline{\mathrm{II}},\sigma|_F\rangle
            + (\operatorname{div}\mathbb{S}\sigma)(n) + \operatorname{div}_F(\sigma(n,\cdot)) - H\sigma(n,n)\right)\omega_F",
        sides: "Left: Hω_F in g + tσ, differentiated in t. Right: II‾, div 𝕊 and div_F at t = 0. On a level set of a \
            random function and on a plane, for both orientations. Both use II, the left its change and the right its value, which D03 and D04 pin down.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        vec![
            density::<S, N>("curved F", i, &i.nu()),
            density::<S, N>("flat F", i, &i.flat_nu()),
            density::<S, N>("curved F, −n", i, &i.nu().map(|x| -x)),
        ]
    }
}

fn density<S: Timed, const N: usize>(
    name: &'static str,
    i: &Instance<S, N>,
    nu: &Vector<Jet1<S::Base, N>, N>,
) -> Equation<S::Base> {
    let scene = Scene::new::<S>(i, nu);
    let face = &scene.face;
    let minus_half = -S::Base::half() * face.normal.omega;
    let reversed = face.normal.inner(&face.trace_reversed, &scene.sigma);
    Equation::new(name)
        .left("∂_t(Hω_F)", mean_curvature_density::<S, N>(i, nu).rate())
        .right("−½⟨II‾,σ⟩ω_F", minus_half * reversed)
        .vanishes(N == 2, "II‾ = 0 when N = 2")
        .right("−½(div 𝕊σ)(n)ω_F", minus_half * scene.div_s_n)
        .right("−½div_F(σ(n,·))ω_F", minus_half * scene.div_f)
        .right("½Hσ(n,n)ω_F", -minus_half * face.h * scene.s_nn)
        .forge("II for II‾", "−½⟨II‾,σ⟩ω_F", minus_half * scene.ii_sigma)
        .forge(
            "div for div 𝕊",
            "−½(div 𝕊σ)(n)ω_F",
            minus_half * scene.div_n(),
        )
        .forge(
            "𝕊 with ½",
            "−½(div 𝕊σ)(n)ω_F",
            minus_half * scene.div_half_n(),
        )
}

/// The remark on N = 2.
pub struct P21;

impl Pointwise for P21 {
    const RECORD: Record = Record {
        label: "P21",
        paper: &["prop:Homegadot"],
        title: "Two dimensions: the remark after the proposition",
        statement: r"\nabla_\tau n = H\tau,\quad -\nabla_\tau\tau = Hn,\quad \overline{\mathrm{II}} = 0,\quad
            \operatorname{div}_F(\sigma(n,\cdot)) - H\sigma(n,n) = \nabla_\tau(\sigma(n,\tau)),\quad
            \frac{\partial}{\partial t}(H\omega_F) = -\tfrac12\left((\operatorname{div}\mathbb{S}\sigma)(n)
            + \nabla_\tau(\sigma(n,\tau))\right)\omega_F",
        sides: "Left: derivatives of n and τ as fields, and Hω_F in g + tσ. Right: the library's H and div 𝕊.",
    };
    const DIMENSIONS: &'static [usize] = &[2];

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (frame, scene) = (i.frame(), i.scene());
        let (face, n1, tau1) = (&scene.face, frame.n1(), frame.tau1()[0]);
        let (n, tau) = (frame.n0(), frame.tau0()[0]);
        let turn = along(&scene.base.nabla_vector(&n1), &tau);
        let bend = along(&scene.base.nabla_vector(&tau1), &tau);
        let shear = derivative(&form(&scene.sigma1, &n1, &tau1), &tau);
        let reversed = face.trace_reversed;
        let minus_half = -S::Base::half() * face.normal.omega;
        vec![
            Equation::new("∇_τ n")
                .left("∇_τ n", turn)
                .right("Hτ", tau.map(|x| face.h * x)),
            Equation::new("∇_τ τ")
                .left("−∇_τ τ", -bend)
                .right("Hn", n.map(|x| face.h * x)),
            Equation::new("II‾")
                .left("II‾(τ,τ)", form(&reversed, &tau, &tau))
                .vanishes(true, "II‾ = 0 when N = 2")
                .magnitude(face.h)
                .forge(
                    "II for II‾",
                    "II‾(τ,τ)",
                    form(&face.second_form, &tau, &tau),
                ),
            Equation::new("div_F")
                .left("div_F(σ(n,·))", scene.div_f)
                .left("−Hσ(n,n)", -face.h * scene.s_nn)
                .right("∇_τ(σ(n,τ))", shear),
            Equation::new("∂_t(Hω_F)")
                .left(
                    "∂_t(Hω_F)",
                    mean_curvature_density::<S, N>(i, &i.nu()).rate(),
                )
                .right("−½(div 𝕊σ)(n)ω_F", minus_half * scene.div_s_n)
                .right("−½∇_τ(σ(n,τ))ω_F", minus_half * shear),
        ]
    }
}

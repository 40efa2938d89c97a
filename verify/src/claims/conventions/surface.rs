//! D05, D06, T02: surface gradient and surface divergence.

use crate::harness::{Equation, Record, Timed};
use crate::stage::point::{Instance, Pointwise, derivative, orthonormal, sum};
use regge_curvature::density::surface_div;
use regge_curvature::jet::{Jet1, lower_vector};
use regge_curvature::linalg::{Vector, apply, contract, form};
use regge_curvature::riemann::differential;
use regge_curvature::scalar::Field;

/// ∇_F v.
pub struct D05;

impl Pointwise for D05 {
    const RECORD: Record = Record {
        label: "D05",
        paper: &["sec:evolution_mean"],
        title: "The surface gradient",
        statement: r"\nabla_F v = \nabla v - n\nabla_n v = \sum_i\tau_i\nabla_{\tau_i}v,\qquad g(n,\nabla_F v) = 0",
        sides: "Left: dv raised with the library's tangential part of g⁻¹. Right: the gradient, and a frame.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, frame) = (i.still0(), i.frame());
        let normal = i.normal(&base, &i.nu().map(|x| x.value));
        let dv = lower_vector(&differential(&i.v));
        let along_n = contract(&dv, &normal.n);
        let surface = apply(&normal.tangential, &dv);
        let mut in_frame = Vector::from_element(S::Base::zero());
        for t in frame.tau0() {
            in_frame += t.map(|x| x * contract(&dv, &t));
        }
        vec![
            Equation::new("∇_F v")
                .left("∇_F v", surface)
                .right("∇v", base.sharp(&dv))
                .right("−n∇_n v", normal.n.map(|x| -x * along_n)),
            Equation::new("frame")
                .left("∇_F v", surface)
                .right("Στ∇_τ v", in_frame),
            Equation::new("tangential")
                .left("g(n,∇_F v)", form(&base.g, &normal.n, &surface))
                .vanishes(true, "∇_F v is tangent to F")
                .magnitude(along_n)
                .forge("∇v for ∇_F v", "g(n,∇_F v)", along_n),
        ]
    }
}

/// div_F α.
pub struct D06;

impl Pointwise for D06 {
    const RECORD: Record = Record {
        label: "D06",
        paper: &["sec:evolution_mean"],
        title: "The surface divergence",
        statement: r"\operatorname{div}_F\alpha = \sum_i(\nabla_{\tau_i}\alpha)(\tau_i)
            \text{ in any orthonormal frame; it needs } \alpha \text{ along } F \text{ only}",
        sides: "Left: the library's div_F with the tangential part of g⁻¹. Right: two different frames; another \
            extension of α.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, frame) = (i.still0(), i.frame());
        let nu = i.nu().map(|x| x.value);
        let normal = i.normal(&base, &nu);
        let nabla = base.nabla_covector(&i.alpha);
        let div = surface_div(&base, &normal, &i.alpha);
        // The same vectors in the opposite order give another frame.
        let mut seeds = vec![frame.n0()];
        for seed in i.seeds.iter().rev() {
            seeds.push(seed.map(|x| x.value.value()));
        }
        let other = orthonormal(&base.g, &seeds).split_off(1);
        let full = base.div_covector(&i.alpha);
        // α + φβ, which is α on F = {φ = 0}.
        let extended = Vector::from_fn(|j, _| Jet1 {
            value: i.alpha[j].value,
            d: std::array::from_fn(|m| i.alpha[j].d[m] + nu[m] * i.nu_bar[j]),
        });
        vec![
            Equation::new("frame")
                .left("div_F α", div)
                .right("Σ(∇_τ α)(τ)", sum(&frame.tau0(), |t| form(&nabla, t, t)))
                .forge("div for div_F", "div_F α", full),
            Equation::new("another frame")
                .left("div_F α", div)
                .right("Σ(∇_τ′ α)(τ′)", sum(&other, |t| form(&nabla, t, t))),
            Equation::new("another extension")
                .left("div_F α", div)
                .right("div_F(α+φβ)", surface_div(&base, &normal, &extended))
                .forge("div for div_F", "div_F(α+φβ)", base.div_covector(&extended)),
        ]
    }
}

/// The product rule of the integration by parts.
pub struct T02;

impl Pointwise for T02 {
    const RECORD: Record = Record {
        label: "T02",
        paper: &["lemma:IBPdivdivS"],
        title: "The product rule on a face",
        statement: r"\sigma(n,\nabla_F v) = \operatorname{div}_F(\sigma(n,\cdot)v) - \operatorname{div}_F(\sigma(n,\cdot))\,v,
            \qquad \mathbb{S}\sigma(n,\nabla_F v) = \sigma(n,\nabla_F v)",
        sides: "Left: σ and 𝕊σ on n and ∇_F v. Right: surface divergences of jets; a frame.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let scene = i.scene();
        let normal = &scene.face.normal;
        let dv = lower_vector(&differential(&i.v));
        let gradient = apply(&normal.tangential, &dv);
        let around = i.normal(&scene.still, &i.nu());
        let v = Jet1 {
            value: i.v.value,
            d: i.v.d,
        };
        let flux = apply(&scene.sigma1, &around.n).map(|a| a * v);
        let s_sigma = scene.base.reverse_trace(&i.formulas, &scene.sigma);
        let in_frame = sum(&i.frame().tau0(), |t| {
            derivative(&v, t) * form(&scene.sigma, &normal.n, t)
        });
        let full = scene.base.sharp(&dv);
        vec![
            Equation::new("product rule")
                .left("σ(n,∇_F v)", form(&scene.sigma, &normal.n, &gradient))
                .right("div_F(σ(n,·)v)", surface_div(&scene.base, normal, &flux))
                .right("−div_F(σ(n,·))v", -scene.div_f * i.v.value)
                .forge(
                    "∇v for ∇_F v",
                    "σ(n,∇_F v)",
                    form(&scene.sigma, &normal.n, &full),
                ),
            Equation::new("𝕊σ")
                .left("𝕊σ(n,∇_F v)", form(&s_sigma, &normal.n, &gradient))
                .right("Σσ(n,τ)∇_τ v", in_frame)
                .forge(
                    "∇v for ∇_F v",
                    "𝕊σ(n,∇_F v)",
                    form(&s_sigma, &normal.n, &full),
                ),
        ]
    }
}

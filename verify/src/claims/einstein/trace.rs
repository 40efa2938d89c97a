//! M11, M19: the trace of the Einstein tensor.

use crate::harness::{Draw, Equation, Judgement, Record, Setting, Timed};
use crate::stage::mesh::{FLAT, OnMesh, Pair, ROUNDING, at_points, times, values};
use crate::stage::point::{Instance, Over, Pointwise, Scene};
use regge_curvature::functional::{a_h, distributional_curvature};
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::Field;

/// The trace of the Einstein tensor, of II‾ and of g|_S.
pub struct M11;

impl Pointwise for M11 {
    const RECORD: Record = Record {
        label: "M11",
        paper: &["sec:einstein"],
        title: "The trace of the distributional Einstein tensor, at a point",
        statement: r"\langle G,g\rangle = -\tfrac{N-2}{2}R,\quad \langle\overline{\mathrm{II}},g|_F\rangle = -(N-2)H,\quad
            \langle g|_S,g|_S\rangle = N-2",
        sides: "Left: full contractions of the tensors. Right: R, H and the dimension.",
    };

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let still = i.still();
        let (base, r) = (still.lower(), still.scalar());
        let scene = i.scene();
        let times = |k: usize, x: S::Base| S::Base::from_int(-(k as i64)) * x;
        let half_r = S::Base::half() * r;
        let nu = i.nu().map(|x| x.value);
        let on_s = i.corner(&base, [&nu, &i.nu_bar]).trace(&base.g);
        vec![
            Equation::new("⟨G,g⟩")
                .left("⟨G,g⟩", base.inner(&still.einstein(&i.formulas), &base.g))
                .vanishes(N == 2, "G = 0 when N = 2")
                .right("−(N−2)R/2", times(N - 2, half_r))
                .vanishes(N == 2, "N − 2 = 0")
                .magnitude(r)
                .forge("N−1 for N−2", "−(N−2)R/2", times(N - 1, half_r)),
            reversed_trace::<S, N>(&scene, &base),
            Equation::new("Tr(g|_S)")
                .left("Tr(g|_S)", on_s)
                .vanishes(N == 2, "S is a point")
                .right("N−2", -times(N - 2, S::Base::one()))
                .vanishes(N == 2, "N − 2 = 0")
                .magnitude(S::Base::from_int(2))
                .forge("N−1 for N−2", "N−2", -times(N - 1, S::Base::one())),
        ]
    }
}

/// ⟨II‾, g|_F⟩ = −(N−2) H.
fn reversed_trace<S: Timed, const N: usize>(
    scene: &Scene<S::Base, N>,
    base: &Connection<S::Base, N>,
) -> Equation<S::Base> {
    let reversed = &scene.face.trace_reversed;
    let h = scene.face.h;
    let times = |k: usize| S::Base::from_int(-(k as i64)) * h;
    Equation::new("⟨II‾,g⟩")
        .left("⟨II‾,g⟩", scene.face.normal.inner(reversed, &base.g))
        .vanishes(N == 2, "II‾ = 0 when N = 2")
        .right("−(N−2)H", times(N - 2))
        .vanishes(N == 2, "N − 2 = 0")
        .magnitude(h)
        .forge("N−1 for N−2", "−(N−2)H", times(N - 1))
        .forge("II for II‾", "⟨II‾,g⟩", h)
}

/// The trace of the Einstein tensor.
pub struct M19;

impl OnMesh for M19 {
    const RECORD: Record = Record {
        label: "M19",
        paper: &["sec:einstein"],
        title: "The trace of the distributional Einstein tensor",
        statement: r"\langle (G\omega)_{\rm dist}(g),gv\rangle = -\frac{N-2}{2}\langle (R\omega)_{\rm dist}(g),v\rangle,
            \text{ sum by sum}",
        sides: "Left: the production a_h with σ = g: Ric, II‾ and hinge traces contracted with g. Right: the production \
            functional of def:distcurv. They share Γ, H and Θ, whose values D03, D11 and O01–O03 check; the claim is about the \
            contractions. The same rule on both sides: no quadrature error.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(_: usize, quick: bool) -> Vec<Setting> {
        at_points(quick)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let Pair {
            g, space, rules, ..
        } = Pair::<N>::draw(at, draw);
        let a = values(a_h(&g, &g, &space, &rules));
        let r = values(distributional_curvature(&g, &space, &rules));
        let (flat, surface) = (at.degree == 0, N == 2);
        let size = r.s.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let side = |name, left: &[f64], right: &[f64], none: bool| {
            Equation::new(name)
                .left("⟨(Gω),gv⟩", left.to_vec())
                .vanishes(none || surface, "N − 2 = 0, or g is constant on cells")
                .right("−(N−2)/2 ⟨(Rω),v⟩", times(-0.5 * (N as f64 - 2.0), right))
                .vanishes(none || surface, "N − 2 = 0, or g is constant on cells")
                .magnitude(size)
                .forge(
                    "N − 1 for N − 2",
                    "−(N−2)/2 ⟨(Rω),v⟩",
                    times(-0.5 * (N as f64 - 1.0), right),
                )
                .vacuous(none, FLAT)
        };
        vec![
            side("Σ_T", &a.t, &r.t, flat),
            side("Σ_F", &a.f, &r.f, flat),
            side("Σ_S", &a.s, &r.s, false),
        ]
    }
}

/// What is integrated on a mesh satisfies the equations of M11 at every point.
impl Pointwise for M19 {
    const RECORD: Record = <Self as OnMesh>::RECORD;
    const DIMENSIONS: &'static [usize] = &[2, 3, 4];
    const OVER: Over = Over::Integers;

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        M11::equations::<S, N>(i)
    }
}

//! M07: surfaces have no Einstein tensor.

use crate::harness::{Draw, Equation, Judgement, Record, Setting, Shape, Timed, grid};
use crate::stage::mesh::{FLAT, OnMesh, POINTS, Pair, ROUNDING};
use crate::stage::point::{Instance, Over, Pointwise};
use regge_curvature::density::Inside;
use regge_curvature::formulas::Formulas;

/// (Gω)_dist = 0 when N = 2.
pub struct M07;

impl OnMesh for M07 {
    const RECORD: Record = Record {
        label: "M07",
        paper: &["def:distein"],
        title: "The distributional Einstein tensor of a surface vanishes",
        statement: r"N=2:\qquad (G\omega)_{\rm dist}(g)=0,\ \text{each of its three sums for itself}",
        sides: "Left: each sum of the production a_h; exactly, what is integrated there. Right: nothing.",
    };
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[2];

    fn settings(_: usize, quick: bool) -> Vec<Setting> {
        use Shape::{Alfeld, Cube, Sphere, Torus};
        let shapes = [Alfeld, Cube(2), Torus(3), Sphere];
        grid(&shapes, &[4, 4, 4], if quick { 1 } else { 6 })
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let pair = Pair::<N>::draw(at, draw);
        let plain = Formulas {
            trace_reversed: 0,
            ..at.formulas
        };
        let (a, plain) = (pair.a(), pair.a_by(plain));
        let flat = at.degree == 0;
        // R and Θ of size 1 times σ of size 1: what cancels.
        let size = 1.0;
        vec![
            Equation::new("∫⟨G,σ⟩vω")
                .left("Σ_T", a.t)
                .vanishes(true, "G = 0")
                .magnitude(size),
            Equation::new("∫⟨⟦II‾⟧,σ⟩vω_F")
                .left("Σ_F", a.f)
                .vanishes(true, "II‾ = II − Hg = 0 on a curve")
                .magnitude(size)
                .forge("II for II‾", "Σ_F", plain.f)
                .vacuous(flat, FLAT),
            Equation::new("∫Θ Tr(σ|_S)v")
                .left("Σ_S", a.s)
                .vanishes(true, POINTS)
                .magnitude(size),
        ]
    }
}

/// What is integrated on a mesh vanishes at every point: G, II‾ and σ|_S.
impl Pointwise for M07 {
    const RECORD: Record = <Self as OnMesh>::RECORD;
    const DIMENSIONS: &'static [usize] = &[2];
    const OVER: Over = Over::Integers;

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (still, scene, sigma) = (i.still(), i.scene(), i.sigma0());
        let base = still.lower();
        let (einstein, omega) = Inside::new(&i.formulas, &i.g, &base).einstein();
        let (reversed, omega_f) = (scene.face.trace_reversed, scene.face.normal.omega);
        let nu = i.nu().map(|x| x.value);
        let on_s = i.corner(&base, [&nu, &i.nu_bar]).trace(&sigma);
        vec![
            Equation::new("⟨G,σ⟩ω")
                .left("⟨G,σ⟩ω", base.inner(&einstein, &sigma) * omega)
                .vanishes(true, "G = 0")
                .forge(
                    "Ric for G",
                    "⟨G,σ⟩ω",
                    base.inner(&still.ricci(), &sigma) * omega,
                ),
            Equation::new("⟨II‾,σ⟩ω_F")
                .left(
                    "⟨II‾,σ⟩ω_F",
                    scene.face.normal.inner(&reversed, &sigma) * omega_f,
                )
                .vanishes(true, "II‾ = II − Hg = 0 on a curve")
                .forge("II for II‾", "⟨II‾,σ⟩ω_F", scene.ii_sigma * omega_f),
            Equation::new("Tr(σ|_S)")
                .left("Tr(σ|_S)", on_s)
                .vanishes(true, "S is a point")
                .forge("Tr σ", "Tr(σ|_S)", base.trace(&sigma)),
        ]
    }
}

//! M12: the Einstein tensor of piecewise constant metrics.

use crate::harness::{Draw, Equation, Judgement, Record, Setting, Shape, Timed, grid};
use crate::stage::fields::moving;
use crate::stage::mesh::{OnMesh, Pair, ROUNDING, Tested};
use crate::stage::point::{Instance, Over, Pointwise};
use crate::stage::reference::{FlatHinge, hinges, leading_minor};
use num_dual::Dual64;
use regge_curvature::linalg::Vector;
use regge_curvature::scalar::Field;

/// ⟨Gω,σ⟩ = −Σ Θ Tr(σ|_S) V_S.
pub struct M12;

impl OnMesh for M12 {
    const RECORD: Record = Record {
        label: "M12",
        paper: &["def:distein"],
        title: "The distributional Einstein tensor of a piecewise constant metric",
        statement: r"\langle (G\omega)_{\rm dist}(g),\sigma\rangle = -\mathring{\sum_S}\int_S\Theta_S\operatorname{Tr}(\sigma|_S)
            \,\omega_S = -2\,\mathring{\sum_S}\,\Theta_S\dot V_S",
        sides: "Left: the production a_h with v = 1. Right: angles and volumes from edge lengths by Cholesky's factors, over \
            dual numbers: nothing of the library. Exactly: Tr(σ|_S)ω_S = 2V̇_S, with V_S a root of a minor of g; Θ_S is only a \
            factor on both sides.",
    };
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[3, 4];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 2 } else { 16 };
        match dimension {
            3 => grid(&[Shape::Alfeld, Shape::Cube(2), Shape::Sphere], &[2], times),
            _ => grid(&[Shape::Alfeld, Shape::Sphere], &[2], times),
        }
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let pair = Pair::<N>::draw(at, draw);
        let one = Tested::One.of_sums(&pair.space, &pair.a());
        let laid_out = hinges::<Dual64, N>(&moving(&pair.g, &pair.sigma));
        let sum = |f: fn(&FlatHinge<Dual64>) -> f64| laid_out.iter().map(f).sum::<f64>();
        let size = sum(|h| (h.defect.re * h.volume.eps).abs() + h.volume.eps.abs());
        vec![
            Equation::new("⟨Gω,σ⟩")
                .left("Σ_T ∫⟨G,σ⟩ω", one.t)
                .vanishes(true, "g is constant on cells")
                .left("Σ_F ∫⟨⟦II‾⟧,σ⟩ω_F", one.f)
                .vanishes(true, "g is constant on cells")
                .left("−Σ_S ∫Θ Tr(σ|_S)ω_S", one.s)
                .right("−2Σ Θ V̇", sum(|h| -2.0 * h.defect.re * h.volume.eps))
                // Near a flat metric Θ is a small difference of angles near 2π.
                .magnitude(size),
        ]
    }
}

/// At a point Tr(σ|_S) ω_S = 2V̇_S, whatever Θ_S.
impl Pointwise for M12 {
    const RECORD: Record = <Self as OnMesh>::RECORD;
    const DIMENSIONS: &'static [usize] = &[3, 4, 5];
    const OVER: Over = Over::Integers;

    fn equations<S: Timed, const N: usize>(i: &Instance<S, N>) -> Vec<Equation<S::Base>> {
        let (base, sigma) = (i.still0(), i.sigma0());
        // S is spanned by the first N − 2 coordinate directions.
        let last = |k: usize| {
            let unit = |m: usize| if m + k == N { 1 } else { 0 };
            Vector::<S::Base, N>::from_fn(|m, _| S::Base::from_int(unit(m)))
        };
        let (nu, other) = (last(1), last(2));
        let corner = i.corner(&base, [&nu, &other]);
        let omega_s = corner.omega();
        let rate = leading_minor(&i.moving0().g, N - 2).sqrt().rate();
        vec![
            Equation::new("Tr(σ|_S)ω_S")
                .left("Tr(σ|_S)ω_S", corner.trace(&sigma) * omega_s)
                .right("2V̇_S", rate + rate)
                .forge("Tr σ", "Tr(σ|_S)ω_S", base.trace(&sigma) * omega_s),
        ]
    }
}

//! M12, M13, M14: piecewise constant metrics.

use super::euclid::{FlatHinge, against_hats, hinges};
use super::fields::{Tested, metric, moving, times};
use super::pair::with_pair;
use super::setting::{Draw, OnMesh, ROUNDING, Setting, Shape, grid};
use crate::claim::{Equation, Judgement, Record};
use num_dual::Dual64;
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{Rules, distributional_curvature_with};
use regge_curvature::spaces::Lagrange;
use regge_curvature::spaces::ReggeSpace;

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

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 2 } else { 16 };
        match dimension {
            3 => grid(&[Shape::Alfeld, Shape::Cube(2), Shape::Sphere], &[2], times),
            4 => grid(&[Shape::Alfeld, Shape::Sphere], &[2], times),
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let (one, laid_out) = with_pair::<_, N>(at, draw, |pair| {
            let one = Tested::One.of_sums(&pair.space, &pair.a::<K>());
            (one, hinges::<Dual64, N>(&moving(&pair.g, &pair.sigma)))
        });
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

/// Regge's action.
pub struct M14;

impl OnMesh for M14 {
    const RECORD: Record = Record {
        label: "M14",
        paper: &["sec:einstein", "def:distcurv"],
        title: "Regge's action is half of the functional",
        statement: r"\langle (R\omega)_{\rm dist}(g),v\rangle = 2\,\mathring{\sum_S}\,\Theta_S\int_S v\,\omega_S,\qquad
            \langle (R\omega)_{\rm dist}(g),1\rangle = 2\,\mathring{\sum_S}\,\Theta_S V_S\quad\text{for piecewise constant } g",
        sides: "Left: the production functional. Right: angles and volumes from edge lengths by Cholesky's factors.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 2 } else { 12 };
        match dimension {
            2..=4 => grid(&[Shape::Alfeld, Shape::Sphere], &[2], times),
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, 0);
        let g = metric(&regge, draw);
        let hats = Lagrange::new(&mesh, 1);
        let sums = distributional_curvature_with::<K, f64, N, _>(&g, &hats, &Rules::new::<N>(2));
        let size: f64 = hinges::<f64, N>(&g).iter().map(|h| h.volume).sum();
        vec![
            Equation::new("⟨Rω,v⟩")
                .left("2Σ_S ∫Θvω_S", sums.hinges.clone())
                .right("2Σ Θ ∫v", against_hats(&g))
                // Θ is a difference of angles of size 2π.
                .magnitude(std::f64::consts::TAU * size)
                .forge(
                    "the factor 2 dropped",
                    "2Σ_S ∫Θvω_S",
                    times(0.5, &sums.hinges),
                ),
        ]
    }
}

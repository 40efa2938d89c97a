//! M03: the rates of all three sums together.

use super::defects::{Moving, pointwise};
use super::density::FaceTerms;
use super::fields::{Three, minus};
use super::setting::{Draw, OnMesh, ROUNDING, Setting};
use super::variation::{FLAT, POINTS};
use crate::claim::{Equation, Judgement, Record};
use regge::formulas::Formulas;
use regge::lagrange::Lagrange;
use regge::regge::ReggeSpace;

/// The six-term formula.
pub struct M03;

impl OnMesh for M03 {
    const RECORD: Record = Record {
        label: "M03",
        paper: &["distcurvdot0", "intcurvdot"],
        title: "The rate of the distributional curvature, before integrating by parts",
        statement: r"\frac{d}{dt}\langle (R\omega)_{\rm dist}(g(t)),v\rangle = \sum_T\int_T(\operatorname{div}\operatorname{div}
            \mathbb{S}\sigma)v\omega - \mathring{\sum_F}\int_F[\![(\operatorname{div}\mathbb{S}\sigma)(n) +
            \operatorname{div}_F(\sigma(n,\cdot)) - H\sigma(n,n)]\!]v\omega_F - \mathring{\sum_S}\int_S\sum_{F\supset S}
            [\![\sigma(n,\tau)]\!]_F v\omega_S - a_h(g;\sigma,v)",
        sides: "Left: the functional over dual numbers. Right: covariant derivatives of σ, and a_h, at t = 0. The same rule \
            on both sides: no quadrature error. The sign of the third sum is corrected.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        pointwise(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let (regge, space) = (
            ReggeSpace::new(&mesh, at.degree),
            Lagrange::new(&mesh, at.test),
        );
        let m = Moving::<N>::new::<K>(at, draw, &regge, &space);
        let (a, cells, turned) = (m.a::<K>(), m.cells::<K>(), m.hinges::<K>());
        let flux = minus(&m.faces::<K>(1.0, FaceTerms::flux));
        let (flat, surface) = (at.degree == 0, N == 2);
        let all =
            |x: &Three| -> Vec<f64> { (0..x.t.len()).map(|i| x.t[i] + x.f[i] + x.s[i]).collect() };
        let on_cells = Equation::new("on cells")
            .left("d/dt ∫Rvω", m.rate.t.clone())
            .vanishes(flat, FLAT)
            .right("∫(div div 𝕊σ)vω", cells.clone())
            .vanishes(flat, FLAT)
            .right("−∫⟨G,σ⟩vω", minus(&a.t))
            .vanishes(
                flat || surface,
                "G = 0 when N = 2, or g is constant on cells",
            )
            .magnitude(turned.clone());
        let whole = Equation::new("all")
            .left("d/dt⟨(Rω)_dist,v⟩", all(&m.rate))
            .right("Σ_T ∫(div div 𝕊σ)vω", cells)
            .vanishes(flat, FLAT)
            .right("−Σ̊_F ∫⟦(div 𝕊σ)(n) + div_F(σ(n,·)) − Hσ(n,n)⟧vω_F", flux)
            .vanishes(flat, FLAT)
            .right("−Σ̊_S ∫Σ_F⟦σ(n,τ)⟧vω_S", minus(&turned))
            .right("−Σ_T ∫⟨G,σ⟩vω", minus(&a.t))
            .vanishes(
                flat || surface,
                "G = 0 when N = 2, or g is constant on cells",
            )
            .right("−Σ̊_F ∫⟨⟦II‾⟧,σ⟩vω_F", minus(&a.f))
            .vanishes(
                flat || surface,
                "II‾ = 0 when N = 2, or g is constant on cells",
            )
            .right("Σ̊_S ∫Θ Tr(σ|_S)vω_S", minus(&a.s))
            .vanishes(surface, POINTS)
            .forge("the printed sign of τ", "−Σ̊_S ∫Σ_F⟦σ(n,τ)⟧vω_S", turned);
        vec![on_cells, whole]
    }
}

//! D11: def:distcurv against NGSolve.

use super::setting::{Draw, OnMesh, Setting, Shape};
use super::variation::FLAT;
use crate::claim::{Equation, Judgement, Method, Record};
use crate::oracle;
use regge::formulas::Formulas;
use regge::functional::{Rules, distributional_curvature_with};
use regge::lagrange::Lagrange;
use regge::regge::ReggeSpace;

/// The three sums of def:distcurv.
pub struct D11;

impl OnMesh for D11 {
    const RECORD: Record = Record {
        label: "D11",
        paper: &["def:distcurv", "distcurv"],
        title: "The definition, against a code that nobody here wrote",
        statement: r"\langle (R\omega)_{\rm dist}(g),v\rangle = \sum_T\int_T R_Tv\omega_T + 2\mathring{\sum_F}\int_F[\![H]\!]v
            \omega_F + 2\mathring{\sum_S}\int_S\Theta_Sv\omega_S",
        sides: "Left: the production sums with the oracle's own g_h. Right: NGSolve and ngsdiffgeo: another basis, another \
            quadrature, derivatives by differences (which limits the agreement to 1e-8).",
    };
    const METHOD: Method = Method::Oracle;
    /// NGSolve's differences leave errors of 1e-9 to 1e-7 of an entry; a third code agrees to 1e-9 of the largest.
    const JUDGEMENT: Judgement = Judgement::Rounding { tolerance: 1e-8 };

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let cases = oracle::numbers(dimension).into_iter();
        let kept = cases.take(if quick { 3 } else { 5 });
        kept.map(|i| Setting::new(Shape::Oracle(i), 0, 20))
            .collect()
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let Shape::Oracle(number) = at.shape else {
            return Vec::new();
        };
        let case = oracle::case(number);
        let mesh = case.mesh::<N>();
        let space = ReggeSpace::new(&mesh, case.degree);
        let hats = Lagrange::new(&mesh, 1);
        let g = case.metric(&space);
        let sums =
            distributional_curvature_with::<K, f64, N, _>(&g, &hats, &Rules::new::<N>(at.order));
        let known = &case.curvature;
        let all = known.element.iter().chain(&known.face).chain(&known.angle);
        let largest = all.fold(0.0, |m: f64, x| m.max(x.abs()));
        let of = |sum: &[f64]| -> Vec<f64> { known.vertex.iter().map(|&v| sum[v]).collect() };
        let side = |name, ours: &[f64], theirs: &[f64], none: bool| {
            Equation::new(name)
                .left("ours", of(ours))
                .vanishes(none, FLAT)
                .right("NGSolve", theirs.to_vec())
                .vanishes(none, FLAT)
                .magnitude(largest)
        };
        let flat = case.degree == 0;
        vec![
            side("Σ_T ∫Rvω", &sums.element, &known.element, flat),
            side("2Σ̊_F ∫⟦H⟧vω_F", &sums.face, &known.face, flat),
            side("2Σ̊_S ∫Θvω_S", &sums.hinge, &known.angle, false),
        ]
    }
}

//! D10: smooth metrics.

use super::fields::values;
use super::patch::Patch;
use super::setting::{Draw, OnMesh, ROUNDING, Setting, Shape, grid};
use crate::claim::{Equation, Judgement, Record};
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{
    Rules, a_h_with, distributional_curvature_with, smooth_curvature,
};
use regge_curvature::metrics::Metric;
use regge_curvature::metrics::Smooth;
use regge_curvature::spaces::Lagrange;

/// A smooth metric has no jumps.
pub struct D10;

impl OnMesh for D10 {
    const RECORD: Record = Record {
        label: "D10",
        paper: &["def:distcurv"],
        title: "For smooth metrics the distributional curvature is the curvature",
        statement: r"g\text{ smooth}:\quad [\![H]\!]_F=0,\ [\![I\!I]\!]_F=0,\ \Theta_S=0,\quad (R\omega)_{\rm dist}(g)=(R\omega)(g)",
        sides: "Left: the production sums of a metric that each cell sees in coordinates of its own; a factor or normal that is \
            wrong on one side of a face leaves something behind. Right: ∫Rvω over the cells alone, by the same R (checked by \
            O01–O03); as an oracle, NGSolve's integral of the curvature in closed form.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let shapes = [Shape::Alfeld, Shape::Cube(2)];
        match (dimension, quick) {
            (2 | 3, true) => grid(&shapes[..1], &[3], 3),
            (2 | 3, false) => grid(&shapes, &[4], 15),
            (4, _) => grid(&shapes[..1], &[3], if quick { 1 } else { 6 }),
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let space = Lagrange::new(&mesh, at.test);
        let rules = Rules::new::<N>(at.order);
        let formula = [Metric::Trig, Metric::GraphQuartic, Metric::Sphere][at.pick % 3];
        // The mesh has coordinates.
        let g = Smooth::new(&mesh, Patch::new(formula, draw)).unwrap_or_else(|e| panic!("{e}"));
        let sums = values(distributional_curvature_with::<K, f64, N, _>(
            &g, &space, &rules,
        ));
        let a = values(a_h_with::<K, f64, N, _, _>(&g, &g, &space, &rules));
        let smooth = smooth_curvature::<f64, N, _>(&g, &space, &rules.cells);
        let why = "g is smooth";
        vec![
            Equation::new("(Rω)_dist")
                .left("Σ_T ∫Rvω", sums.t)
                .left("2Σ̊_F ∫⟦H⟧vω_F", sums.f)
                .vanishes(true, why)
                .left("2Σ̊_S ∫Θvω_S", sums.s)
                .vanishes(true, why)
                .right("∫Rvω", smooth)
                // Angles of size 2π cancel around hinges of size 1, and as much in ⟦H⟧.
                .magnitude(1.0),
            Equation::new("(Gω)_dist")
                .left("Σ̊_F ∫⟨⟦II‾⟧,g⟩vω_F", a.f)
                .vanishes(true, why)
                .left("−Σ̊_S ∫Θ Tr(g|_S)vω_S", a.s)
                .vanishes(true, why)
                .magnitude(1.0),
        ]
    }
}

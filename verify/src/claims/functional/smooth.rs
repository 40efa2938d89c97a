//! D10: smooth metrics.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape, grid};
use crate::stage::fields::Patch;
use crate::stage::mesh::{OnMesh, ROUNDING, values};
use crate::stage::reference::{NGSOLVE, case_of, cases};
use regge_curvature::functional::{a_h, distributional_curvature, smooth_curvature};
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::{Metric, Smooth};
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
            _ => grid(&shapes[..1], &[3], if quick { 1 } else { 6 }),
        }
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let space = Lagrange::new(&mesh, at.test);
        let rules = at.rules(N);
        let formula = [Metric::Trig, Metric::GraphQuartic, Metric::Sphere][at.pick % 3];
        let g = Smooth::new(&mesh, Patch::new(formula, draw)).expect("the mesh has coordinates");
        let sums = values(distributional_curvature(&g, &space, &rules));
        let a = values(a_h(&g, &g, &space, &rules));
        let smooth = smooth_curvature(&g, &space, &rules);
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

/// NGSolve's integrals of the curvature of the smooth metric.
pub struct SmoothOracle;

impl OnMesh for SmoothOracle {
    const RECORD: Record = D10::RECORD;
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = NGSOLVE;
    const DIMENSIONS: &'static [usize] = &[2, 3];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        // Those with a curvature in closed form.
        cases(dimension, quick, |case| case.metric != "trig")
    }

    fn equations<const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh: Mesh<N> = case.mesh();
        let hats = Lagrange::new(&mesh, 1);
        let g = Smooth::new(&mesh, case.formula()).expect("the mesh has coordinates");
        let rules = at.rules(N);
        let sums = distributional_curvature(&g, &hats, &rules);
        let known = &case.curvature;
        let smooth = known.smooth.clone();
        vec![
            Equation::new("∫Rωφ_i")
                .left("Σ_T ∫Rvω", known.tested(&sums.cells))
                .left("2Σ̊_F ∫⟦H⟧vω_F", known.tested(&sums.faces))
                .vanishes(true, "g is smooth")
                .left("2Σ̊_S ∫Θvω_S", known.tested(&sums.hinges))
                .vanishes(true, "g is smooth")
                .right("NGSolve", smooth.expect("these cases know it")),
        ]
    }
}

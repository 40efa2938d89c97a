//! M14: Regge's action.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape, grid};
use crate::stage::fields::wild;
use crate::stage::mesh::{OnMesh, ROUNDING, minus, times};
use crate::stage::reference::{against_hats, case_of, cases, hinges};
use regge_curvature::functional::distributional_curvature;
use regge_curvature::mesh::Mesh;
use regge_curvature::spaces::{Lagrange, ReggeSpace};

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

    fn settings(_: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 2 } else { 12 };
        grid(&[Shape::Alfeld, Shape::Sphere], &[2], times)
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, 0);
        let g = wild(&regge, draw, at.noise);
        let hats = Lagrange::new(&mesh, 1);
        let sums = distributional_curvature(&g, &hats, &at.rules(N));
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

/// Regge's action from edge lengths, against NGSolve's hinge sums.
pub struct ActionOracle;

impl OnMesh for ActionOracle {
    const RECORD: Record = M14::RECORD;
    const METHOD: Method = Method::Oracle;
    /// NGSolve differentiates nothing when r = 0.
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[2, 3];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        cases(dimension, quick, |case| case.degree == 0)
    }

    fn equations<const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh: Mesh<N> = case.mesh();
        let regge = ReggeSpace::new(&mesh, 0);
        let expected = against_hats(&case.metric(&regge));
        let known = &case.curvature;
        let (name, ours) = ("2Σ Θ ∫v", known.tested(&expected));
        vec![
            Equation::new("⟨Rω,v⟩")
                .left("NGSolve", known.angle.clone())
                .right(name, ours.clone())
                .forge("the factor 2 dropped", name, times(0.5, &ours))
                .forge("a saddle for a cone", name, minus(&ours)),
        ]
    }
}

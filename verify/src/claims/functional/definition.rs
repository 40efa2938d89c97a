//! Against NGSolve: D11, the definition; D10, smooth metrics; M14, Regge's action; I29, the interpolants.

use crate::harness::{Draw, Equation, Excuses, Judgement, Method, Record, Setting};
use crate::stage::fields::{combination, flat};
use crate::stage::mesh::{FLAT, OnMesh, Pair, Three};
use crate::stage::reference::{FEW, NGSOLVE, case_of, cases};
use regge_curvature::functional::distributional_curvature;
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::spaces::{Lagrange, ReggeSpace};

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
            quadrature, derivatives by differences (which limits the agreement to 1e-8). Along the segment from δ to g_h: \
            ∫₀¹ b_h − a_h dt, with no curvature of ours at all, against the sum of NGSolve's three.",
    };
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = NGSOLVE;
    const DIMENSIONS: &'static [usize] = &[2, 3];
    const EXCUSES: Excuses = Excuses::NONE.few_cases(FEW);

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        cases(dimension, quick, |_| true)
    }

    fn equations<const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh = case.mesh::<N>();
        let (space, hats) = (ReggeSpace::new(&mesh, case.degree), Lagrange::new(&mesh, 1));
        let (g, rules) = (case.metric(&space), at.rules(N));
        let sums = distributional_curvature(&g, &hats, &rules);
        let known = &case.curvature;
        let side = |name, ours: &[f64], theirs: &[f64], none: bool| {
            Equation::new(name)
                .left("ours", known.tested(ours))
                .vanishes(none, FLAT)
                .right("NGSolve", theirs.to_vec())
                .vanishes(none, FLAT)
                .magnitude(known.largest())
        };
        let flat = case.degree == 0;
        vec![
            side("Σ_T ∫Rvω", &sums.cells, &known.element, flat),
            side("2Σ̊_F ∫⟦H⟧vω_F", &sums.faces, &known.face, flat),
            side("2Σ̊_S ∫Θvω_S", &sums.hinges, &known.angle, false),
        ]
    }
}

/// The same by the theorem: from δ, which has no curvature, to NGSolve's g_h.
pub struct FromFlat;

/// The metrics of the cases are far from δ: Gauss' rule needs more points there than elsewhere.
const POINTS_FROM_FLAT: usize = 14;

impl OnMesh for FromFlat {
    const RECORD: Record = D11::RECORD;
    const METHOD: Method = Method::Homotopy;
    const JUDGEMENT: Judgement = NGSOLVE;
    const DIMENSIONS: &'static [usize] = D11::DIMENSIONS;

    /// Not the two large meshes.
    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        cases(dimension, quick, |case| case.simplices.len() < 100)
    }

    fn equations<const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh = case.mesh::<N>();
        let (regge, hats) = (ReggeSpace::new(&mesh, case.degree), Lagrange::new(&mesh, 1));
        let flat = flat(&regge);
        let g = case.metric(&regge);
        let sigma = combination(-1.0, &flat, 1.0, &g);
        let (nodes, weights) = gauss_legendre(POINTS_FROM_FLAT);
        let (mut b, mut a) = (vec![0.0; hats.len()], vec![0.0; hats.len()]);
        for (t, w) in nodes.into_iter().zip(weights) {
            let at_t = combination(1.0 - t, &flat, t, &g);
            let pair = Pair::new(at, hats.clone(), at_t, sigma.clone());
            add(&mut b, w, &pair.b());
            add(&mut a, -w, &pair.a());
        }
        let known = &case.curvature;
        let sums = known.element.iter().zip(&known.face).zip(&known.angle);
        let all: Vec<f64> = sums.map(|((t, f), s)| t + f + s).collect();
        vec![
            Equation::new("from the flat metric")
                .left("NGSolve", all)
                .right("∫b_h dt", known.tested(&b))
                .right("−∫a_h dt", known.tested(&a))
                .vanishes(N == 2, "(Gω)_dist = 0 when N = 2")
                .magnitude(known.largest()),
        ]
    }
}

fn add(sum: &mut [f64], w: f64, three: &Three) {
    for (i, s) in sum.iter_mut().enumerate() {
        *s += w * (three.t[i] + three.f[i] + three.s[i]);
    }
}

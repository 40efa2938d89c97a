//! Against NGSolve: D11, the definition; D10, smooth metrics; M14, Regge's action; I29, the interpolants.

use super::euclid;
use super::fields::{Three, flat, function, minus, times};
use super::pair::Pair;
use super::setting::{Draw, OnMesh, ROUNDING, Setting, Shape};
use super::smooth::D10;
use super::spaces::I29;
use super::variation::FLAT;
use crate::claim::{Equation, Excuses, Judgement, Method, Record};
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{Rules, distributional_curvature_with};
use regge_curvature::interpolate::Interpolant;
use regge_curvature::mesh::Mesh;
use regge_curvature::metrics::Smooth;
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::spaces::Lagrange;
use regge_curvature::spaces::ReggeSpace;
use regge_oracle::Oracle;

/// NGSolve's differences leave errors of 1e-9 to 1e-7 of an entry; a third code agrees to 1e-9 of the largest.
const NGSOLVE: Judgement = Judgement::Rounding { tolerance: 1e-8 };
const FEW: &str = "there are ten reference cases";

/// The reference cases, some of them.
fn cases(dimension: usize, quick: bool, wanted: fn(&Oracle) -> bool) -> Vec<Setting> {
    let all = regge_oracle::numbers(dimension).into_iter();
    let kept = all.take(if quick { 3 } else { 5 });
    kept.filter(|&i| wanted(&regge_oracle::case(i)))
        .map(|i| Setting::new(Shape::Oracle(i), 0, 20))
        .collect()
}

fn case_of(at: &Setting) -> Oracle {
    let Shape::Oracle(number) = at.shape else {
        panic!("these settings are reference cases")
    };
    regge_oracle::case(number)
}

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
    const EXCUSES: Excuses = Excuses::NONE.few_cases(FEW);

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        cases(dimension, quick, |_| true)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh = case.mesh::<N>();
        let (space, hats) = (ReggeSpace::new(&mesh, case.degree), Lagrange::new(&mesh, 1));
        let (g, rules) = (case.metric(&space), Rules::new::<N>(at.order));
        let sums = distributional_curvature_with::<K, f64, N, _>(&g, &hats, &rules);
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

    /// Not the two large meshes.
    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        cases(dimension, quick, |case| case.simplices.len() < 100)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh = case.mesh::<N>();
        let (regge, hats) = (ReggeSpace::new(&mesh, case.degree), Lagrange::new(&mesh, 1));
        let flat = flat(&regge);
        let g = case.metric(&regge);
        let (nodes, weights) = gauss_legendre(POINTS_FROM_FLAT);
        let (mut b, mut a) = (vec![0.0; hats.len()], vec![0.0; hats.len()]);
        for (t, w) in nodes.into_iter().zip(weights) {
            let mix = |x: f64, y: f64| {
                let pairs = flat.coefficients().iter().zip(g.coefficients());
                function(&regge, pairs.map(|(f, g)| x * f + y * g).collect())
            };
            let pair = Pair {
                space: hats.clone(),
                rules: Rules::new::<N>(at.order),
                g: mix(1.0 - t, t),
                sigma: mix(-1.0, 1.0),
            };
            add(&mut b, w, &pair.b::<K>());
            add(&mut a, -w, &pair.a::<K>());
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

/// NGSolve's integrals of the curvature of the smooth metric.
pub struct SmoothOracle;

impl OnMesh for SmoothOracle {
    const RECORD: Record = D10::RECORD;
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = NGSOLVE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        // Those with a curvature in closed form.
        cases(dimension, quick, |case| case.metric != "trig")
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh: Mesh<N> = case.mesh();
        let hats = Lagrange::new(&mesh, 1);
        // The mesh has coordinates.
        let g = Smooth::new(&mesh, case.formula()).unwrap_or_else(|e| panic!("{e}"));
        let rules = Rules::new::<N>(at.order);
        let sums = distributional_curvature_with::<K, f64, N, _>(&g, &hats, &rules);
        let known = &case.curvature;
        vec![
            Equation::new("∫Rωφ_i")
                .left("Σ_T ∫Rvω", known.tested(&sums.cells))
                .left("2Σ̊_F ∫⟦H⟧vω_F", known.tested(&sums.faces))
                .vanishes(true, "g is smooth")
                .left("2Σ̊_S ∫Θvω_S", known.tested(&sums.hinges))
                .vanishes(true, "g is smooth")
                .right("NGSolve", known.smooth.clone().unwrap_or_default()),
        ]
    }
}

/// Regge's action from edge lengths, against NGSolve's hinge sums.
pub struct ActionOracle;

impl OnMesh for ActionOracle {
    const RECORD: Record = super::constant::M14::RECORD;
    const METHOD: Method = Method::Oracle;
    /// NGSolve differentiates nothing when r = 0.
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        cases(dimension, quick, |case| case.degree == 0)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh: Mesh<N> = case.mesh();
        let regge = ReggeSpace::new(&mesh, 0);
        let expected = euclid::against_hats(&case.metric(&regge));
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

/// NGSolve's interpolants.
pub struct InterpolantOracle;

impl OnMesh for InterpolantOracle {
    const RECORD: Record = I29::RECORD;
    const METHOD: Method = Method::Oracle;
    /// What NGSolve's integration of a metric that is no polynomial leaves.
    const JUDGEMENT: Judgement = Judgement::Rounding { tolerance: 1e-9 };

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        cases(dimension, quick, |_| true)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, _: &mut Draw) -> Vec<Equation<f64>> {
        let case = case_of(at);
        let mesh: Mesh<N> = case.mesh();
        let regge = ReggeSpace::new(&mesh, case.degree);
        let g = Smooth::new(&mesh, case.formula()).unwrap_or_else(|e| panic!("{e}"));
        let hierarchical = Interpolant::average_hierarchical().with_order(at.order);
        let (canonical, same) = (case.interpolant == "canonical", case.degree == 0);
        let interpolant = if canonical {
            Interpolant::canonical().with_order(at.order)
        } else {
            hierarchical
        };
        let other = Interpolant::average();
        let by = |i: &Interpolant| {
            let g_h = i.apply(&regge, &g).unwrap_or_else(|e| panic!("{e}"));
            g_h.coefficients().to_vec()
        };
        vec![
            Equation::new("coefficients")
                .left("g_h", by(&interpolant))
                .right("NGSolve's g_h", case.metric(&regge).coefficients().to_vec())
                .forge("another interpolant", "g_h", by(&other))
                .vacuous(same && !canonical, "for r = 0 both averages are one"),
        ]
    }
}

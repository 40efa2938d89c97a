//! M13: the second variation at the flat metric.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape, grid};
use crate::stage::fields::{
    Regge, Seen, combination, flat, function, integral, moving, near_flat, variation,
};
use crate::stage::mesh::{HingeTerms, OnMesh, POINTS_IN_T, QUADRATURE, ROUNDING, too_few};
use crate::stage::reference::hinges;
use num_dual::HyperDual64;
use regge_curvature::functional::{a_h, distributional_curvature};
use regge_curvature::linalg::Mat;
use regge_curvature::quadrature::gauss_legendre;
use regge_curvature::spaces::{Lagrange, ReggeSpace};

/// The Hessian at the flat metric.
pub struct M13;

/// −Σ_S ∫ Σ_F ⟦ρ(n,τ)⟧ Tr(σ|_S) ω_S / 2, τ into F: Σ Θ̇ Tr(σ|_S) ω_S of the corrected lemma.
fn bilinear<const N: usize>(
    at: &Setting,
    g: &Regge<f64, N>,
    rho: &Regge<f64, N>,
    sigma: &Regge<f64, N>,
) -> f64 {
    let mesh = g.space().mesh();
    let hats = Lagrange::new(mesh, 1);
    let rule = at.rules(N).hinges;
    let (seen, on_rho, on_sigma) = (
        Seen::<f64, N, _>::new(g, N - 2, &rule),
        Seen::<f64, N, _>::new(rho, N - 2, &rule),
        Seen::<f64, N, _>::new(sigma, N - 2, &rule),
    );
    let terms = |metric: &Mat<f64, N>, field: Mat<f64, N>, place| {
        HingeTerms::new::<N>(&at.formulas, metric, &field, place)
    };
    let sum = integral(
        &hats,
        N - 2,
        &rule,
        &mut mesh.interior_hinges(),
        &|_, side, p| {
            let value = seen.value(side, p);
            let turn = terms(&value, on_rho.value(side, p), side.place).normal_conormal;
            -0.5 * turn * terms(&value, on_sigma.value(side, p), side.place).trace
        },
    );
    sum.iter().sum()
}

/// On the flat 3-torus: d²/dt² of ⟨(Rω)_dist(δ+tσ), 1⟩ by hyper-dual numbers for one random σ, and
/// ½Σ_S∫Σ_F⟦σ(n,τ)⟧Tr(σ|_S)ω_S with τ pointing into F, as it is printed.
pub fn second_variation(draw: &mut Draw) -> (f64, f64) {
    let at = Setting::new(Shape::Torus(3), 0, 2);
    let regge = ReggeSpace::new(&at.shape.mesh::<3>(), 0);
    let (g, sigma) = (flat(&regge), variation(&regge, draw));
    (
        hessian(&at, &g, &sigma, &sigma).iter().sum(),
        -bilinear(&at, &g, &sigma, &sigma),
    )
}

/// ∂²/∂s∂t ⟨(Rω)_dist(g+sρ+tσ), φ⟩ for the hat functions φ.
fn hessian<const N: usize>(
    at: &Setting,
    g: &Regge<f64, N>,
    rho: &Regge<f64, N>,
    sigma: &Regge<f64, N>,
) -> Vec<f64> {
    let (hats, rules) = (Lagrange::new(g.space().mesh(), 1), at.rules(N));
    let sums = distributional_curvature(&moved_twice(g, rho, sigma), &hats, &rules);
    sums.hinges.iter().map(|x| x.eps1eps2).collect()
}

/// g+sρ+tσ to first order in s and in t.
fn moved_twice<const N: usize>(
    g: &Regge<f64, N>,
    rho: &Regge<f64, N>,
    sigma: &Regge<f64, N>,
) -> Regge<HyperDual64, N> {
    let rates = rho.coefficients().iter().zip(sigma.coefficients());
    let three = g.coefficients().iter().zip(rates);
    let moved = three.map(|(g, (r, s))| HyperDual64::new(*g, *r, *s, 0.0));
    function(g.space(), moved.collect())
}

impl OnMesh for M13 {
    const RECORD: Record = Record {
        label: "M13",
        paper: &["sec:einstein", "angledefectdot"],
        title: "The second variation at the flat metric (Christiansen's formula, sign corrected)",
        statement: r"\frac{d}{dt}\Big|_0\langle (G\omega)_{\rm dist}(\delta+t\rho),\sigma\rangle = -\mathring{\sum_S}\int_S
            \dot\Theta_S\operatorname{Tr}(\sigma|_S)\omega_S,\qquad \frac{d^2}{dt^2}\Big|_0\langle (R\omega)_{\rm dist}
            (\delta+t\sigma),1\rangle = -\frac12\mathring{\sum_S}\int_S\sum_{F\supset S}[\![\sigma(n,\tau)]\!]_F
            \operatorname{Tr}(\sigma|_S)\omega_S",
        sides: "Left: the functionals over dual and hyper-dual numbers: dihedral angles. Right: normals and conormals of the \
            flat metric, no angle. With the printed sign of τ the second variation comes out negated. Along a path from δ: \
            Taylor's formula with the remainder as an integral, where Θ_S is not 0 and twice the volumes' second derivative, \
            (½Tr(σ|_S)² − |σ|_S|²)ω_S, enters as well, by hyper-dual numbers from the edges' lengths; −½Tr(σ|_S)²ω_S, which is the same for an edge, is a forgery \
            when N = 4.",
    };
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[3, 4];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        // The hinges are 189 edges in dimension 3, 4050 triangles in dimension 4.
        let times = if dimension == 3 { 64 } else { 8 };
        grid(&[Shape::Torus(3)], &[2], if quick { 1 } else { times })
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, 0);
        let g = flat(&regge);
        let (rho, sigma) = (variation(&regge, draw), variation(&regge, draw));
        let (hats, rules) = (Lagrange::new(&mesh, 1), at.rules(N));
        let gradient = |along: &Regge<f64, N>, against: &Regge<f64, N>| -> f64 {
            let moved = moving(&g, along);
            let a = a_h(&moved, against, &hats, &rules);
            a.hinges.iter().map(|x| x.eps).sum()
        };
        let by_hats = hessian(at, &g, &rho, &sigma);
        let hessian: f64 = by_hats.iter().sum();
        // The sums are of hundreds of hinges with either sign, and may be small by chance.
        let size = vec![by_hats.iter().map(|x| x.abs()).sum::<f64>()];
        let formula = bilinear(at, &g, &rho, &sigma);
        vec![
            Equation::new("d/dt⟨Gω(δ+tρ),σ⟩")
                .left("d/dt⟨Gω(δ+tρ),σ⟩", gradient(&rho, &sigma))
                .right("½ΣΣ⟦ρ(n,τ)⟧Tr(σ|_S)", -formula)
                .magnitude(size.clone())
                .forge("the printed sign of τ", "½ΣΣ⟦ρ(n,τ)⟧Tr(σ|_S)", formula),
            Equation::new("symmetry")
                .left("d/dt⟨Gω(δ+tρ),σ⟩", gradient(&rho, &sigma))
                .right("d/dt⟨Gω(δ+tσ),ρ⟩", gradient(&sigma, &rho))
                .magnitude(size.clone()),
            Equation::new("second variation")
                .left("∂²⟨Rω(δ+sρ+tσ),1⟩", hessian)
                .right("−½ΣΣ⟦ρ(n,τ)⟧Tr(σ|_S)", formula)
                .magnitude(size)
                .forge("the printed sign of τ", "−½ΣΣ⟦ρ(n,τ)⟧Tr(σ|_S)", -formula)
                .forge(
                    "Regge's action for ⟨Rω,1⟩",
                    "∂²⟨Rω(δ+sρ+tσ),1⟩",
                    0.5 * hessian,
                ),
        ]
    }
}

/// The second variation along a finite path: f(δ+σ) = ∫₀¹ (1−t) f''(δ+tσ) dt, as f and f' vanish at δ.
pub struct FromFlat;

const EDGES: &str = "hinges are edges when N = 3";

/// f'' at g, and what might be taken for it.
#[derive(Clone, Copy, Default)]
struct Second {
    /// −½ΣΣ⟦σ(n,τ)⟧Tr(σ|_S)ω_S = ΣΘ̇ Tr(σ|_S)ω_S.
    turn: f64,
    /// 2ΣΘV̈ = ΣΘ(½Tr(σ|_S)² − |σ|_S|²)ω_S.
    bend: f64,
    /// −½ΣΘ Tr(σ|_S)²ω_S: the same for edges, whose |σ|_S| is |Tr(σ|_S)|, and not for hinges of any other dimension.
    of_edges: f64,
    /// ½ΣΘ Tr(σ|_S)²ω_S.
    of_traces: f64,
}

impl Second {
    fn at<const N: usize>(at: &Setting, g: &Regge<f64, N>, sigma: &Regge<f64, N>) -> Self {
        let mut sums = Self {
            turn: bilinear(at, g, sigma, sigma),
            ..Self::default()
        };
        for h in hinges::<HyperDual64, N>(&moved_twice(g, sigma, sigma)) {
            let (theta, v) = (h.defect.re, h.volume);
            // V̇ = ½Tr(σ|_S)V.
            let squared = 2.0 * theta * v.eps1 * v.eps2 / v.re;
            sums.bend += 2.0 * theta * v.eps1eps2;
            sums.of_edges -= squared;
            sums.of_traces += squared;
        }
        sums
    }

    fn add(&mut self, weight: f64, other: Self) {
        self.turn += weight * other.turn;
        self.bend += weight * other.bend;
        self.of_edges += weight * other.of_edges;
        self.of_traces += weight * other.of_traces;
    }
}

impl FromFlat {
    /// ∫(1−t)f''(δ+tσ) dt by so many Gauss points.
    fn integrals<const N: usize>(at: &Setting, ends: [&Regge<f64, N>; 2], points: usize) -> Second {
        let [from, to] = ends;
        let sigma = combination(-1.0, from, 1.0, to);
        let mut sums = Second::default();
        let (nodes, weights) = gauss_legendre(points);
        for (t, w) in nodes.into_iter().zip(weights) {
            let g = combination(1.0 - t, from, t, to);
            sums.add(w * (1.0 - t), Second::at(at, &g, &sigma));
        }
        sums
    }
}

impl OnMesh for FromFlat {
    const RECORD: Record = M13::RECORD;
    const METHOD: Method = Method::Homotopy;
    const JUDGEMENT: Judgement = QUADRATURE;
    const DIMENSIONS: &'static [usize] = M13::DIMENSIONS;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let all = M13::settings(dimension, quick).into_iter();
        all.take(8).collect()
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let (regge, hats) = (ReggeSpace::new(&mesh, 0), Lagrange::new(&mesh, 1));
        let from = flat(&regge);
        let to = near_flat(&regge, &draw.numbers(regge.len()), 0.05);
        let rules = at.rules(N);
        let sums = distributional_curvature(&to, &hats, &rules);
        let second = Self::integrals(at, [&from, &to], POINTS_IN_T);
        let size: f64 = hinges::<f64, N>(&to)
            .iter()
            .map(|h| (h.defect * h.volume).abs())
            .sum();
        let names = ["−½∫(1−t)ΣΣ⟦σ(n,τ)⟧Tr(σ|_S) dt", "2∫(1−t)ΣΘV̈ dt"];
        let mut equation = Equation::new("from the flat metric")
            .left("⟨Rω(δ+σ),1⟩", sums.hinges.iter().sum::<f64>())
            .right(names[0], second.turn)
            .right(names[1], second.bend)
            .magnitude(size)
            .forge("the printed sign of τ", names[0], -second.turn)
            .forge("V̈ without |σ|_S|²", names[1], second.of_traces)
            .forge("the V̈ of an edge", names[1], second.of_edges)
            .vacuous(N == 3, EDGES);
        for (points, name) in too_few(at, N) {
            let coarse = Self::integrals(at, [&from, &to], points);
            let both = names
                .into_iter()
                .zip([vec![coarse.turn], vec![coarse.bend]]);
            equation = equation.forge_terms(name, both.collect()).somewhere();
        }
        vec![equation]
    }
}

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
    let three = g
        .coefficients()
        .iter()
        .zip(rho.coefficients())
        .zip(sigma.coefficients());
    let moved = three
        .map(|((g, r), s)| HyperDual64::new(*g, *r, *s, 0.0))
        .collect();
    let moved = function(g.space(), moved);
    let sums = distributional_curvature(&moved, &hats, &rules);
    sums.hinges.iter().map(|x| x.eps1eps2).collect()
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
            Taylor's formula with the remainder as an integral, where the volumes' second derivatives enter as well.",
    };
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[3];

    fn settings(_: usize, quick: bool) -> Vec<Setting> {
        grid(&[Shape::Torus(3)], &[2], if quick { 1 } else { 64 })
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

impl FromFlat {
    /// −½ΣΣ⟦σ(n,τ)⟧Tr(σ|_S)ω_S = ΣΘ̇ Tr(σ|_S)ω_S and 2ΣΘV̈ = −½ΣΘ Tr(σ|_S)²ω_S at g: an edge has the length √q, q its
    /// only coefficient.
    fn second<const N: usize>(at: &Setting, g: &Regge<f64, N>, sigma: &Regge<f64, N>) -> [f64; 2] {
        let (mesh, space) = (g.space().mesh(), g.space());
        let bent = hinges::<f64, N>(g).into_iter().map(|h| {
            let side = mesh.first_side(N - 2, h.hinge);
            let dof = space.cell_dof(side.cell, side.place, 0);
            let trace = sigma.coefficients()[dof] / g.coefficients()[dof];
            -0.5 * h.defect * trace * trace * h.volume
        });
        [bilinear(at, g, sigma, sigma), bent.sum()]
    }

    /// The integrals of both by so many Gauss points.
    fn integrals<const N: usize>(
        at: &Setting,
        ends: [&Regge<f64, N>; 2],
        points: usize,
    ) -> [f64; 2] {
        let [from, to] = ends;
        let sigma = combination(-1.0, from, 1.0, to);
        let mut sums = [0.0; 2];
        let (nodes, weights) = gauss_legendre(points);
        for (t, w) in nodes.into_iter().zip(weights) {
            let second = Self::second(at, &combination(1.0 - t, from, t, to), &sigma);
            for (sum, x) in sums.iter_mut().zip(second) {
                *sum += w * (1.0 - t) * x;
            }
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
        let [turn, bend] = Self::integrals(at, [&from, &to], POINTS_IN_T);
        let size: f64 = hinges::<f64, N>(&to)
            .iter()
            .map(|h| (h.defect * h.volume).abs())
            .sum();
        let names = ["−½∫(1−t)ΣΣ⟦σ(n,τ)⟧Tr(σ|_S) dt", "2∫(1−t)ΣΘV̈ dt"];
        let mut equation = Equation::new("from the flat metric")
            .left("⟨Rω(δ+σ),1⟩", sums.hinges.iter().sum::<f64>())
            .right(names[0], turn)
            .right(names[1], bend)
            .magnitude(size)
            .forge("the printed sign of τ", names[0], -turn);
        for (points, name) in too_few(at, N) {
            let coarse = Self::integrals(at, [&from, &to], points);
            let both = names.into_iter().zip(coarse.map(|x| vec![x]));
            equation = equation.forge_terms(name, both.collect()).somewhere();
        }
        vec![equation]
    }
}

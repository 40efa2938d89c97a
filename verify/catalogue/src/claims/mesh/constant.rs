//! M12, M13, M14: piecewise constant metrics.

use super::fields::{Regge, Tested, function, metric, moving, times, values, variation};
use super::setting::{Draw, OnMesh, ROUNDING, Setting, Shape, grid};
use crate::claim::{Equation, Judgement, Record};
use num_dual::{Dual64, HyperDual64};
use regge::formulas::{Formulas, Paper};
use regge::functional::{Rules, a_h_with, distributional_curvature_with, integrate};
use regge::lagrange::Lagrange;
use regge::linalg::Mat;
use regge::mesh::Mesh;
use regge::regge::ReggeSpace;

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
            dual numbers: nothing of the library.",
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
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, 0);
        let (g, sigma) = (metric(&regge, draw), variation(&regge, draw));
        let hats = Lagrange::new(&mesh, 1);
        let a = values(a_h_with::<K, f64, N, _, _>(
            &g,
            &sigma,
            &hats,
            &Rules::new::<N>(2),
        ));
        let one = Tested::One.of_sums(&hats, &a);
        let flat = super::euclid::hinges::<Dual64, N>(&moving(&g, &sigma));
        let sum: f64 = flat.iter().map(|h| -2.0 * h.defect.re * h.volume.eps).sum();
        let size: f64 = flat
            .iter()
            .map(|h| (h.defect.re * h.volume.eps).abs())
            .sum();
        vec![
            Equation::new("⟨Gω,σ⟩")
                .left("Σ_T ∫⟨G,σ⟩ω", one.t)
                .vanishes(true, "g is constant on cells")
                .left("Σ_F ∫⟨⟦II‾⟧,σ⟩ω_F", one.f)
                .vanishes(true, "g is constant on cells")
                .left("−Σ_S ∫Θ Tr(σ|_S)ω_S", one.s)
                .right("−2Σ Θ V̇", sum)
                // Near a flat metric Θ is a small difference of angles near 2π.
                .magnitude(size + flat.iter().map(|h| h.volume.eps.abs()).sum::<f64>()),
        ]
    }
}

/// The flat metric of a mesh with coordinates.
fn euclidean<'s, const N: usize>(space: &'s ReggeSpace<'s, N>) -> Regge<'s, f64, N> {
    let mesh = space.mesh();
    let mut coefficients = vec![1.0; space.len()];
    for cell in 0..mesh.cells() {
        for (e, edge) in regge::simplex::subsets(N + 1, 2).iter().enumerate() {
            if let (Some(a), Some(b)) = (mesh.corner(cell, edge[0]), mesh.corner(cell, edge[1])) {
                coefficients[space.cell_dof(cell, e, 0)] = (a - b).norm_squared();
            }
        }
    }
    function(space, coefficients)
}

/// The Hessian at the flat metric.
pub struct M13;

/// −Σ_S ∫ Σ_F ⟦ρ(n,τ)⟧ Tr(σ|_S) ω_S / 2, τ into F: Σ Θ̇ Tr(σ|_S) ω_S of the corrected lemma.
fn bilinear<K: Formulas, const N: usize>(
    mesh: &Mesh<N>,
    g: &Regge<'_, f64, N>,
    rho: &Regge<'_, f64, N>,
    sigma: &Regge<'_, f64, N>,
) -> f64 {
    use super::density::{HingeTerms, Seen};
    let hats = Lagrange::new(mesh, 1);
    let rule = Rules::new::<N>(2).hinge;
    let (seen, on_rho, on_sigma) = (
        Seen::<f64, N, _>::new(g, N - 2, &rule),
        Seen::<f64, N, _>::new(rho, N - 2, &rule),
        Seen::<f64, N, _>::new(sigma, N - 2, &rule),
    );
    let terms = |metric: &Mat<f64, N>, field: Mat<f64, N>, place| {
        HingeTerms::new::<K, N>(metric, &field, place)
    };
    let sum = integrate(&hats, N - 2, &rule, mesh.interior_hinges(), |_, side, p| {
        let value = seen.value(side, p);
        let turn = terms(&value, on_rho.value(side, p), side.place).normal_conormal;
        -0.5 * turn * terms(&value, on_sigma.value(side, p), side.place).trace
    });
    sum.iter().sum()
}

/// On the flat 3-torus: d²/dt² of ⟨(Rω)_dist(δ+tσ), 1⟩ by hyper-dual numbers for one random σ, and
/// ½Σ_S∫Σ_F⟦σ(n,τ)⟧Tr(σ|_S)ω_S with τ pointing into F, as it is printed.
pub fn second_variation(draw: &mut Draw) -> (f64, f64) {
    let mesh = Shape::Torus(3).mesh::<3>();
    let regge = ReggeSpace::new(&mesh, 0);
    let (g, sigma) = (euclidean(&regge), variation(&regge, draw));
    (
        hessian::<Paper, 3>(&mesh, &g, &sigma, &sigma),
        -bilinear::<Paper, 3>(&mesh, &g, &sigma, &sigma),
    )
}

/// ∂²/∂s∂t ⟨(Rω)_dist(g+sρ+tσ), 1⟩.
fn hessian<K: Formulas, const N: usize>(
    mesh: &Mesh<N>,
    g: &Regge<'_, f64, N>,
    rho: &Regge<'_, f64, N>,
    sigma: &Regge<'_, f64, N>,
) -> f64 {
    let (hats, rules) = (Lagrange::new(mesh, 1), Rules::new::<N>(2));
    let three = g
        .coefficients()
        .iter()
        .zip(rho.coefficients())
        .zip(sigma.coefficients());
    let moved = three
        .map(|((g, r), s)| HyperDual64::new(*g, *r, *s, 0.0))
        .collect();
    let moved = function(g.space(), moved);
    let sums = distributional_curvature_with::<K, HyperDual64, N, _>(&moved, &hats, &rules);
    sums.hinge.iter().map(|x| x.eps1eps2).sum()
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
        sides: "Left: the functionals over dual and hyper-dual numbers. Right: normals and conormals of the flat metric. With \
            the printed sign of τ the second variation comes out negated.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        if dimension == 3 {
            grid(&[Shape::Torus(3)], &[2], if quick { 1 } else { 64 })
        } else {
            Vec::new()
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, 0);
        let g = euclidean(&regge);
        let (rho, sigma) = (variation(&regge, draw), variation(&regge, draw));
        let (hats, rules) = (Lagrange::new(&mesh, 1), Rules::new::<N>(2));
        let gradient = |along: &Regge<'_, f64, N>, against: &Regge<'_, f64, N>| -> f64 {
            let against = super::fields::lifted::<Dual64, N>(against);
            let moved = moving(&g, along);
            let a = a_h_with::<K, Dual64, N, _, _>(&moved, &against, &hats, &rules);
            a.hinge.iter().map(|x| x.eps).sum()
        };
        let hessian = hessian::<K, N>(&mesh, &g, &rho, &sigma);
        let formula = bilinear::<K, N>(&mesh, &g, &rho, &sigma);
        vec![
            Equation::new("d/dt⟨Gω(δ+tρ),σ⟩")
                .left("d/dt⟨Gω(δ+tρ),σ⟩", gradient(&rho, &sigma))
                .right("½ΣΣ⟦ρ(n,τ)⟧Tr(σ|_S)", -formula)
                .forge("the printed sign of τ", "½ΣΣ⟦ρ(n,τ)⟧Tr(σ|_S)", formula),
            Equation::new("symmetry")
                .left("d/dt⟨Gω(δ+tρ),σ⟩", gradient(&rho, &sigma))
                .right("d/dt⟨Gω(δ+tσ),ρ⟩", gradient(&sigma, &rho)),
            Equation::new("second variation")
                .left("∂²⟨Rω(δ+sρ+tσ),1⟩", hessian)
                .right("−½ΣΣ⟦ρ(n,τ)⟧Tr(σ|_S)", formula)
                .forge("the printed sign of τ", "−½ΣΣ⟦ρ(n,τ)⟧Tr(σ|_S)", -formula)
                .forge(
                    "Regge's action for ⟨Rω,1⟩",
                    "∂²⟨Rω(δ+sρ+tσ),1⟩",
                    0.5 * hessian,
                ),
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
        let mut expected = vec![0.0; hats.len()];
        let flat = super::euclid::hinges::<f64, N>(&g);
        for h in &flat {
            // A hat function's mean over a hinge with N−1 vertices.
            let share = 2.0 * h.defect * h.volume / (N - 1) as f64;
            for &v in mesh.vertices(N - 2, h.hinge) {
                expected[v as usize] += share;
            }
        }
        let size: f64 = flat.iter().map(|h| h.volume).sum();
        vec![
            Equation::new("⟨Rω,v⟩")
                .left("2Σ_S ∫Θvω_S", sums.hinge.clone())
                .right("2Σ Θ ∫v", expected.clone())
                // Θ is a difference of angles of size 2π.
                .magnitude(std::f64::consts::TAU * size)
                .forge(
                    "the factor 2 dropped",
                    "2Σ_S ∫Θvω_S",
                    times(0.5, &sums.hinge),
                ),
        ]
    }
}

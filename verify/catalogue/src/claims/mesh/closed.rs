//! M08, M09, M15: meshes without boundary, tested against v = 1.

use super::fields::{Tested, Three, metric, minus, moving, rates, values, variation};
use super::setting::{Draw, OnMesh, QUADRATURE, ROUNDING, Setting, Shape, grid};
use super::variation::{FLAT, POINTS, orders};
use crate::claim::{Equation, Judgement, Record};
use num_dual::Dual64;
use regge::formulas::Formulas;
use regge::functional::{Rules, a_h_with, b_h_with, distributional_curvature_with};
use regge::lagrange::Lagrange;
use regge::regge::ReggeSpace;

/// Tori of degree 0 and spheres of all degrees.
fn closed(dimension: usize, quick: bool) -> Vec<Setting> {
    let (orders, times) = (orders(dimension), if quick { 1 } else { 7 });
    match dimension {
        2 => grid(&[Shape::Torus(3), Shape::Sphere], &orders, times),
        3 => {
            let mut all = grid(&[Shape::Torus(3)], &orders[..1], 2);
            all.extend(grid(&[Shape::Sphere], &orders, times));
            all
        }
        4 if quick => grid(&[Shape::Sphere], &orders[..2], 1),
        4 => {
            let mut all = grid(&[Shape::Torus(3)], &orders[..1], 1);
            all.extend(grid(&[Shape::Sphere], &orders, 2));
            all
        }
        _ => Vec::new(),
    }
}

/// Rates of ⟨(Rω)_dist, 1⟩, b_h(·, 1), a_h(·, 1), and b_h's terms cell by cell for the size of what cancels.
struct AgainstOne {
    rate: Three,
    b: Three,
    a: Three,
    size: f64,
}

impl AgainstOne {
    fn new<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Self {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let (g, sigma) = (metric(&regge, draw), variation(&regge, draw));
        let space = Lagrange::new(&mesh, at.test);
        let rules = Rules::new::<N>(at.order);
        let moved = moving(&g, &sigma);
        let rate = distributional_curvature_with::<K, Dual64, N, _>(&moved, &space, &rules);
        let b = values(b_h_with::<K, f64, N, _, _>(&g, &sigma, &space, &rules));
        let a = values(a_h_with::<K, f64, N, _, _>(&g, &sigma, &space, &rules));
        let size = b.t.iter().chain(&b.f).fold(0.0, |m: f64, x| m.max(x.abs()));
        let one = |s: &Three| Tested::One.of_sums(&space, s);
        Self {
            rate: one(&rates(&rate)),
            b: one(&b),
            a: one(&a),
            size,
        }
    }
}

/// b_h(·, 1) = 0, and the variation of ⟨(Rω)_dist, 1⟩.
pub struct M08;

impl OnMesh for M08 {
    const RECORD: Record = Record {
        label: "M08",
        paper: &["def:distein", "sec:einstein"],
        title: "The Einstein–Hilbert functional of a Regge metric and its gradient",
        statement: r"\partial\Omega=\emptyset:\quad b_h(g;\sigma,1)=0,\qquad \frac{d}{dt}\langle (R\omega)_{\rm dist}(g+t\sigma),
            1\rangle = -\langle (G\omega)_{\rm dist}(g),\sigma\rangle",
        sides: "Left: the functional over dual numbers. Right: the distributional Einstein tensor at t = 0.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        closed(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let x = AgainstOne::new::<K, N>(at, draw);
        let (flat, surface) = (at.degree == 0, N == 2);
        let gradient = Equation::new("gradient")
            .left("d/dt Σ_T ∫Rω", x.rate.t)
            .vanishes(flat, FLAT)
            .left("d/dt 2Σ_F ∫⟦H⟧ω_F", x.rate.f)
            .vanishes(flat, FLAT)
            .left("d/dt 2Σ_S ∫Θω_S", x.rate.s)
            .vanishes(
                surface && flat,
                "Σ Θ is 2πχ when N = 2 and g is constant on cells",
            )
            .right("−Σ_T ∫⟨G,σ⟩ω", minus(&x.a.t))
            .vanishes(
                flat || surface,
                "G = 0 when N = 2, or g is constant on cells",
            )
            .right("−Σ_F ∫⟨⟦II‾⟧,σ⟩ω_F", minus(&x.a.f))
            .vanishes(
                flat || surface,
                "II‾ = 0 when N = 2, or g is constant on cells",
            )
            .right("Σ_S ∫Θ Tr(σ|_S)ω_S", minus(&x.a.s))
            .vanishes(surface, POINTS)
            .magnitude(x.size);
        let b = Equation::new("b_h(·,1)")
            .left("Σ_T ∫⟨𝕊σ,∇∇1⟩ω", x.b.t)
            .vanishes(true, "∇∇1 = 0")
            .left("−Σ_F ∫𝕊σ(n,n)⟦∇_n 1⟧ω_F", x.b.f)
            .vanishes(true, "∇_n 1 = 0")
            .magnitude(x.size);
        vec![b, gradient]
    }
}

/// Regge's identity.
pub struct M09;

impl OnMesh for M09 {
    const RECORD: Record = Record {
        label: "M09",
        paper: &["sec:einstein"],
        title: "Regge's identity: Σ Θ̇_S V_S = 0 on a closed mesh",
        statement: r"2\mathring{\sum_S}\dot\Theta_S V_S = b_h(g;\sigma,1) = 0,\qquad 2\mathring{\sum_S}\Theta_S\dot V_S =
            -a_h(g;\sigma,1)\quad\text{for piecewise constant } g,\sigma,\ \partial\Omega=\emptyset",
        sides: "Left: edge lengths to Cholesky factors, angles by projection, volumes by Gram determinants, all over dual \
            numbers: nothing of the library. Right: the production a_h. On a mesh with boundary the first sum is not 0.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 2 } else { 16 };
        match dimension {
            2 | 3 => grid(&[Shape::Sphere, Shape::Torus(3)], &[2], times),
            4 => grid(&[Shape::Sphere], &[2], times),
            _ => Vec::new(),
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, 0);
        let (g, sigma) = (metric(&regge, draw), variation(&regge, draw));
        let hats = Lagrange::new(&mesh, 1);
        let rules = Rules::new::<N>(2);
        let a = Tested::One.of_sums(
            &hats,
            &values(a_h_with::<K, f64, N, _, _>(&g, &sigma, &hats, &rules)),
        );
        let hinges = super::euclid::hinges::<Dual64, N>(&moving(&g, &sigma));
        let angles: f64 = hinges
            .iter()
            .map(|h| 2.0 * h.defect.eps * h.volume.re)
            .sum();
        let size: f64 = hinges
            .iter()
            .map(|h| (h.defect.eps * h.volume.re).abs())
            .sum();
        let volumes: f64 = hinges
            .iter()
            .map(|h| 2.0 * h.defect.re * h.volume.eps)
            .sum();
        // What the same sum is on an open mesh.
        let open = Shape::Alfeld.mesh::<N>();
        let space = ReggeSpace::new(&open, 0);
        let moved = moving(&metric(&space, draw), &variation(&space, draw));
        let of_open = super::euclid::hinges::<Dual64, N>(&moved);
        let with_boundary: f64 = of_open
            .iter()
            .map(|h| 2.0 * h.defect.eps * h.volume.re)
            .sum();
        vec![
            Equation::new("angles")
                .left("2Σ Θ̇_S V_S", angles)
                .vanishes(true, "Regge's identity: it is the claim")
                .magnitude(size)
                .forge("a mesh with boundary", "2Σ Θ̇_S V_S", with_boundary),
            Equation::new("volumes")
                .left("2Σ Θ_S V̇_S", volumes)
                .vanishes(N == 2, POINTS)
                .right("−a_h(σ,1)", minus(&a.s))
                .vanishes(N == 2, POINTS)
                .magnitude(size),
        ]
    }
}

/// Gauss and Bonnet.
pub struct M15;

impl OnMesh for M15 {
    const RECORD: Record = Record {
        label: "M15",
        paper: &[],
        title: "Gauss–Bonnet for Regge metrics on closed surfaces",
        statement: r"N=2,\ \partial\Omega=\emptyset:\qquad \langle (R\omega)_{\rm dist}(g),1\rangle = 4\pi\chi(\Omega)",
        sides: "Left: the functional. Right: vertices − edges + triangles.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        if dimension == 2 {
            grid(
                &[Shape::Torus(3), Shape::Sphere],
                &orders(2),
                if quick { 2 } else { 12 },
            )
        } else {
            Vec::new()
        }
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let regge = ReggeSpace::new(&mesh, at.degree);
        let hats = Lagrange::new(&mesh, 1);
        let rules = Rules::new::<N>(at.order);
        let sums = values(distributional_curvature_with::<K, f64, N, _>(
            &metric(&regge, draw),
            &hats,
            &rules,
        ));
        let one = Tested::One.of_sums(&hats, &sums);
        let (flat, torus) = (at.degree == 0, at.shape != Shape::Sphere);
        let size = sums
            .t
            .iter()
            .chain(&sums.f)
            .chain(&sums.s)
            .fold(0.0, |m: f64, x| m.max(x.abs()));
        let total = 4.0 * std::f64::consts::PI * mesh.euler_characteristic() as f64;
        vec![
            Equation::new("4πχ")
                .left("Σ_T ∫Rω", one.t)
                .vanishes(flat, FLAT)
                .left("2Σ_F ∫⟦H⟧ω_F", one.f)
                .vanishes(flat, FLAT)
                .left("2Σ_S Θ_S", one.s)
                .vanishes(
                    flat && torus,
                    "it is 4πχ = 0 on a torus with constant g on cells",
                )
                .right("4πχ", total)
                .vanishes(torus, "χ = 0 on a torus")
                .magnitude(size),
        ]
    }
}

//! M08, M09, M15: meshes without boundary, tested against v = 1.

use crate::harness::{Draw, Equation, Judgement, Record, Setting, Shape, grid};
use crate::stage::fields::{Regge, moving};
use crate::stage::mesh::{
    Evolution, FLAT, Moving, NO_G, NO_II, OnMesh, POINTS, Pair, QUADRATURE, ROUNDING, Tested,
    Three, minus, orders,
};
use crate::stage::reference::{FlatHinge, hinges};
use num_dual::Dual64;
use regge_curvature::functional::Sums;
use regge_curvature::scalar::Number;
use regge_curvature::spaces::Lagrange;

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
        _ if quick => grid(&[Shape::Sphere], &orders[..2], 1),
        _ => {
            let mut all = grid(&[Shape::Torus(3)], &orders[..1], 1);
            all.extend(grid(&[Shape::Sphere], &orders, 2));
            all
        }
    }
}

/// b_h(·, 1) = 0, and the variation of ⟨(Rω)_dist, 1⟩.
pub struct M08;

impl Evolution for M08 {
    const RECORD: Record = Record {
        label: "M08",
        paper: &["def:distein", "sec:einstein"],
        title: "The Einstein–Hilbert functional of a Regge metric and its gradient",
        statement: r"\partial\Omega=\emptyset:\quad b_h(g;\sigma,1)=0,\qquad \frac{d}{dt}\langle (R\omega)_{\rm dist}(g+t\sigma),
            1\rangle = -\langle (G\omega)_{\rm dist}(g),\sigma\rangle",
        sides: "Left: the functional of g + tσ. Right: the distributional Einstein tensor, with G, II‾ and Θ without a \
            derivative in t. No integral of one side is one of the other. Both use R, H and Θ, the left their change and the right their values, which D11 pins down.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        closed(dimension, quick)
    }

    fn equations<const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let one = |s: &Three| Tested::One.of_sums(&m.at.space, s);
        let b = m.at.b();
        let sizes = b.largest();
        let gradient = gradient(one(&m.rate), &one(&m.at.a()), (at.degree == 0, N == 2));
        let b = one(&b);
        let against_one = Equation::new("b_h(·,1)")
            .left("Σ_T ∫⟨𝕊σ,∇∇1⟩ω", b.t)
            .vanishes(true, "∇∇1 = 0")
            .left("−Σ_F ∫𝕊σ(n,n)⟦∇_n 1⟧ω_F", b.f)
            .vanishes(true, "∇_n 1 = 0")
            .magnitude(sizes);
        vec![against_one, gradient.magnitude(sizes)]
    }
}

fn gradient(rate: Three, a: &Three, (flat, surface): (bool, bool)) -> Equation<f64> {
    Equation::new("gradient")
        .left("d/dt Σ_T ∫Rω", rate.t)
        .vanishes(flat, FLAT)
        .left("d/dt 2Σ_F ∫⟦H⟧ω_F", rate.f)
        .vanishes(flat, FLAT)
        .left("d/dt 2Σ_S ∫Θω_S", rate.s)
        .vanishes(
            surface && flat,
            "Σ Θ is 2πχ when N = 2 and g is constant on cells",
        )
        .right("−Σ_T ∫⟨G,σ⟩ω", minus(&a.t))
        .vanishes(flat || surface, NO_G)
        .right("−Σ_F ∫⟨⟦II‾⟧,σ⟩ω_F", minus(&a.f))
        .vanishes(flat || surface, NO_II)
        .right("Σ_S ∫Θ Tr(σ|_S)ω_S", minus(&a.s))
        .vanishes(surface, POINTS)
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
            _ => grid(&[Shape::Sphere], &[2], times),
        }
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let pair = Pair::<N>::draw(at, draw);
        let a = Tested::One.of_sums(&pair.space, &pair.a());
        let moved = hinges::<Dual64, N>(&moving(&pair.g, &pair.sigma));
        let sum = |f: fn(&FlatHinge<Dual64>) -> f64| moved.iter().map(f).sum::<f64>();
        let size = sum(|h| (h.defect.eps * h.volume.re).abs());
        let angles = sum(|h| 2.0 * h.defect.eps * h.volume.re);
        let volumes = sum(|h| 2.0 * h.defect.re * h.volume.eps);
        // What the same sum is on an open mesh.
        let open = Setting::new(Shape::Alfeld, 0, 2);
        let pair = Pair::<N>::draw(&open, draw);
        let of_open = hinges::<Dual64, N>(&moving(&pair.g, &pair.sigma));
        let turning = of_open.iter().map(|h| 2.0 * h.defect.eps * h.volume.re);
        let with_boundary: f64 = turning.sum();
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

/// Regge's identity along a path: the increase of his action is the integral of 2Σ Θ dV alone.
pub struct Action;

impl Evolution for Action {
    const RECORD: Record = M09::RECORD;
    const JUDGEMENT: Judgement = ROUNDING;
    const DIMENSIONS: &'static [usize] = &[3, 4];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        M09::settings(dimension, quick)
    }

    fn paths(dimension: usize, quick: bool) -> Vec<Setting> {
        Self::settings(dimension, quick)
    }

    /// 2ΣΘ_S V_S by Cholesky's factors, in the place of one test function.
    fn functional<T: Number, const N: usize>(
        _: &Setting,
        g: &Regge<T, N>,
        space: &Lagrange<N>,
    ) -> Sums<T> {
        let none = vec![T::zero(); space.len()];
        let mut hinge = none.clone();
        for h in hinges::<T, N>(g) {
            hinge[0] += h.defect * h.volume * T::from_f64(2.0);
        }
        Sums {
            cells: none.clone(),
            faces: none,
            hinges: hinge,
        }
    }

    fn equations<const N: usize>(_: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let one = |s: &Three| Tested::One.of_sums(&m.at.space, s).s;
        let all = hinges::<f64, N>(&m.at.g);
        let size: f64 = all.iter().map(|h| (h.defect * h.volume).abs()).sum();
        vec![
            Equation::new("action")
                .left("d/dt 2ΣΘ_SV_S", one(&m.rate))
                .right("−a_h(σ,1)", minus(&one(&m.at.a())))
                .magnitude(size),
        ]
    }
}

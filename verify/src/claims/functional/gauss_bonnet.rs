//! M15: Gauss and Bonnet.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape, grid};
use crate::stage::fields::metric;
use crate::stage::mesh::{
    Evolution, FLAT, Moving, OnMesh, QUADRATURE, Tested, Three, orders, spaces, values,
};
use regge_curvature::functional::{boundary_curvature, distributional_curvature};

/// Gauss and Bonnet.
pub struct M15;

const GAUSS_BONNET: Record = Record {
    label: "M15",
    paper: &[],
    title: "Gauss–Bonnet for Regge metrics on surfaces",
    statement: r"N=2:\qquad \langle (R\omega)_{\rm dist}(g),1\rangle + 2\sum_{F\subset\partial\Omega}\int_F H\omega_F
        + 2\sum_{S\subset\partial\Omega}\Bigl(\pi-\sum_T\theta_{ST}\Bigr) = 4\pi\chi(\Omega)",
    sides: "Left: the functional, and the production boundary terms where there is a boundary. Right: vertices − edges + \
        triangles, by the theorem of Gauss and Bonnet. By AD and along paths on closed surfaces: the sum does not change, \
        although each of its parts does.",
};

fn surfaces(times: usize) -> Vec<Setting> {
    grid(&[Shape::Torus(3), Shape::Sphere], &orders(2), times)
}

/// The three sums against v = 1; is that over hinges alone zero?
fn three(sums: Three, size: f64, flat: bool, no_hinges: bool) -> Equation<f64> {
    Equation::new("4πχ")
        .left("Σ_T ∫Rω", sums.t)
        .vanishes(flat, FLAT)
        .left("2Σ_F ∫⟦H⟧ω_F", sums.f)
        .vanishes(flat, FLAT)
        .left("2Σ_S Θ_S", sums.s)
        .vanishes(
            no_hinges,
            "it alone is 4πχ when g is constant on cells: 0 on a torus, and unchanging",
        )
        .magnitude(size)
}

impl OnMesh for M15 {
    const RECORD: Record = GAUSS_BONNET;
    const METHOD: Method = Method::Oracle;
    const JUDGEMENT: Judgement = QUADRATURE;
    const DIMENSIONS: &'static [usize] = &[2];

    fn settings(_: usize, quick: bool) -> Vec<Setting> {
        let (mut all, times) = (
            surfaces(if quick { 2 } else { 12 }),
            if quick { 1 } else { 4 },
        );
        all.extend(grid(&[Shape::Alfeld, Shape::Cube(2)], &orders(2), times));
        all
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let torus = matches!(at.shape, Shape::Torus(_));
        let (regge, space) = spaces::<N>(at);
        let rules = at.rules(N);
        let g = metric(&regge, draw);
        let inside = values(distributional_curvature(&g, &space, &rules));
        let edge = values(boundary_curvature(&g, &space, &rules));
        let chi = space.mesh().euler_characteristic() as f64;
        let [one, boundary] = [&inside, &edge].map(|s| Tested::One.of_sums(&space, s));
        let size = inside.largest() + edge.largest();
        let (flat, closed) = (at.degree == 0, at.shape.is_closed());
        vec![
            three(one, size, flat, flat && torus)
                .left("2Σ_{F⊂∂Ω} ∫Hω_F", boundary.f)
                .vanishes(
                    flat || closed,
                    "there is no boundary, or g is constant on cells",
                )
                .left("2Σ_{S⊂∂Ω} (π − Σθ)", boundary.s)
                .vanishes(closed, "there is no boundary")
                .right("4πχ", 4.0 * std::f64::consts::PI * chi)
                .vanishes(torus, "χ = 0 on a torus"),
        ]
    }
}

/// Its rate of change.
pub struct Unchanged;

impl Evolution for Unchanged {
    const RECORD: Record = GAUSS_BONNET;
    const JUDGEMENT: Judgement = QUADRATURE;
    const DIMENSIONS: &'static [usize] = &[2];

    fn settings(_: usize, quick: bool) -> Vec<Setting> {
        surfaces(if quick { 1 } else { 4 })
    }

    fn equations<const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let one = Tested::One.of_sums(&m.at.space, &m.rate);
        vec![three(one, m.rate.largest(), at.degree == 0, at.degree == 0)]
    }
}

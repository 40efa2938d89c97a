//! M15: Gauss and Bonnet.

use crate::harness::{Draw, Equation, Judgement, Method, Record, Setting, Shape, grid};
use crate::stage::fields::metric;
use crate::stage::mesh::{
    Evolution, FLAT, Moving, OnMesh, QUADRATURE, Tested, Three, orders, spaces, values,
};
use regge_curvature::functional::{Rules, distributional_curvature};

/// Gauss and Bonnet.
pub struct M15;

const GAUSS_BONNET: Record = Record {
    label: "M15",
    paper: &[],
    title: "Gauss–Bonnet for Regge metrics on closed surfaces",
    statement: r"N=2,\ \partial\Omega=\emptyset:\qquad \langle (R\omega)_{\rm dist}(g),1\rangle = 4\pi\chi(\Omega)",
    sides: "Left: the functional. Right: vertices − edges + triangles, by the theorem of Gauss and Bonnet. By AD and along \
        paths: the sum does not change, although each of its parts does.",
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
        surfaces(if quick { 2 } else { 12 })
    }

    fn equations<const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let torus = at.shape != Shape::Sphere;
        let (regge, space) = spaces::<N>(at);
        let rules = at.rules(N);
        let g = metric(&regge, draw);
        let sums = values(distributional_curvature(&g, &space, &rules));
        let chi = space.mesh().euler_characteristic() as f64;
        let one = Tested::One.of_sums(&space, &sums);
        vec![
            three(one, sums.largest(), at.degree == 0, at.degree == 0 && torus)
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

//! M17: the first variation on one simplex, where nothing is continuous and v is free. P04: the same for v with compact
//! support, which is a statement about smooth metrics.

use crate::harness::{Equation, Judgement, Record, Setting, Shape, grid};
use crate::stage::fields::{Regge, Seen, integral};
use crate::stage::mesh::Where::Everywhere;
use crate::stage::mesh::{
    Evolution, FLAT, HingeTerms, Moving, NO_G, NO_II, POINTS, QUADRATURE, minus, on_one_simplex,
    orders, outward_of_face,
};
use crate::stage::point::Face;
use regge_curvature::formulas::Formulas;
use regge_curvature::functional::{Sums, smooth_curvature};
use regge_curvature::jet::Jet1;
use regge_curvature::riemann::Connection;
use regge_curvature::scalar::Number;
use regge_curvature::simplex::multi_indices;
use regge_curvature::spaces::Lagrange;

/// The variation on one simplex.
pub struct M17;

/// 2Σ_F ∫Hvω_F over all faces of all cells.
fn on_faces<T: Number, const N: usize>(
    at: &Setting,
    g: &Regge<T, N>,
    space: &Lagrange<N>,
) -> Vec<T> {
    let rules = at.rules(N);
    let g = Seen::<T, N, _>::new(g, N - 1, &rules.faces);
    let mut faces = 0..space.mesh().count(N - 1);
    integral(space, N - 1, &rules.faces, &mut faces, &|_, side, p| {
        let connection = Connection::new(&g.jet1(side, p));
        let nu = outward_of_face::<T, N>(side.place).map(Jet1::constant);
        Face::new(&at.formulas, &connection, &nu).density * T::from_f64(2.0)
    })
}

/// −2Σ_S ∫θvω_S over all hinges of all cells.
fn on_hinges<T: Number, const N: usize>(
    at: &Setting,
    g: &Regge<T, N>,
    space: &Lagrange<N>,
) -> Vec<T> {
    let rules = at.rules(N);
    let g = Seen::<T, N, _>::new(g, N - 2, &rules.hinges);
    let mut hinges = 0..space.mesh().count(N - 2);
    integral(space, N - 2, &rules.hinges, &mut hinges, &|_, side, p| {
        let value = g.value(side, p);
        let hinge = HingeTerms::new::<N>(&at.formulas, &value, &value, side.place);
        hinge.theta * hinge.omega * T::from_f64(-2.0)
    })
}

impl Evolution for M17 {
    const RECORD: Record = Record {
        label: "M17",
        paper: &[],
        title: "The first variation on one simplex: any g, any σ, any v",
        statement: r"\frac{d}{dt}\Bigl[\int_T Rv\omega + 2\sum_F\int_F Hv\omega_F - 2\sum_S\int_S\theta v\omega_S\Bigr]
            = \int_T\langle\mathbb{S}\sigma,\nabla\nabla v\rangle\omega - \sum_F\int_F\mathbb{S}\sigma(n,n)\nabla_n v\,\omega_F
            - \Bigl[\int_T\langle G,\sigma\rangle v\omega + \sum_F\int_F\langle\overline{I\!I},\sigma|_F\rangle v\omega_F +
            \sum_S\int_S\theta\operatorname{Tr}(\sigma|_S)v\omega_S\Bigr]",
        sides: "Left: R, H and dihedral angles of g + tσ. Right: b_h, and G, II‾ and θ without a derivative in t; the integrals \
            have nothing in common. There is one cell, so that no continuity is used: the theorem holds cell by cell. Both use R, H and θ, the left their change and the right their values, which D09 and D11 pin down.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        on_one_simplex(dimension, quick)
    }

    /// Production's own for R; its sums over interior faces and hinges are empty.
    fn functional<T: Number, const N: usize>(
        at: &Setting,
        g: &Regge<T, N>,
        space: &Lagrange<N>,
    ) -> Sums<T> {
        Sums {
            cells: smooth_curvature(g, space, &at.rules(N)),
            faces: on_faces(at, g, space),
            hinges: on_hinges(at, g, space),
        }
    }

    fn equations<const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let (b, a) = (m.at.b(), m.at.a());
        let (flat, surface) = (at.degree == 0, N == 2);
        let form = minus(&m.at.faces(Everywhere, |q| q.second_form));
        let plain = minus(&m.at.faces(Everywhere, |q| q.plain_second_form));
        let angles = m.at.hinges(Everywhere, |q| -q.theta * q.trace * q.omega);
        vec![
            Equation::new("one simplex")
                .left("d/dt ∫Rvω", m.rate.t.clone())
                .vanishes(flat, FLAT)
                .left("d/dt 2Σ_F ∫Hvω_F", m.rate.f.clone())
                .vanishes(flat, FLAT)
                .left("d/dt −2Σ_S ∫θvω_S", m.rate.s.clone())
                .right("∫⟨𝕊σ,∇∇v⟩ω", b.t)
                .right("−Σ_F ∫𝕊σ(n,n)∇_n v ω_F", b.f)
                .right("−∫⟨G,σ⟩vω", minus(&a.t))
                .vanishes(flat || surface, NO_G)
                .right("−Σ_F ∫⟨II‾,σ⟩vω_F", form)
                .vanishes(flat || surface, NO_II)
                .right("−Σ_S ∫θ Tr(σ|_S)vω_S", angles)
                .vanishes(surface, POINTS)
                .forge("II for II‾", "−Σ_F ∫⟨II‾,σ⟩vω_F", plain)
                .vacuous(flat, FLAT),
        ]
    }
}

/// The integrated first variation of a smooth metric.
pub struct P04;

/// The entries of the functions on one simplex that vanish on the boundary with their gradients: B_α with all α_i ≥ 2.
fn compact<const N: usize>(space: &Lagrange<N>, all: &[f64]) -> Vec<f64> {
    let indices = multi_indices(N + 1, space.degree());
    let dofs = space.cell_dofs(0).zip(indices);
    dofs.filter(|(_, alpha)| alpha.iter().all(|&e| e >= 2))
        .map(|(dof, _)| all[dof])
        .collect()
}

impl Evolution for P04 {
    const RECORD: Record = Record {
        label: "P04",
        paper: &["curvdotintro", "intcurvdot"],
        title: "The first variation of the curvature of a smooth metric, integrated",
        statement: r"\frac{d}{dt}\int_\Omega Rv\omega = \int_\Omega(\operatorname{div}\operatorname{div}\mathbb{S}\sigma)v\omega
            - \int_\Omega\langle G,\sigma\rangle v\omega\quad\forall v;\qquad\int_\Omega(\operatorname{div}\operatorname{div}
            \mathbb{S}\sigma)v\omega = \int_\Omega\langle\mathbb{S}\sigma,\nabla\nabla v\rangle\omega
            \ \text{ if } v=0,\ \nabla v=0\text{ on }\partial\Omega",
        sides: "Left: R ω of g + tσ. Right: second derivatives of σ, or of v instead; G. g and σ are polynomials on a \
            simplex, v = (∏λ_i)²w has compact support in it. Both use R, the left its change and the right its value, which O03 pins down.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;
    const DIMENSIONS: &'static [usize] = &[2, 3];

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        let times = if quick { 2 } else { 16 };
        // (∏λ_i)² w with w of degree 1. For r = 0 everything vanishes.
        let test = 2 * (dimension + 1) + 1;
        let all = grid(&[Shape::Single], &orders(dimension), times).into_iter();
        all.filter(|at| at.degree > 0)
            .map(|at| Setting {
                order: at.order + test - at.test,
                test,
                ..at
            })
            .collect()
    }

    fn functional<T: Number, const N: usize>(
        at: &Setting,
        g: &Regge<T, N>,
        space: &Lagrange<N>,
    ) -> Sums<T> {
        let element = smooth_curvature(g, space, &at.rules(N));
        let none = vec![T::zero(); element.len()];
        Sums {
            cells: element,
            faces: none.clone(),
            hinges: none,
        }
    }

    fn equations<const N: usize>(_: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let (rate, g) = (&m.rate.t, minus(&m.at.a().t));
        let inner = |v: &[f64]| compact(&m.at.space, v);
        let variation = |name, rate, div_div, g| {
            Equation::new(name)
                .left("d/dt ∫Rvω", rate)
                .right(DIV_DIV, div_div)
                .right("−∫⟨G,σ⟩vω", g)
                .vanishes(N == 2, NO_G)
        };
        let half = Formulas {
            reverse_trace_halves: 1,
            ..m.at.formulas
        };
        let (weakly, wrong) = (m.at.b().t, m.at.b_by(half).t);
        let weak = variation("compact support", inner(rate), inner(&weakly), inner(&g));
        vec![
            variation("any v", rate.clone(), m.at.div_div(), g),
            // The second derivatives of v cancel: of a size as with functions without compact support.
            weak.magnitude(weakly)
                .forge("𝕊 with ½", DIV_DIV, inner(&wrong)),
        ]
    }
}

const DIV_DIV: &str = "∫(div div 𝕊σ)vω";

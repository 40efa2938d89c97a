//! M05: the first variation of the distributional scalar curvature.

use crate::harness::{Equation, Judgement, Record, Setting};
use crate::stage::mesh::{
    Evolution, FLAT, Moving, NO_G, NO_II, POINTS, QUADRATURE, Tested, Three, everywhere, minus,
    times,
};
use regge_curvature::formulas::Formulas;
use regge_curvature::spaces::Lagrange;

/// What both sides of thm:distcurvdot are made of, for some test functions.
struct Sides {
    /// d/dt of the three sums of ⟨(Rω)_dist(g + tσ), v⟩.
    rate: Three,
    /// b_h(g; σ, v).
    b: Three,
    /// a_h(g; σ, v).
    a: Three,
}

/// d/dt⟨(Rω)_dist, v⟩ = b_h − a_h.
pub struct M05;

impl Evolution for M05 {
    const RECORD: Record = Record {
        label: "M05",
        paper: &["thm:distcurvdot", "distcurvdot", "distcurvdotintro"],
        title: "The first variation of the distributional scalar curvature",
        statement: r"\frac{d}{dt}\langle (R\omega)_{\rm dist}(g(t)), v\rangle = b_h(g;\sigma,v) - a_h(g;\sigma,v)
            \qquad \forall v \in V",
        sides: "Left: the functional of def:distcurv (R from the lowered R_ijkl, H, dihedral angles) of g + tσ. Right: b_h has second \
            derivatives of v and none of σ, a_h has G, II‾ and Θ without a derivative in t. They agree in the limit of exact \
            quadrature, and no integral of one side is one of the other. Both use R, H and Θ, the left their change and the right their values, which D11 pins down.",
    };
    const JUDGEMENT: Judgement = QUADRATURE;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        everywhere(dimension, quick)
    }

    fn equations<const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let (rate, b, a) = (m.rate.clone(), m.at.b(), m.at.a());
        let wrong = Wrong::of(m);
        vec![wrong.forge(&Sides { rate, b, a }, &m.at.space, at)]
    }
}

/// Terms by wrong formulas.
struct Wrong {
    b_f: Vec<f64>,
    b_t: Vec<f64>,
    a_f: Vec<f64>,
}

impl Wrong {
    fn of<const N: usize>(m: &Moving<N>) -> Self {
        let right = m.at.formulas;
        let interior = Formulas {
            b_on_boundary: false,
            ..right
        };
        let half = Formulas {
            reverse_trace_halves: 1,
            ..right
        };
        let plain = Formulas {
            trace_reversed: 0,
            ..right
        };
        Self {
            b_f: m.at.b_by(interior).f,
            b_t: m.at.b_by(half).t,
            a_f: m.at.a_by(plain).f,
        }
    }

    fn forge<const N: usize>(
        &self,
        all: &Sides,
        space: &Lagrange<N>,
        at: &Setting,
    ) -> Equation<f64> {
        let inner = |v: &[f64]| Tested::Inner.of(space, v);
        let half = |v: &[f64]| times(0.5, &inner(v));
        let (flat, closed) = (at.degree == 0, at.shape.is_closed());
        all.on(Tested::Inner, space)
            .equation(N, at.degree)
            .forge("b_h over interior faces only", B_F, inner(&self.b_f))
            .vacuous(closed, "there is no boundary")
            .forge("II for II‾", A_F, minus(&inner(&self.a_f)))
            .vacuous(flat, FLAT)
            .forge("𝕊 with ½", B_T, inner(&self.b_t))
            .forge("factor 1 of the face sum", R_F, half(&all.rate.f))
            .vacuous(flat, FLAT)
            .forge("factor 1 of the hinge sum", R_S, half(&all.rate.s))
            .forge_terms("v ≠ 0 on ∂Ω", all.on(Tested::Outer, space).terms())
            .vacuous(closed, "there is no boundary")
    }
}

const R_T: &str = "d/dt Σ_T ∫Rvω";
const R_F: &str = "d/dt 2Σ̊_F ∫⟦H⟧vω_F";
const R_S: &str = "d/dt 2Σ̊_S ∫Θvω_S";
const B_T: &str = "Σ_T ∫⟨𝕊σ,∇∇v⟩ω";
const B_F: &str = "−Σ_F ∫𝕊σ(n,n)⟦∇_n v⟧ω_F";
const A_T: &str = "−Σ_T ∫⟨G,σ⟩vω";
const A_F: &str = "−Σ̊_F ∫⟨⟦II‾⟧,σ⟩vω_F";
const A_S: &str = "Σ̊_S ∫Θ Tr(σ|_S)vω_S";

impl Sides {
    /// For these test functions.
    fn on<const N: usize>(&self, tested: Tested, space: &Lagrange<N>) -> Self {
        Self {
            rate: tested.of_sums(space, &self.rate),
            b: tested.of_sums(space, &self.b),
            a: tested.of_sums(space, &self.a),
        }
    }

    fn terms(&self) -> Vec<(&'static str, Vec<f64>)> {
        let (rate, b, a) = (&self.rate, &self.b, &self.a);
        vec![
            (R_T, rate.t.clone()),
            (R_F, rate.f.clone()),
            (R_S, rate.s.clone()),
            (B_T, b.t.clone()),
            (B_F, b.f.clone()),
            (A_T, minus(&a.t)),
            (A_F, minus(&a.f)),
            (A_S, minus(&a.s)),
        ]
    }

    /// The theorem.
    fn equation(&self, dimension: usize, degree: usize) -> Equation<f64> {
        let (flat, surface) = (degree == 0, dimension == 2);
        let mut equation = Equation::new("d/dt⟨(Rω)_dist,v⟩ = b_h − a_h");
        for (name, value) in self.terms() {
            let left = [R_T, R_F, R_S].contains(&name);
            let (vanishes, why) = match name {
                R_T | R_F => (flat, FLAT),
                A_T => (flat || surface, NO_G),
                A_F => (flat || surface, NO_II),
                A_S => (surface, POINTS),
                _ => (false, ""),
            };
            equation = if left {
                equation.left(name, value)
            } else {
                equation.right(name, value)
            };
            equation = equation.vanishes(vanishes, why);
        }
        equation
    }
}

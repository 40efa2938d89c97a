//! The functionals v ↦ f(v) whose H⁻² norms are studied.

use super::Named;
use regge_curvature::field::{Combination, TensorField};
use regge_curvature::functional::{
    Rules, Sums, a_h, b_h, distributional_curvature, smooth_curvature,
};
use regge_curvature::quadrature::{Rule, gauss_legendre};
use regge_curvature::scalar::Lanes;
use regge_curvature::spaces::Lagrange;

/// A functional of g and g_h. With g̃(t) = (1−t) g + t g_h and σ = g_h − g the error is ∫₀¹ b_h − a_h dt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// ⟨(Rω)_dist(g_h), v⟩ − ∫ R(g) v ω(g). Paper: tab:error_N2, tab:error_N3.
    CurvatureError,
    /// ∫₀¹ Σ̊_S ∫ ⟨Θ_S g̃|_S, σ|_S⟩ v ω_S dt. Paper: eq critical_term; zero for N = 2.
    CriticalTerm,
    /// ∫₀¹ b_h(g̃; σ, v) dt.
    BTerm,
    /// ∫₀¹ a_h(g̃; σ, v) dt.
    ATerm,
    /// The cells' part of `a-term`: ∫₀¹ Σ_T ∫ ⟨G, σ⟩ v ω dt.
    EinsteinTerm,
    /// The faces' part of `a-term`: ∫₀¹ Σ̊_F ∫ ⟨⟦II‾⟧, σ|_F⟩ v ω_F dt.
    SecondFormTerm,
}

impl Named for Quantity {
    const KIND: &'static str = "quantity";
    const ALL: &'static [(&'static str, Self)] = &[
        ("curvature-error", Self::CurvatureError),
        ("critical-term", Self::CriticalTerm),
        ("b-term", Self::BTerm),
        ("a-term", Self::ATerm),
        ("einstein-term", Self::EinsteinTerm),
        ("second-form-term", Self::SecondFormTerm),
    ];
}

/// Points of the Gauss rule in t. Paper: "a Gauss quadrature of order seven".
const POINTS_IN_T: usize = 4;

impl Quantity {
    /// f(v) for every v of the space; the smooth metric g is integrated by the same rules as g_h.
    pub fn load<const N: usize, G, H>(
        self,
        g: &G,
        g_h: &H,
        space: &Lagrange<N>,
        rules: &Rules,
    ) -> Vec<f64>
    where
        G: TensorField<Lanes, N>,
        H: TensorField<Lanes, N>,
    {
        match self {
            Self::CurvatureError => {
                let smooth = smooth_curvature::<Lanes, N, G>(g, space, &rules.cells);
                let mut load = distributional_curvature::<Lanes, N, H>(g_h, space, rules).total();
                add(&mut load, -1.0, &smooth);
                load
            }
            Self::BTerm => {
                let b = |g: &_, sigma: &_| b_h(g, sigma, space, rules).total();
                along_segment(g, g_h, space, b)
            }
            _ => {
                let rules = self.rules_of_a(rules);
                let a = |g: &_, sigma: &_| self.part_of_a(a_h(g, sigma, space, &rules));
                along_segment(g, g_h, space, a)
            }
        }
    }

    /// The rules of the sums that are looked at; one point a simplex for the others.
    fn rules_of_a(self, rules: &Rules) -> Rules {
        let [element, face, hinge] = [&rules.cells, &rules.faces, &rules.hinges];
        let chosen = |used: bool, rule: &Rule| match used {
            true => rule.clone(),
            false => Rule::new(rule.points().vertices() - 1, 0),
        };
        Rules {
            cells: chosen(matches!(self, Self::ATerm | Self::EinsteinTerm), element),
            faces: chosen(matches!(self, Self::ATerm | Self::SecondFormTerm), face),
            hinges: chosen(matches!(self, Self::ATerm | Self::CriticalTerm), hinge),
        }
    }

    /// What is looked at; the critical term enters a_h with a minus sign.
    fn part_of_a(self, sums: Sums<f64>) -> Vec<f64> {
        match self {
            Self::EinsteinTerm => sums.cells,
            Self::SecondFormTerm => sums.faces,
            Self::CriticalTerm => sums.hinges.into_iter().map(|x| -x).collect(),
            _ => sums.total(),
        }
    }
}

/// y += α x.
fn add(y: &mut [f64], alpha: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += alpha * x;
    }
}

type Segment<'a, G, H> = Combination<&'a G, &'a H, Lanes>;

/// ∫₀¹ f(g̃(t), σ) dt by Gauss' rule.
fn along_segment<'a, const N: usize, G, H>(
    g: &'a G,
    g_h: &'a H,
    space: &Lagrange<N>,
    f: impl Fn(&Segment<'a, G, H>, &Segment<'a, G, H>) -> Vec<f64>,
) -> Vec<f64>
where
    G: TensorField<Lanes, N>,
    H: TensorField<Lanes, N>,
{
    let one = Lanes::new([1.0; 4]);
    let sigma = Combination::new(-one, g, one, g_h);
    let mut load = vec![0.0; space.len()];
    let (points, weights) = gauss_legendre(POINTS_IN_T);
    for (t, weight) in points.into_iter().zip(weights) {
        let metric = Combination::segment(g, g_h, Lanes::new([t; 4]));
        add(&mut load, weight, &f(&metric, &sigma));
    }
    load
}

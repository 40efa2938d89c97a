//! The functionals v ↦ f(v) whose H⁻² norms are studied.

use super::Named;
use regge::field::{Combination, TensorField};
use regge::functional::{Rules, Sums, a_h, b_h, distributional_curvature, smooth_curvature};
use regge::lagrange::Lagrange;
use regge::quadrature::{Rule, gauss_legendre};
use regge::scalar::Lanes;

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
        space: &Lagrange<'_, N>,
        rules: &Rules,
    ) -> Vec<f64>
    where
        G: TensorField<Lanes, N>,
        H: TensorField<Lanes, N>,
    {
        match self {
            Self::CurvatureError => {
                let smooth = smooth_curvature::<Lanes, N, G>(g, space, &rules.element);
                let mut load = distributional_curvature::<Lanes, N, H>(g_h, space, rules).total();
                add(&mut load, -1.0, &smooth);
                load
            }
            Self::BTerm => along_segment(g, g_h, space, |g, sigma| {
                b_h(g, sigma, space, rules).total()
            }),
            Self::ATerm => along_segment(g, g_h, space, |g, sigma| {
                a_h(g, sigma, space, rules).total()
            }),
            Self::CriticalTerm => {
                let rules = &Rules {
                    hinge: rules.hinge.clone(),
                    ..cheapest::<N>()
                };
                let term = |sums: Sums<f64>| sums.hinge.into_iter().map(|x| -x).collect();
                along_segment(g, g_h, space, |g, sigma| term(a_h(g, sigma, space, rules)))
            }
            Self::EinsteinTerm => {
                let rules = &Rules {
                    element: rules.element.clone(),
                    ..cheapest::<N>()
                };
                along_segment(g, g_h, space, |g, sigma| {
                    a_h(g, sigma, space, rules).element
                })
            }
            Self::SecondFormTerm => {
                let rules = &Rules {
                    face: rules.face.clone(),
                    ..cheapest::<N>()
                };
                along_segment(g, g_h, space, |g, sigma| a_h(g, sigma, space, rules).face)
            }
        }
    }
}

/// One point a simplex, for the sums that are not looked at.
fn cheapest<const N: usize>() -> Rules {
    Rules {
        element: Rule::new(N, 0),
        face: Rule::new(N - 1, 0),
        hinge: Rule::new(N - 2, 0),
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
    space: &Lagrange<'_, N>,
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

//! The functionals v ↦ f(v) whose H⁻² norms are studied.

use crate::named::Named;
use regge_curvature::field::Combination;
use regge_curvature::functional::{
    Rules, Sums, a_h, b_h, distributional_curvature, smooth_curvature,
};
use regge_curvature::metrics::{Metric, Smooth};
use regge_curvature::quadrature::{Rule, gauss_legendre};
use regge_curvature::spaces::{Lagrange, ReggeFunction};

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

/// What a quantity is made of.
struct Record {
    quantity: Quantity,
    /// As reports and the command line write it.
    name: &'static str,
    form: Form,
    /// The sums that are looked at: cells, faces, hinges.
    sums: [bool; 3],
    sign: f64,
}

/// Of which functional a quantity is a part.
#[derive(Clone, Copy)]
enum Form {
    /// The curvature of g_h less that of g.
    Difference,
    /// b_h along the segment from g to g_h.
    B,
    /// a_h along the segment from g to g_h.
    A,
}

const TABLE: [Record; 6] = [
    Record::new(
        Quantity::CurvatureError,
        "curvature-error",
        Form::Difference,
        [true; 3],
        1.0,
    ),
    // It enters a_h with a minus sign.
    Record::new(
        Quantity::CriticalTerm,
        "critical-term",
        Form::A,
        [false, false, true],
        -1.0,
    ),
    Record::new(Quantity::BTerm, "b-term", Form::B, [true; 3], 1.0),
    Record::new(Quantity::ATerm, "a-term", Form::A, [true; 3], 1.0),
    Record::new(
        Quantity::EinsteinTerm,
        "einstein-term",
        Form::A,
        [true, false, false],
        1.0,
    ),
    Record::new(
        Quantity::SecondFormTerm,
        "second-form-term",
        Form::A,
        [false, true, false],
        1.0,
    ),
];

impl Named for Quantity {
    const KIND: &'static str = "quantity";

    fn all() -> Vec<Self> {
        TABLE.iter().map(|record| record.quantity).collect()
    }

    fn name_of(&self) -> &'static str {
        self.record().name
    }
}

/// Points of the Gauss rule in t. Paper: "a Gauss quadrature of order seven".
const POINTS_IN_T: usize = 4;

impl Quantity {
    fn record(self) -> &'static Record {
        const { &TABLE }
            .iter()
            .find(|record| record.quantity == self)
            .expect("every quantity has its line in the table")
    }

    /// f(v) for every v of the space; the smooth metric g is integrated by the same rules as g_h.
    pub fn load<const N: usize>(
        self,
        g: &Smooth<Metric, N>,
        g_h: &ReggeFunction<f64, N>,
        space: &Lagrange<N>,
        rules: &Rules,
    ) -> Vec<f64> {
        let record = self.record();
        let rules = &record.rules(rules);
        match record.form {
            Form::Difference => {
                let smooth = smooth_curvature(g, space, rules);
                let mut load = distributional_curvature(g_h, space, rules).total();
                add(&mut load, -1.0, &smooth);
                load
            }
            Form::A => {
                let a = |g: &Segment<'_, N>, sigma: &_| record.part(a_h(g, sigma, space, rules));
                along_segment(g, g_h, space.len(), &a)
            }
            Form::B => {
                let b = |g: &Segment<'_, N>, sigma: &_| record.part(b_h(g, sigma, space, rules));
                along_segment(g, g_h, space.len(), &b)
            }
        }
    }
}

impl Record {
    const fn new(
        quantity: Quantity,
        name: &'static str,
        form: Form,
        sums: [bool; 3],
        sign: f64,
    ) -> Self {
        Self {
            quantity,
            name,
            form,
            sums,
            sign,
        }
    }

    /// The rules of the sums that are looked at; one point a simplex for the others.
    fn rules(&self, rules: &Rules) -> Rules {
        let chosen = |used: bool, rule: &Rule| match used {
            true => rule.clone(),
            false => Rule::new(rule.points().vertices() - 1, 0),
        };
        Rules::of(
            chosen(self.sums[0], &rules.cells),
            chosen(self.sums[1], &rules.faces),
            chosen(self.sums[2], &rules.hinges),
        )
    }

    /// The sums that are looked at, added up.
    fn part(&self, sums: Sums<f64>) -> Vec<f64> {
        let mut part = vec![0.0; sums.cells.len()];
        for (used, sum) in self.sums.iter().zip([sums.cells, sums.faces, sums.hinges]) {
            if *used {
                add(&mut part, self.sign, &sum);
            }
        }
        part
    }
}

/// y += α x.
fn add(y: &mut [f64], alpha: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += alpha * x;
    }
}

type Segment<'a, const N: usize> =
    Combination<&'a Smooth<Metric, N>, &'a ReggeFunction<f64, N>, f64>;

/// ∫₀¹ f(g̃(t), σ) dt by Gauss' rule, f with so many entries.
fn along_segment<'a, const N: usize>(
    g: &'a Smooth<Metric, N>,
    g_h: &'a ReggeFunction<f64, N>,
    entries: usize,
    f: &dyn Fn(&Segment<'a, N>, &Segment<'a, N>) -> Vec<f64>,
) -> Vec<f64> {
    let sigma = Combination::new(-1.0, g, 1.0, g_h);
    let mut load = vec![0.0; entries];
    let (points, weights) = gauss_legendre(POINTS_IN_T);
    for (t, weight) in points.into_iter().zip(weights) {
        let metric = Combination::segment(g, g_h, t);
        add(&mut load, weight, &f(&metric, &sigma));
    }
    load
}

//! M01, M02: the rates of the sums over faces and hinges, before any integration by parts.

use super::density::{FaceTerms, HingeTerms, Seen, div_div};
use super::fields::{Regge, Three, metric, minus, moving, rates, times, values, variation};
use super::setting::{Draw, OnMesh, ROUNDING, Setting, Shape, grid};
use super::variation::{FLAT, POINTS};
use crate::claim::{Equation, Judgement, Record};
use num_dual::Dual64;
use regge::formulas::Formulas;
use regge::functional::{Rules, a_h_with, distributional_curvature_with, integrate};
use regge::lagrange::Lagrange;
use regge::regge::ReggeSpace;

/// The identities hold at every point: any rule will do.
pub fn pointwise(dimension: usize, quick: bool) -> Vec<Setting> {
    use Shape::{Alfeld, Cube, Sphere, Torus};
    let times = if quick { 1 } else { 4 };
    match dimension {
        2 => grid(&[Alfeld, Cube(2), Torus(3)], &[4, 4, 4], times - times / 4),
        3 => grid(&[Alfeld, Sphere], &[3, 3, 3], times),
        4 => grid(&[Alfeld, Sphere], &[2, 2, 2], if quick { 1 } else { 3 }),
        _ => Vec::new(),
    }
}

/// g, σ, and the rates of the three sums.
pub struct Moving<'s, const N: usize> {
    space: &'s Lagrange<'s, N>,
    rules: Rules,
    g: Regge<'s, f64, N>,
    sigma: Regge<'s, f64, N>,
    /// d/dt of the three sums of ⟨(Rω)_dist(g + tσ), v⟩.
    pub rate: Three,
}

impl<'s, const N: usize> Moving<'s, N> {
    /// A random pair.
    pub fn new<K: Formulas>(
        at: &Setting,
        draw: &mut Draw,
        regge: &'s ReggeSpace<'s, N>,
        space: &'s Lagrange<'s, N>,
    ) -> Self {
        let (g, sigma) = (metric(regge, draw), variation(regge, draw));
        let rules = Rules::new::<N>(at.order);
        let moved = moving(&g, &sigma);
        let rate = rates(&distributional_curvature_with::<K, Dual64, N, _>(
            &moved, space, &rules,
        ));
        Self {
            space,
            rules,
            g,
            sigma,
            rate,
        }
    }

    /// Σ̊_F ∫ ⟦q⟧ v ω_F; with the sign of the second side flipped if it is to be a difference.
    pub fn faces<K: Formulas>(
        &self,
        second: f64,
        q: impl Fn(&FaceTerms) -> f64 + Sync,
    ) -> Vec<f64> {
        let rule = &self.rules.face;
        let (g, sigma) = (
            Seen::<f64, N, _>::new(&self.g, N - 1, rule),
            Seen::<f64, N, _>::new(&self.sigma, N - 1, rule),
        );
        let mesh = self.space.mesh();
        integrate(
            self.space,
            N - 1,
            rule,
            mesh.interior_faces(),
            |face, side, p| {
                let terms =
                    FaceTerms::new::<K, N>(&g.jet2(side, p), &sigma.jet1(side, p), side.place);
                let sign = if mesh.first_side(N - 1, face) == side {
                    1.0
                } else {
                    second
                };
                sign * q(&terms)
            },
        )
    }

    /// Σ̊_S ∫ Σ_F ⟦σ(n,τ)⟧ v ω_S.
    pub fn hinges<K: Formulas>(&self) -> Vec<f64> {
        let rule = &self.rules.hinge;
        let (g, sigma) = (
            Seen::<f64, N, _>::new(&self.g, N - 2, rule),
            Seen::<f64, N, _>::new(&self.sigma, N - 2, rule),
        );
        let hinges = self.space.mesh().interior_hinges();
        integrate(self.space, N - 2, rule, hinges, |_, side, p| {
            HingeTerms::new::<K, N>(&g.value(side, p), &sigma.value(side, p), side.place)
                .normal_conormal
        })
    }

    /// Σ_T ∫ (div div 𝕊σ) v ω.
    pub fn cells<K: Formulas>(&self) -> Vec<f64> {
        let rule = &self.rules.element;
        let (g, sigma) = (
            Seen::<f64, N, _>::new(&self.g, N, rule),
            Seen::<f64, N, _>::new(&self.sigma, N, rule),
        );
        let cells = 0..self.space.mesh().cells();
        integrate(self.space, N, rule, cells, |_, side, p| {
            div_div::<K, N>(&g.jet2(side, p), &sigma.jet2(side, p))
        })
    }

    /// a_h(g; σ, v).
    pub fn a<K: Formulas>(&self) -> Three {
        values(a_h_with::<K, f64, N, _, _>(
            &self.g,
            &self.sigma,
            self.space,
            &self.rules,
        ))
    }
}

/// 2 d/dt Σ̊_F ∫⟦H⟧vω_F.
pub struct M01;

impl OnMesh for M01 {
    const RECORD: Record = Record {
        label: "M01",
        paper: &["Hdot2terms"],
        title: "The rate of the jump of the mean curvature",
        statement: r"2\frac{d}{dt}\int_F [\![H]\!]\,v\,\omega_F = -\int_F [\![\langle\overline{I\!I},\sigma|_F\rangle
            + (\operatorname{div}\mathbb{S}\sigma)(n) + \operatorname{div}_F(\sigma(n,\cdot)) - H\sigma(n,n)]\!]\,v\,\omega_F",
        sides: "Left: H ω_F of g + tσ from both cells, over dual numbers. Right: covariant derivatives of σ and of n at \
            t = 0, from each cell with its own outward normal. The same rule on both sides: no quadrature error.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        pointwise(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let (regge, space) = (
            ReggeSpace::new(&mesh, at.degree),
            Lagrange::new(&mesh, at.test),
        );
        let m = Moving::<N>::new::<K>(at, draw, &regge, &space);
        vec![jump_forgeries::<K, N>(
            jump_terms::<K, N>(&m, at.degree == 0),
            &m,
            at.degree == 0,
        )]
    }
}

const II: &str = "−∫⟦⟨II‾,σ⟩⟧vω_F";
const DIV_S: &str = "−∫⟦(div 𝕊σ)(n)⟧vω_F";
const DIV_F: &str = "−∫⟦div_F(σ(n,·))⟧vω_F";
const RATE: &str = "2 d/dt ∫⟦H⟧vω_F";

fn jump_terms<K: Formulas, const N: usize>(m: &Moving<'_, N>, flat: bool) -> Equation<f64> {
    let jump = |q: fn(&FaceTerms) -> f64| minus(&m.faces::<K>(1.0, q));
    Equation::new("2 d/dt Σ̊_F ∫⟦H⟧vω_F")
        .left(RATE, m.rate.f.clone())
        .vanishes(flat, FLAT)
        .right(II, jump(|q| q.second_form))
        .vanishes(
            flat || N == 2,
            "II‾ = 0 when N = 2, or g is constant on cells",
        )
        .right(DIV_S, jump(|q| q.div_s))
        .vanishes(flat, FLAT)
        .right(DIV_F, jump(|q| q.div_f))
        .vanishes(flat, FLAT)
        .right("∫⟦Hσ(n,n)⟧vω_F", m.faces::<K>(1.0, |q| q.h_nn))
        .vanishes(flat, FLAT)
        .magnitude(m.faces::<K>(1.0, |q| q.s_nn))
}

fn jump_forgeries<K: Formulas, const N: usize>(
    equation: Equation<f64>,
    m: &Moving<'_, N>,
    flat: bool,
) -> Equation<f64> {
    let jump = |q: fn(&FaceTerms) -> f64| minus(&m.faces::<K>(1.0, q));
    let difference = |q: fn(&FaceTerms) -> f64| minus(&m.faces::<K>(-1.0, q));
    let forged = [
        ("II for II‾", II, jump(|q| q.plain_second_form)),
        ("div for div 𝕊", DIV_S, jump(|q| q.div)),
        ("jump as a difference", DIV_S, difference(|q| q.div_s)),
        ("one outward normal flipped", DIV_F, difference(|q| q.div_f)),
        ("the factor 2 dropped", RATE, times(0.5, &m.rate.f)),
    ];
    forged
        .into_iter()
        .fold(equation, |equation, (name, term, value)| {
            equation.forge(name, term, value).vacuous(flat, FLAT)
        })
}

/// ∂_t(Θ_S ω_S).
pub struct M02;

impl OnMesh for M02 {
    const RECORD: Record = Record {
        label: "M02",
        paper: &["lemma:angledefectdot", "angledefectdot"],
        title: "The rate of the angle defect, with the conormal corrected",
        statement: r"\frac{\partial}{\partial t}(\Theta_S\omega_S) = \frac12\Bigl(-\sum_{F\supset S}[\![\sigma(n,\tau)]\!]_F
            + \Theta_S\operatorname{Tr}(\sigma|_S)\Bigr)\omega_S,\quad \tau\text{ pointing from }S\text{ into }F",
        sides: "Left: 2π minus dihedral angles of g + tσ by atan2, times ω_S, over dual numbers. Right: unit normals and \
            conormals at t = 0, and the hinge sum of a_h. The paper prints + for the first sign; that is a forgery here.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        pointwise(dimension, quick)
    }

    fn equations<K: Formulas, const N: usize>(at: &Setting, draw: &mut Draw) -> Vec<Equation<f64>> {
        let mesh = at.shape.mesh::<N>();
        let (regge, space) = (
            ReggeSpace::new(&mesh, at.degree),
            Lagrange::new(&mesh, at.test),
        );
        let m = Moving::<N>::new::<K>(at, draw, &regge, &space);
        let turned = m.hinges::<K>();
        vec![
            Equation::new("2 d/dt Σ̊_S ∫Θvω_S")
                .left("2 d/dt ∫Θvω_S", m.rate.s.clone())
                .right("−∫Σ_F⟦σ(n,τ)⟧vω_S", minus(&turned))
                .right("∫Θ Tr(σ|_S)vω_S", minus(&m.a::<K>().s))
                .vanishes(N == 2, POINTS)
                .forge("the printed sign of τ", "−∫Σ_F⟦σ(n,τ)⟧vω_S", turned)
                .forge(
                    "the factor 2 dropped",
                    "2 d/dt ∫Θvω_S",
                    times(0.5, &m.rate.s),
                ),
        ]
    }
}

//! M01, M02, M03: the rates of the sums over faces and hinges, and of all three, before any integration by parts.

use crate::harness::{Equation, Judgement, Record, Setting, Shape, grid};
use crate::stage::mesh::Where::Interior;
use crate::stage::mesh::{
    Evolution, FLAT, FaceTerms, Moving, NO_G, NO_II, POINTS, ROUNDING, Three, minus, times,
};

/// The identities hold at every point: any rule will do.
fn pointwise(dimension: usize, quick: bool) -> Vec<Setting> {
    use Shape::{Alfeld, Cube, Delaunay, Sphere, Torus};
    let times = if quick { 1 } else { 4 };
    let mut all = match dimension {
        2 => grid(&[Alfeld, Cube(2), Torus(3)], &[4, 4, 4], times - times / 4),
        3 => grid(&[Alfeld, Sphere], &[3, 3, 3], times),
        _ => grid(&[Alfeld, Sphere], &[2, 2, 2], if quick { 1 } else { 3 }),
    };
    if dimension < 4 {
        // Test functions whose Hessians are not constant.
        all.extend([3, 4].map(|test| Setting::new(Alfeld, 1, 4).tested_by(test)));
        // Strongly curved, with large jumps of what may jump.
        all.extend([1, 2].map(|degree| Setting::new(Sphere, degree, 3).wild(6.0)));
    }
    if dimension == 3 {
        // Hinges of other valences than three.
        let shapes = if quick {
            vec![Delaunay(1)]
        } else {
            vec![Delaunay(1), Cube(2)]
        };
        all.extend(grid(&shapes, &[3, 3, 3], 1));
    }
    all
}

/// 2 d/dt Σ̊_F ∫⟦H⟧vω_F.
pub struct M01;

impl Evolution for M01 {
    const RECORD: Record = Record {
        label: "M01",
        paper: &["Hdot2terms"],
        title: "The rate of the jump of the mean curvature",
        statement: r"2\frac{d}{dt}\int_F [\![H]\!]\,v\,\omega_F = -\int_F [\![\langle\overline{I\!I},\sigma|_F\rangle
            + (\operatorname{div}\mathbb{S}\sigma)(n) + \operatorname{div}_F(\sigma(n,\cdot)) - H\sigma(n,n)]\!]\,v\,\omega_F",
        sides: "Left: H ω_F of g + tσ from both cells: Γ and the normal, none of their derivatives. Right: covariant \
            derivatives of σ and of n, from each cell with its own outward normal; of the left side's functions II and H. \
            The same rule on both sides: no quadrature error.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        pointwise(dimension, quick)
    }

    fn equations<const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let flat = at.degree == 0;
        let equation = jump_terms::<N>(m, flat);
        vec![jump_forgeries::<N>(equation, m, flat)]
    }
}

const II: &str = "−∫⟦⟨II‾,σ⟩⟧vω_F";
const DIV_S: &str = "−∫⟦(div 𝕊σ)(n)⟧vω_F";
const DIV_F: &str = "−∫⟦div_F(σ(n,·))⟧vω_F";
const RATE: &str = "2 d/dt ∫⟦H⟧vω_F";

fn jump_terms<const N: usize>(m: &Moving<N>, flat: bool) -> Equation<f64> {
    let jump = |q: fn(&FaceTerms) -> f64| m.at.faces(Interior, q);
    Equation::new("2 d/dt Σ̊_F ∫⟦H⟧vω_F")
        .left(RATE, m.rate.f.clone())
        .vanishes(flat, FLAT)
        .right(II, minus(&jump(|q| q.second_form)))
        .vanishes(flat || N == 2, NO_II)
        .right(DIV_S, minus(&jump(|q| q.div_s)))
        .vanishes(flat, FLAT)
        .right(DIV_F, minus(&jump(|q| q.div_f)))
        .vanishes(flat, FLAT)
        .right("∫⟦Hσ(n,n)⟧vω_F", jump(|q| q.h_nn))
        .vanishes(flat, FLAT)
        .magnitude(jump(|q| q.s_nn))
}

fn jump_forgeries<const N: usize>(
    equation: Equation<f64>,
    m: &Moving<N>,
    flat: bool,
) -> Equation<f64> {
    let jump = |q: fn(&FaceTerms) -> f64| minus(&m.at.faces(Interior, q));
    let difference = |q: fn(&FaceTerms) -> f64| minus(&m.at.differences(q));
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

impl Evolution for M02 {
    const RECORD: Record = Record {
        label: "M02",
        paper: &["lemma:angledefectdot", "angledefectdot"],
        title: "The rate of the angle defect, with the conormal corrected",
        statement: r"\frac{\partial}{\partial t}(\Theta_S\omega_S) = \frac12\Bigl(-\sum_{F\supset S}[\![\sigma(n,\tau)]\!]_F
            + \Theta_S\operatorname{Tr}(\sigma|_S)\Bigr)\omega_S,\quad \tau\text{ pointing from }S\text{ into }F",
        sides: "Left: 2π minus dihedral angles of g + tσ by atan2, times ω_S. Right: unit normals and conormals, and the \
            hinge sum of a_h, where Θ_S enters once more: a wrong Θ_S is caught by D09, D10 and D11. The paper prints + for \
            the first sign; that is a forgery here.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        pointwise(dimension, quick)
    }

    fn equations<const N: usize>(_: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let (rate, turned) = ("2 d/dt ∫Θvω_S", "−∫Σ_F⟦σ(n,τ)⟧vω_S");
        let sum = m.at.turned(Interior);
        vec![
            Equation::new("2 d/dt Σ̊_S ∫Θvω_S")
                .left(rate, m.rate.s.clone())
                .right(turned, minus(&sum))
                .right("∫Θ Tr(σ|_S)vω_S", minus(&m.at.a().s))
                .vanishes(N == 2, POINTS)
                .forge("the printed sign of τ", turned, sum)
                .forge("the factor 2 dropped", rate, times(0.5, &m.rate.s)),
        ]
    }
}

/// The six-term formula.
pub struct M03;

impl Evolution for M03 {
    const RECORD: Record = Record {
        label: "M03",
        paper: &["distcurvdot0", "intcurvdot"],
        title: "The rate of the distributional curvature, before integrating by parts",
        statement: r"\frac{d}{dt}\langle (R\omega)_{\rm dist}(g(t)),v\rangle = \sum_T\int_T(\operatorname{div}\operatorname{div}
            \mathbb{S}\sigma)v\omega - \mathring{\sum_F}\int_F[\![(\operatorname{div}\mathbb{S}\sigma)(n) +
            \operatorname{div}_F(\sigma(n,\cdot)) - H\sigma(n,n)]\!]v\omega_F - \mathring{\sum_S}\int_S\sum_{F\supset S}
            [\![\sigma(n,\tau)]\!]_F v\omega_S - a_h(g;\sigma,v)",
        sides: "Left: the functional of g + tσ. Right: covariant derivatives of σ, normals and conormals, and a_h. Both use R, \
            H and Θ: in the last terms they stand without a derivative. The same rule on both sides: no quadrature error. \
            The sign of the third sum is corrected.",
    };
    const JUDGEMENT: Judgement = ROUNDING;

    fn settings(dimension: usize, quick: bool) -> Vec<Setting> {
        pointwise(dimension, quick)
    }

    fn equations<const N: usize>(at: &Setting, m: &Moving<N>) -> Vec<Equation<f64>> {
        let (a, cells) = (m.at.a(), m.at.div_div());
        let turned = m.at.turned(Interior);
        let on_cells = Equation::new("on cells")
            .left("d/dt ∫Rvω", m.rate.t.clone())
            .vanishes(at.degree == 0, FLAT)
            .right("∫(div div 𝕊σ)vω", cells.clone())
            .vanishes(at.degree == 0, FLAT)
            .right("−∫⟨G,σ⟩vω", minus(&a.t))
            .vanishes(at.degree == 0 || N == 2, NO_G)
            .magnitude(turned.clone());
        let flux = minus(&m.at.faces(Interior, FaceTerms::flux));
        let right = [cells, flux, minus(&turned)];
        let whole = six_terms(&m.rate, right, &a, (at.degree == 0, N == 2));
        vec![
            on_cells,
            whole.forge("the printed sign of τ", TURNED, turned),
        ]
    }
}

const TURNED: &str = "−Σ̊_S ∫Σ_F⟦σ(n,τ)⟧vω_S";

fn six_terms(
    rate: &Three,
    [cells, flux, turned]: [Vec<f64>; 3],
    a: &Three,
    (flat, surface): (bool, bool),
) -> Equation<f64> {
    let sums = rate.t.iter().zip(&rate.f).zip(&rate.s);
    let all: Vec<f64> = sums.map(|((t, f), s)| t + f + s).collect();
    Equation::new("all")
        .left("d/dt⟨(Rω)_dist,v⟩", all)
        .right("Σ_T ∫(div div 𝕊σ)vω", cells)
        .vanishes(flat, FLAT)
        .right("−Σ̊_F ∫⟦(div 𝕊σ)(n) + div_F(σ(n,·)) − Hσ(n,n)⟧vω_F", flux)
        .vanishes(flat, FLAT)
        .right(TURNED, turned)
        .right("−Σ_T ∫⟨G,σ⟩vω", minus(&a.t))
        .vanishes(flat || surface, NO_G)
        .right("−Σ̊_F ∫⟨⟦II‾⟧,σ⟩vω_F", minus(&a.f))
        .vanishes(flat || surface, NO_II)
        .right("Σ̊_S ∫Θ Tr(σ|_S)vω_S", minus(&a.s))
        .vanishes(surface, POINTS)
}
